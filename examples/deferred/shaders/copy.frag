// What the air's pass reads, to what it writes: the least that such a pass can cost.
uniform sampler2D depth_texture;
uniform sampler2D behind_texture;

layout(location = 0) out vec4 radiance;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    radiance = texelFetch(depth_texture, pixel, 0).x + texelFetch(behind_texture, pixel, 0);
}
