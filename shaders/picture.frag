#version 330 core
// A picture or layer over the target, or a vertical gradient where there is none.
in vec2 place;
uniform sampler2D picture;
uniform float opacity;
uniform bool is_gradient;
uniform vec3 gradient_top;
uniform vec3 gradient_bottom;
layout(location = 0) out vec4 pixel;

void main() {
  if (is_gradient) {
    pixel = vec4(mix(gradient_top, gradient_bottom, place.y), 1.0);
    // Half a step of noise keeps dark gradients from banding.
    float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    pixel.rgb += (noise - 0.5) / 255.0;
  } else {
    pixel = texture(picture, place) * opacity;
  }
}
