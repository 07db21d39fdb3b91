// Draws the floor's grid and the figures' soft shadows over the bound frame buffer.
#pragma once

#include <span>

#include "ui/render/gl/objects.h"
#include "ui/render/gl/view.h"
#include "ui/render/scene.h"

namespace posecoach::gl {

class FloorPass {
 public:
  static Result<FloorPass> make();
  void draw(const Floor& floor, std::span<const Figure> figures, const View& view);

 private:
  explicit FloorPass(Program program);

  Program program_;
  Handle corners_, instances_, array_;
};

}  // namespace posecoach::gl
