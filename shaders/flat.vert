#version 330 core
// Rounded boxes and glyphs, in pixels of the target.
layout(location = 0) in vec4 centre_half;
layout(location = 1) in vec4 direction_look;   // direction, corner radius, border
layout(location = 2) in vec4 fill_colour;
layout(location = 3) in vec4 border_colour;
layout(location = 4) in vec4 glyph;            // left, top, right, bottom in the atlas, texels; empty for a box
layout(location = 5) in float softness;

uniform vec2 target_px;

out vec2 local;
out vec2 texel;
flat out vec4 shape;     // half size, corner radius, border
flat out vec4 fill;
flat out vec4 edge;
flat out vec2 kind;      // is a glyph, softness

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  bool is_glyph = glyph.z > glyph.x;
  vec2 reach = centre_half.zw + (is_glyph ? 0.0 : 1.0 + softness);   // room for the soft edge
  local = corner * reach;
  vec2 along = direction_look.xy;
  vec2 position = centre_half.xy + along * local.x + vec2(-along.y, along.x) * local.y;
  texel = mix(glyph.xy, glyph.zw, corner * 0.5 + 0.5);
  shape = vec4(centre_half.zw, direction_look.zw);
  fill = fill_colour;
  edge = border_colour;
  kind = vec2(is_glyph ? 1.0 : 0.0, softness);
  gl_Position = vec4(position / target_px * 2.0 - 1.0, 0.0, 1.0);
}
