// How far a picture is from a reference, in false colours: comparison.cpp's, on a scale of its own.
uniform sampler2D radiance_texture;
uniform sampler2D reference_texture;
uniform float floor_radiance;  // differences are relative to the reference, or to this where that is less
uniform float blue_at;         // logarithm to the base 10 of the difference that is blue
uniform float decades;         // from a colour to the next

layout(location = 0) out vec4 color;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 reference = texelFetch(reference_texture, pixel, 0).xyz;
    vec3 apart = abs(texelFetch(radiance_texture, pixel, 0).xyz - reference) / max(reference, vec3(floor_radiance));
    float worst = max(apart.x, max(apart.y, apart.z));
    vec3 stops[5] =
        vec3[5](vec3(0.0), vec3(0.0, 0.0, 1.0), vec3(0.0, 1.0, 0.0), vec3(1.0, 0.0, 0.0), vec3(1.0));
    float place = clamp((log(max(worst, 1e-30)) / log(10.0) - blue_at) / decades + 1.0, 0.0, 4.0);
    int stop = min(int(place), 3);
    color = vec4(mix(stops[stop], stops[stop + 1], place - float(stop)), 1.0);
    // No number at all is as wrong as can be.
    if (isnan(worst) || isinf(worst)) {
        color = vec4(1.0, 0.0, 1.0, 1.0);
    }
}
