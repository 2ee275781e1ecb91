// One triangle that covers the screen. Nothing of it is nearer than the far end of reversed depth, 0; a
// fragment shader that draws surfaces writes gl_FragDepth.
void main() {
    vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));
    gl_Position = vec4(4.0 * corner - 1.0, 0.0, 1.0);
}
