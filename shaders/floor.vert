#version 330 core
// Quads on the floor: the grid itself, and soft shadows.
layout(location = 0) in vec2 corner;        // -1 to 1
layout(location = 1) in vec4 centre_half;   // world x, z; half size along and across
layout(location = 2) in vec4 look;          // direction x, z; strength; corner radius

uniform mat4 camera_from_world;
uniform vec4 projection;
uniform vec2 depth_range;
uniform float height;

out vec2 world;
out vec2 local;
flat out vec4 shape;   // half sizes, strength, corner radius

void main() {
  vec2 along = look.xy;
  vec2 across = vec2(-look.y, look.x);
  local = corner * centre_half.zw;
  world = centre_half.xy + along * local.x + across * local.y;
  shape = vec4(centre_half.zw, look.zw);
  vec3 position = (camera_from_world * vec4(world.x, height, world.y, 1.0)).xyz;
  gl_Position = vec4(projection.x * position.x + projection.z * position.z,
                     projection.y * position.y + projection.w * position.z,
                     depth_range.x * position.z + depth_range.y, position.z);
}
