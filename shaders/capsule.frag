#version 330 core
in vec3 position_camera;
in vec3 normal_camera;
in float along_m;
flat in vec3 linear_colour;

uniform vec3 up_camera;       // the world's up
uniform vec4 outline;         // premultiplied; drawn flat where alpha is not negative
uniform float band_m;         // length of a pair of bands; 0 for none

layout(location = 0) out vec4 pixel;

void main() {
  if (outline.a >= 0.0) {
    pixel = outline;
    return;
  }
  vec3 n = normalize(normal_camera);
  vec3 to_eye = normalize(-position_camera);
  const vec3 key = vec3(-0.42, -0.74, -0.53);   // over the camera's left shoulder
  float lambert = dot(n, key) * 0.5 + 0.5;
  float sky = dot(n, up_camera) * 0.5 + 0.5;
  float facing = clamp(dot(n, to_eye), 0.0, 1.0);
  vec3 base = linear_colour;
  if (band_m > 0.0 && along_m >= 0.0) {
    float phase = along_m / band_m;
    float wave = abs(fract(phase) - 0.5) * 2.0;
    float soft = max(fwidth(phase) * 2.0, 1e-3);
    base *= mix(0.22, 1.0, smoothstep(0.5 - soft, 0.5 + soft, wave));
  }
  vec3 light = base * (0.20 + 0.30 * sky + 0.72 * lambert * lambert);
  light *= mix(0.52, 1.0, smoothstep(0.0, 0.55, facing));   // a darker edge parts a limb from what is behind it
  float shine = pow(clamp(dot(n, normalize(key + to_eye)), 0.0, 1.0), 38.0);
  light += vec3(0.16 * shine);
  pixel = vec4(pow(light, vec3(1.0 / 2.2)), 1.0);
}
