#include "ui/render/gl/capsule_pass.h"

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <vector>

#include "core/base/embedded.h"

namespace posecoach::gl {
namespace {

POSECOACH_EMBEDDED(shader_capsule_vert)
POSECOACH_EMBEDDED(shader_capsule_frag)

struct Vertex {
  float around[2];
  float cap[2];
};
struct Instance {
  float from[4];
  float to[4];
  float colour[3];
};

constexpr float kBandPair_m = 0.075F;

float linear_from_srgb(float value) {
  return std::pow(value, 2.2F);
}

Instance instance_of(const Capsule& capsule, const View& view) {
  const Vec3 from = view.camera.camera_from_world(capsule.from);
  const Vec3 to = view.camera.camera_from_world(capsule.to);
  const auto f = [](double value) { return static_cast<float>(value); };
  return {{f(from.x), f(from.y), f(from.z), f(capsule.from_radius_m)},
          {f(to.x), f(to.y), f(to.z), f(capsule.to_radius_m)},
          {linear_from_srgb(capsule.colour.red), linear_from_srgb(capsule.colour.green),
           linear_from_srgb(capsule.colour.blue)}};
}

// How finely a capsule is cut follows from its size on the screen: small triangles are what costs.
std::size_t mesh_for(const Instance& instance, double focal_px) {
  const auto radius_px = [&](const float* end) {
    return static_cast<double>(end[3]) * focal_px / std::max(static_cast<double>(end[2]), kNear_m);
  };
  const double radius = std::max(radius_px(instance.from), radius_px(instance.to));
  return radius < 7 ? 0 : radius < 18 ? 1 : radius < 50 ? 2 : 3;
}

}  // namespace

Result<CapsulePass> CapsulePass::make() {
  Result<Program> program = Program::make("capsule", shader_capsule_vert(), shader_capsule_frag());
  if (!program) return tl::unexpected(program.error());
  return CapsulePass(std::move(*program));
}

CapsulePass::CapsulePass(Program program)
    : program_(std::move(program)),
      instances_(make_buffer()),
      meshes_{make_mesh(10, 3), make_mesh(16, 5), make_mesh(26, 8), make_mesh(48, 16)} {}

CapsulePass::Mesh CapsulePass::make_mesh(int segments, int rings) {
  std::vector<Vertex> vertices;
  for (int ring = 0; ring < 2 * rings; ++ring) {
    const bool far_end = ring >= rings;
    const float from_pole =
        static_cast<float>(far_end ? 2 * rings - 1 - ring : ring) / static_cast<float>(rings - 1);
    for (int segment = 0; segment < segments; ++segment) {
      const double angle = 2 * kPi * segment / segments;
      vertices.push_back({{static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))},
                          {far_end ? 1.0F : 0.0F, from_pole}});
    }
  }
  std::vector<std::uint16_t> indices;
  for (int ring = 0; ring + 1 < 2 * rings; ++ring)
    for (int segment = 0; segment < segments; ++segment) {
      const int a = ring * segments + segment, b = ring * segments + (segment + 1) % segments;
      for (const int i : {a, b, a + segments, b, b + segments, a + segments})
        indices.push_back(static_cast<std::uint16_t>(i));
    }
  Mesh mesh{make_buffer(), make_vertex_array(), static_cast<int>(indices.size()), make_buffer()};
  glBindVertexArray(mesh.array.id());
  upload(mesh.vertices, std::as_bytes(std::span(vertices)));
  const Attribute vertex[] = {{0, 2, offsetof(Vertex, around)}, {1, 2, offsetof(Vertex, cap)}};
  describe(mesh.vertices, sizeof(Vertex), vertex, 0);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh.index_buffer.id());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint16_t)),
               indices.data(), GL_STATIC_DRAW);
  glBindVertexArray(0);
  return mesh;
}

