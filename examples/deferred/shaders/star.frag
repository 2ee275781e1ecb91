// A star's light on the four pixels around it, so that it keeps its brightness where it moves.
flat in vec3 star_light;
flat in vec2 middle;

layout(location = 0) out vec4 out_albedo;
layout(location = 1) out vec4 out_normal;

void main() {
    vec2 share = max(1.0 - abs(gl_FragCoord.xy - middle), 0.0);
    out_albedo = vec4(share.x * share.y * star_light, 0.0);
    out_normal = vec4(0.0);
    gl_FragDepth = 0.0;
}
