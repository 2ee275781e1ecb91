// What the cascaded shadow maps say.
#include "cascades.glsl"

uniform sampler2DArrayShadow shadow_maps;

// The finest cascade that covers the point with `margin` of its width around it, or 4.
int cascade_at(vec3 position, float margin) {
    for (int i = 0; i < 4; ++i) {
        vec2 place = in_cascade(i, position).xy;
        if (all(lessThan(abs(place - 0.5), vec2(0.5 - margin)))) {
            return i;
        }
    }
    return 4;
}

// The share of sunlight that reaches a place in the air, relative to the camera: one look, filtered by the
// hardware.
float sun_reaches(vec3 position) {
    int i = cascade_at(position, 0.002);
    if (i == 4) {
        return 1.0;
    }
    vec3 place = in_cascade(i, position);
    return texture(shadow_maps, vec4(place.xy, float(i), clamp(place.z, 0.0, 1.0)));
}

// The share of sunlight that reaches a surface: the mean over 3 x 3 texels, each look filtered by the hardware,
// from a point raised off the surface so that it does not shade itself.
float sun_reaches_surface(vec3 position, vec3 normal, vec3 to_sun) {
    int i = cascade_at(position, 0.01);
    if (i == 4) {
        return 1.0;
    }
    float texel = cascades[i].texel.x;
    float slope = sqrt(max(1.0 - dot(normal, to_sun) * dot(normal, to_sun), 0.0));
    vec3 place = in_cascade(i, position + normal * (texel * (0.5 + 1.5 * slope)));
    vec2 step = 1.0 / vec2(textureSize(shadow_maps, 0).xy);
    float sum = 0.0;
    for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) {
            vec2 at = place.xy + vec2(x, y) * step;
            sum += texture(shadow_maps, vec4(at, float(i), clamp(place.z, 0.0, 1.0)));
        }
    }
    return sum / 9.0;
}
