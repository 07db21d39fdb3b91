#version 330 core
// A tapered capsule from a grid of directions. All positions are in camera space: +X right, +Y down, +Z forward.
layout(location = 0) in vec2 around;      // cosine and sine about the axis
layout(location = 1) in vec2 cap;         // which end (0, 1); where on it, from pole (0) to seam (1)
layout(location = 2) in vec4 from;        // position, radius
layout(location = 3) in vec4 to;
layout(location = 4) in vec3 colour;      // linear light

uniform vec4 projection;                  // scale x, y, offset x, y of image-ordered clip space
uniform vec2 depth_range;                 // clip z = x * z + y
uniform float metres_per_px;              // of the outline, at a distance of one metre; 0 for the body itself

out vec3 position_camera;
out vec3 normal_camera;
out float along_m;
flat out vec3 linear_colour;

void main() {
  vec3 axis = to.xyz - from.xyz;
  float len = length(axis);
  // Steeper than its own taper it would be a sphere inside another.
  bool is_sphere = len <= abs(from.w - to.w) + 1e-6;
  vec3 w = is_sphere ? vec3(0.0, 0.0, 1.0) : axis / len;
  vec3 helper = abs(w.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
  vec3 u = normalize(cross(helper, w));
  vec3 v = cross(w, u);
  // Where both end spheres touch their common cone.
  float seam = is_sphere ? 0.0 : asin(clamp((from.w - to.w) / len, -1.0, 1.0));
  float angle = cap.x < 0.5 ? mix(-1.57079633, seam, cap.y) : mix(1.57079633, seam, cap.y);
  vec3 normal = cos(angle) * (around.x * u + around.y * v) + sin(angle) * w;
  vec4 end = cap.x < 0.5 ? from : to;
  if (is_sphere) end = from.w >= to.w ? from : to;
  float radius = end.w + metres_per_px * max(end.z, 0.01);
  vec3 position = end.xyz + radius * normal;
  position_camera = position;
  normal_camera = normal;
  along_m = is_sphere ? -1.0 : dot(position - from.xyz, w);
  linear_colour = colour;
  gl_Position = vec4(projection.x * position.x + projection.z * position.z,
                     projection.y * position.y + projection.w * position.z,
                     depth_range.x * position.z + depth_range.y, position.z);
  // The outline lies behind everything, so that each of its pixels is drawn once and none under the body.
  if (metres_per_px > 0.0) gl_Position.z = 0.99999 * gl_Position.w;
}
