// Radiance to the bytes of a display, last of all.
#include "airlight/color.glsl"

#include "bloom.glsl"
#include "interleaved.glsl"

uniform sampler2D radiance_texture;
uniform sampler2D shares_texture;
uniform sampler2D glow_texture;   // at half the size
uniform sampler2D flare_texture;  // at half the size, read between its texels
uniform float glow_share;
uniform bool any_flare;
uniform float exposure;
uniform bool use_exposure;
uniform bool use_gamma;
uniform bool cascade_colors;

layout(location = 0) out vec4 encoded;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 radiance = texelFetch(radiance_texture, pixel, 0).xyz;
    if (glow_share > 0.0) {
        // What spreads is taken away from where it came from.
        radiance += glow_share * (brought_up(glow_texture, pixel) - bounded(radiance));
    }
    if (any_flare) {
        vec2 half_size = vec2(textureSize(flare_texture, 0));
        radiance += textureLod(flare_texture, 0.5 * gl_FragCoord.xy / half_size, 0.0).xyz;
    }
    vec3 light = use_exposure ? airlight_exposed(radiance, exposure) : min(radiance * exposure, 1.0);
    if (cascade_colors) {
        int cascade = int(texelFetch(shares_texture, pixel, 0).z);
        vec3 colors[5] =
            vec3[5](vec3(1.0, 0.2, 0.2), vec3(0.2, 1.0, 0.2), vec3(0.3, 0.4, 1.0), vec3(1.0, 0.9, 0.2), vec3(1.0));
        light *= colors[clamp(cascade, 0, 4)];
    }
    vec3 code = use_gamma ? airlight_srgb_from_linear(light) : light;
    // Less than a step of the display, so that slow gradients have no edges.
    encoded = vec4(code + (interleaved(pixel) - 0.5) / 255.0, 1.0);
}
