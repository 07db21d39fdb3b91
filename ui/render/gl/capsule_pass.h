// Draws a figure's capsules, lit, with their outline, into the bound frame buffer.
#pragma once

#include <array>

#include "ui/render/gl/objects.h"
#include "ui/render/gl/view.h"
#include "ui/render/scene.h"

namespace posecoach::gl {

class CapsulePass {
 public:
  static Result<CapsulePass> make();

  // The target needs a depth buffer and must be clear to zero within the figure's bounds.
  void draw(const Figure& figure, const View& view);

  // Where the figure can leave pixels: empty when all of it is outside the picture or behind the camera.
  static PixelBox bounds(const Figure& figure, const View& view);

 private:
  struct Mesh {
    Handle vertices, array;
    int indices = 0;
    Handle index_buffer;
  };
  explicit CapsulePass(Program program);
  static Mesh make_mesh(int segments, int rings);
  // Draws each mesh with its share of the uploaded instances.
  void draw_meshes() const;

  static constexpr std::size_t kMeshes = 4;
  Program program_;
  Handle instances_;
  std::array<Mesh, kMeshes> meshes_;  // from coarse to fine
  std::array<std::size_t, kMeshes> counts_{};
};

}  // namespace posecoach::gl
