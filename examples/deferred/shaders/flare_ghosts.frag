// What a lens mirrors twice within itself: smaller and larger images of the bright parts on the line through the
// picture's middle, and a ring around it. Colours part as in glass, which bends blue more than red.

uniform sampler2D bright_texture;

uniform float heights;  // of the picture in a pixel of this pass
uniform float shape;    // of the picture, width over height

layout(location = 0) out vec4 flare;

// The place in the picture that a ghost shows, over the ghost's own, both from the middle; then the share of its
// light that two coatings mirror, by colour.
const int ghosts = 6;
const vec4 ghost[ghosts] =
    vec4[ghosts](vec4(-0.55, 3e-5, 5e-5, 8e-5), vec4(-0.9, 8e-5, 6e-5, 3e-5), vec4(-1.6, 6e-5, 12e-5, 8e-5),
            vec4(-3.2, 20e-5, 15e-5, 22e-5), vec4(2.4, 6e-5, 10e-5, 12e-5), vec4(4.5, 22e-5, 18e-5, 10e-5));
const float parting = 0.03;      // of red and of blue from green, of the place's distance from the middle
const float ring_radius = 0.42;  // of the picture's height
const float ring_share = 1e-5;

// Nothing comes from outside the picture, and little from its edge, so that none appears at once.
vec3 light_from(vec2 from_middle) {
    vec2 place = 0.5 + vec2(from_middle.x / shape, from_middle.y);
    vec2 inside = clamp(min(place, 1.0 - place) / 0.05, 0.0, 1.0);
    return inside.x * inside.y * textureLod(bright_texture, place, 0.0).xyz;
}

vec3 parted(vec2 place, float by) {
    return vec3(light_from(place * (1.0 - by)).x, light_from(place).y, light_from(place * (1.0 + by)).z);
}

void main() {
    // In heights of the picture.
    vec2 here = gl_FragCoord.xy * heights - 0.5 * vec2(shape, 1.0);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < ghosts; ++i) {
        sum += ghost[i].yzw * parted(here * ghost[i].x, parting);
    }
    float distance = length(here);
    if (distance > 0.0) {
        vec2 ring = here - here / distance * ring_radius;
        sum += ring_share * parted(ring, parting);
    }
    flare = vec4(sum, 1.0);
}
