#include "ui/render/gl/floor_pass.h"

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>
#include <vector>

#include "core/base/embedded.h"

namespace posecoach::gl {
namespace {

POSECOACH_EMBEDDED(shader_floor_vert)
POSECOACH_EMBEDDED(shader_floor_frag)

struct Instance {
  float centre_half[4];
  float look[4];
};

// How far a shadow's edge spreads, and how fast it fades with the height of what casts it.
constexpr double kBlur_m = 0.07;
constexpr double kFadeHeight_m = 0.22;
constexpr double kStrength = 0.34;

float f(double value) {
  return static_cast<float>(value);
}

void add_shadows(const Figure& figure, double floor_height, std::vector<Instance>& to) {
  for (const Capsule& capsule : figure.capsules) {
    const double height = std::max(0.0, 0.5 * (capsule.from.y + capsule.to.y) - floor_height);
    const double strength = kStrength * figure.opacity * std::exp(-height / kFadeHeight_m);
    if (strength < 0.004) continue;
    const Vec2 from(capsule.from.x, capsule.from.z), end(capsule.to.x, capsule.to.z);
    const Vec2 centre = 0.5 * (from + end), axis = end - from;
    const double length = glm::length(axis);
    const Vec2 direction = length > 1e-6 ? axis / length : Vec2(1, 0);
    const double radius = std::max(capsule.from_radius_m, capsule.to_radius_m) + kBlur_m + 0.25 * height;
    to.push_back({{f(centre.x), f(centre.y), f(0.5 * length + radius), f(radius)},
                  {f(direction.x), f(direction.y), f(strength), f(radius)}});
  }
}

}  // namespace

Result<FloorPass> FloorPass::make() {
  Result<Program> program = Program::make("floor", shader_floor_vert(), shader_floor_frag());
  if (!program) return tl::unexpected(program.error());
  return FloorPass(std::move(*program));
}

FloorPass::FloorPass(Program program)
    : program_(std::move(program)),
      corners_(make_buffer()),
      instances_(make_buffer()),
      array_(make_vertex_array()) {
  constexpr float kCorners[] = {-1, -1, 1, -1, -1, 1, 1, 1};
  glBindVertexArray(array_.id());
  upload(corners_, std::as_bytes(std::span(kCorners)));
  const Attribute corner[] = {{0, 2, 0}};
  describe(corners_, 2 * sizeof(float), corner, 0);
  const Attribute instance[] = {{1, 4, offsetof(Instance, centre_half)}, {2, 4, offsetof(Instance, look)}};
  describe(instances_, sizeof(Instance), instance, 1);
  glBindVertexArray(0);
}

void FloorPass::draw(const Floor& floor, std::span<const Figure> figures, const View& view) {
  std::vector<Instance> instances;
  instances.push_back({{f(floor.centre.x), f(floor.centre.z), f(floor.half_extent_m), f(floor.half_extent_m)},
                       {1, 0, 0, 0.1F}});
  if (floor.shadows)
    for (const Figure& figure : figures) add_shadows(figure, floor.centre.y, instances);
  upload(instances_, std::as_bytes(std::span(instances)));

  glm::mat4 camera_from_world(glm::mat3(view.camera.rotation_camera_from_world));
  camera_from_world[3] = glm::vec4(glm::vec3(view.camera.translation_camera_from_world), 1);
  program_.use();
  glUniformMatrix4fv(program_.uniform("camera_from_world"), 1, GL_FALSE, glm::value_ptr(camera_from_world));
  glUniform4fv(program_.uniform("projection"), 1, view.projection().data());
  glUniform2fv(program_.uniform("depth_range"), 1, View::depth_range().data());
  glUniform1f(program_.uniform("height"), f(floor.centre.y));
  glUniform2f(program_.uniform("centre"), f(floor.centre.x), f(floor.centre.z));
  glUniform1f(program_.uniform("spacing"), f(floor.spacing_m));
  glUniform1f(program_.uniform("half_extent"), f(floor.half_extent_m));
  glUniform4f(program_.uniform("line"), floor.line.red, floor.line.green, floor.line.blue, floor.line.alpha);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glBindVertexArray(array_.id());
  glUniform1i(program_.uniform("is_shadow"), 0);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, 1);
  if (instances.size() > 1) {
    glUniform1i(program_.uniform("is_shadow"), 1);
    // The grid is the first instance; drawn as a shadow it has no strength.
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(instances.size()));
  }
  glBindVertexArray(0);
}

}  // namespace posecoach::gl
