// Writes small C3D files for tests, in each of the three kinds of numbers.
#pragma once

#include <string>
#include <vector>

#include "core/base/math.h"

namespace posecoach::samples {

struct C3dSample {
  int processor = 84;  // 84 Intel, 85 DEC, 86 MIPS
  bool as_integers = false;
  double scale = 0.5;  // of integers
  double rate = 100;
  std::string units = "mm";
  std::vector<std::string> labels;
  // frame-major; x is NaN for a hidden marker
  std::vector<Vec3> positions;
  int analog_samples = 0;  // a frame
};

std::string c3d_bytes(const C3dSample& sample);

}  // namespace posecoach::samples
