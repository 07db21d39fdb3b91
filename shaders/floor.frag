#version 330 core
in vec2 world;
in vec2 local;
flat in vec4 shape;

uniform vec2 centre;
uniform float spacing;
uniform float half_extent;
uniform vec4 line;
uniform bool is_shadow;
layout(location = 0) out vec4 pixel;

// Lines one pixel wide at any distance; where they would crowd together they fade into an even tone.
float grid(vec2 at, float step_m) {
  vec2 cell = at / step_m;
  vec2 width = max(fwidth(cell), 1e-5);
  vec2 distance_px = abs(fract(cell - 0.5) - 0.5) / width;
  vec2 cover = clamp(1.2 - distance_px, 0.0, 1.0) * clamp(0.5 / width, 0.0, 1.0);
  return max(cover.x, cover.y);
}

void main() {
  if (is_shadow) {
    vec2 d = abs(local) - (shape.xy - shape.w);
    float outside = length(max(d, 0.0)) / shape.w;
    float fall = clamp(1.0 - outside, 0.0, 1.0);
    pixel = vec4(0.0, 0.0, 0.0, shape.z * fall * fall);
    return;
  }
  vec2 at = world - centre;
  float fade = 1.0 - smoothstep(0.35, 1.0, length(at) / half_extent);
  float strength = max(grid(at, spacing) * 0.55, grid(at, spacing * 4.0));
  float alpha = line.a * strength * fade;
  pixel = vec4(line.rgb * alpha, alpha);
}
