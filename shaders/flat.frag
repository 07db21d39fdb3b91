#version 330 core
in vec2 local;
in vec2 texel;
flat in vec4 shape;
flat in vec4 fill;
flat in vec4 edge;
flat in vec2 kind;

uniform sampler2D atlas;
layout(location = 0) out vec4 pixel;

void main() {
  if (kind.x > 0.5) {
    float cover = texelFetch(atlas, ivec2(floor(texel)), 0).r;
    pixel = vec4(fill.rgb, 1.0) * (fill.a * cover);
    return;
  }
  float radius = min(shape.z, min(shape.x, shape.y));
  vec2 d = abs(local) - (shape.xy - radius);
  float outside = length(max(d, 0.0)) + min(max(d.x, d.y), 0.0) - radius;   // signed distance in px
  float cover = kind.y > 0.0 ? 1.0 - smoothstep(-kind.y, kind.y, outside) : clamp(0.5 - outside, 0.0, 1.0);
  float inner = shape.w > 0.0 ? clamp(0.5 - outside - shape.w, 0.0, 1.0) : 1.0;
  vec4 inside = vec4(fill.rgb, 1.0) * fill.a;
  vec4 border = vec4(edge.rgb, 1.0) * edge.a;
  pixel = (shape.w > 0.0 ? mix(border + inside * (1.0 - border.a), inside, inner) : inside) * cover;
}
