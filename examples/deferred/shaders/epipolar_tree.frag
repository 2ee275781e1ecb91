// The next level of a tree of least and greatest heights: each of its texels stands for two of the level before.
// All levels lie side by side in one texture, the finest first.
uniform sampler2D tree_texture;
uniform int from_begin;  // first texel of the level before
uniform int begin;       // and of this one

layout(location = 0) out vec2 heights;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    ivec2 first = ivec2(from_begin + 2 * (texel.x - begin), texel.y);
    vec2 a = texelFetch(tree_texture, first, 0).xy;
    vec2 b = texelFetch(tree_texture, first + ivec2(1, 0), 0).xy;
    heights = vec2(min(a.x, b.x), max(a.y, b.y));
}
