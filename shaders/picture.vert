#version 330 core
// A rectangle of the target, in clip space, with its texture coordinates.
uniform vec4 rectangle;   // left, top, right, bottom as fractions of the target
uniform vec4 source;      // the same of the texture
out vec2 place;

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  place = mix(source.xy, source.zw, corner);
  gl_Position = vec4(mix(rectangle.xy, rectangle.zw, corner) * 2.0 - 1.0, 0.0, 1.0);
}
