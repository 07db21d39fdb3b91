// Turning pictures upright, as the camera noted when it was held sideways.
#pragma once

#include <array>
#include <cstdint>

#include "core/image/frame.h"

namespace posecoach {

// One of the eight ways to lay a picture on its grid: first rows and columns change places, then the result
// is mirrored.
struct Orientation {
  bool swaps_axes = false;
  bool mirrors_x = false;
  bool mirrors_y = false;

  bool operator==(const Orientation&) const = default;
};

// From the linear part of a film's display matrix: x' = a x + c y, y' = b x + d y. Other angles become the
// nearest quarter turn.
Orientation orientation_from_matrix(double a, double b, double c, double d);

// Rows of 8-bit RGB, `stride` bytes apart.
struct PictureRows {
  const std::uint8_t* first = nullptr;
  std::size_t stride = 0;
  int width = 0;
  int height = 0;
};

Image upright_copy(const PictureRows& rows, Orientation orientation);

}  // namespace posecoach
