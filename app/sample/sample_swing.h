// A whole analysed swing without camera and pose stage: the simulated student, seen as a perfect pose stage
// would. For measuring and testing what shows swings.
#pragma once

#include <memory>
#include <string>

#include "core/body/mirror.h"
#include "core/pipeline/analyzed_swing.h"

namespace posecoach {

struct SampleSwing {
  std::string fault;  // "sway=8"; empty for none
  double height_m = 1.80;
  Handedness hand = Handedness::Right;
  double frames_per_second = 30;
  int width = 640, height = 360;
  std::string motion = "swing";  // of the bundled ones; the coach plays it too
};

// Errors: those of the simulated student and of the analysis.
Result<std::shared_ptr<const AnalyzedSwing>> make_sample_swing(const SampleSwing& options);

}  // namespace posecoach
