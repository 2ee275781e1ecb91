// Radiance to the bytes of a display, last of all.
#include "airlight/color.glsl"

uniform sampler2D radiance_texture;
uniform float exposure;

layout(location = 0) out vec4 encoded;

void main() {
    vec3 radiance = texelFetch(radiance_texture, ivec2(gl_FragCoord.xy), 0).xyz;
    encoded = vec4(airlight_srgb_from_linear(airlight_exposed(radiance, exposure)), 1.0);
}