void CapsulePass::draw_meshes() const {
  const Attribute instance[] = {
      {2, 4, offsetof(Instance, from)}, {3, 4, offsetof(Instance, to)}, {4, 3, offsetof(Instance, colour)}};
  std::size_t first = 0;
  for (std::size_t i = 0; i < kMeshes; ++i) {
    if (counts_[i] == 0) continue;
    glBindVertexArray(meshes_[i].array.id());
    describe(instances_, sizeof(Instance), instance, 1, first);
    glDrawElementsInstanced(GL_TRIANGLES, meshes_[i].indices, GL_UNSIGNED_SHORT, nullptr,
                            static_cast<GLsizei>(counts_[i]));
    first += counts_[i];
  }
  glBindVertexArray(0);
}

void CapsulePass::draw(const Figure& figure, const View& view) {
  if (figure.capsules.empty()) return;
  std::array<std::vector<Instance>, kMeshes> by_mesh;
  for (const Capsule& capsule : figure.capsules) {
    const Instance instance = instance_of(capsule, view);
    by_mesh[mesh_for(instance, view.camera.focal_px)].push_back(instance);
  }
  std::vector<Instance> instances;
  for (std::size_t i = 0; i < kMeshes; ++i) {
    counts_[i] = by_mesh[i].size();
    instances.insert(instances.end(), by_mesh[i].begin(), by_mesh[i].end());
  }
  upload(instances_, std::as_bytes(std::span(instances)));

  program_.use();
  glUniform4fv(program_.uniform("projection"), 1, view.projection().data());
  glUniform2fv(program_.uniform("depth_range"), 1, View::depth_range().data());
  const Vec3 up = view.camera.rotation_camera_from_world * Vec3(0, 1, 0);
  glUniform3f(program_.uniform("up_camera"), static_cast<float>(up.x), static_cast<float>(up.y),
              static_cast<float>(up.z));
  glUniform1f(program_.uniform("band_m"), figure.surface == Surface::Banded ? kBandPair_m : 0.0F);
  glDisable(GL_BLEND);
  glEnable(GL_CULL_FACE);
  glCullFace(GL_BACK);
  glFrontFace(GL_CW);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glUniform4f(program_.uniform("outline"), 0, 0, 0, -1);
  glUniform1f(program_.uniform("metres_per_px"), 0);
  draw_meshes();
  if (figure.outline.alpha > 0 && figure.outline_px > 0) {
    const Colour& c = figure.outline;
    glUniform4f(program_.uniform("outline"), c.red * c.alpha, c.green * c.alpha, c.blue * c.alpha, c.alpha);
    glUniform1f(program_.uniform("metres_per_px"),
                static_cast<float>(figure.outline_px / view.camera.focal_px));
    draw_meshes();
  }
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
}

PixelBox CapsulePass::bounds(const Figure& figure, const View& view) {
  double left = 1e9, top = 1e9, right = -1e9, bottom = -1e9;
  const PinholeCamera& camera = view.camera;
  for (const Capsule& capsule : figure.capsules)
    for (const auto& [end, radius] :
         {std::pair(capsule.from, capsule.from_radius_m), std::pair(capsule.to, capsule.to_radius_m)}) {
      const Vec3 p = camera.camera_from_world(end);
      if (p.z + radius <= kNear_m) continue;
      if (p.z - radius <= kNear_m) return {0, 0, camera.width_px, camera.height_px};
      const double x = camera.focal_px * p.x / p.z + camera.centre_px.x;
      const double y = camera.focal_px * p.y / p.z + camera.centre_px.y;
      // A sphere off the axis is drawn as an ellipse, longer than its radius; twice is enough at 60 degrees.
      const double reach = 2 * camera.focal_px * radius / (p.z - radius) + figure.outline_px + 2;
      left = std::min(left, x - reach);
      right = std::max(right, x + reach);
      top = std::min(top, y - reach);
      bottom = std::max(bottom, y + reach);
    }
  if (left > right) return {};
  const auto clamped = [](double value, int limit) {
    return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(limit)));
  };
  return {clamped(std::floor(left), camera.width_px), clamped(std::floor(top), camera.height_px),
          clamped(std::ceil(right), camera.width_px), clamped(std::ceil(bottom), camera.height_px)};
}

}  // namespace posecoach::gl
