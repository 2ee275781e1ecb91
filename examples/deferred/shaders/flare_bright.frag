// The bright parts of a picture, each as the image of a six-sided aperture: the mean over a hexagon.

uniform sampler2D radiance_texture;
uniform float radius;  // of the aperture's image, in texels

layout(location = 0) out vec4 bright;

const int rings = 4;

// More than any lit ground, cloud or sky has, by unit solar irradiance [1/sr]: the sun and its mirror images.
const float threshold = 10.0;

void main() {
    vec2 size = vec2(textureSize(radiance_texture, 0));
    vec3 sum = vec3(0.0);
    for (int b = -rings; b <= rings; ++b) {
        for (int a = max(-rings, -rings - b); a <= min(rings, rings - b); ++a) {
            // A grid of equal triangles.
            vec2 step = vec2(float(a) + 0.5 * float(b), 0.8660254 * float(b)) * (radius / float(rings));
            vec2 place = (gl_FragCoord.xy + step) / size;
            if (place == clamp(place, 0.0, 1.0)) {
                sum += max(textureLod(radiance_texture, place, 0.0).xyz - threshold, 0.0);
            }
        }
    }
    bright = vec4(sum / float(1 + 3 * rings * (rings + 1)), 1.0);
}
