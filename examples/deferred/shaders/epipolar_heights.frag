// For each slice and column: how high, along the sunlight and from the eye, the landscape shades the air.
#include "frame.glsl"
#include "shadows_nearest.glsl"
#include "epipolar.glsl"

layout(location = 0) out vec2 heights;  // the least and the greatest of the column, here the same [m]

void main() {
    float middle = 0.5 * (column_begin(gl_FragCoord.x - 0.5) + column_begin(gl_FragCoord.x + 0.5));
    heights = vec2(shaded_height(slice_direction(gl_FragCoord.y - 0.5) * middle));
}
