// Radiance to the bytes of a display, last of all.
#include "airlight/color.glsl"

uniform sampler2D radiance_texture;
uniform sampler2D shares_texture;
uniform float exposure;
uniform bool use_exposure;
uniform bool use_gamma;
uniform bool cascade_colors;

layout(location = 0) out vec4 encoded;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 radiance = texelFetch(radiance_texture, pixel, 0).xyz;
    vec3 light = use_exposure ? airlight_exposed(radiance, exposure) : min(radiance * exposure, 1.0);
    if (cascade_colors) {
        int cascade = int(texelFetch(shares_texture, pixel, 0).z);
        vec3 colors[5] =
            vec3[5](vec3(1.0, 0.2, 0.2), vec3(0.2, 1.0, 0.2), vec3(0.3, 0.4, 1.0), vec3(1.0, 0.9, 0.2), vec3(1.0));
        light *= colors[clamp(cascade, 0, 4)];
    }
    encoded = vec4(use_gamma ? airlight_srgb_from_linear(light) : light, 1.0);
}
