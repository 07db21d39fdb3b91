// Measuring the student while he stands before the camera: a count-down to get into place, a few seconds of
// looking, and the body or the reason why there is none.
#pragma once

#include <optional>
#include <vector>

#include "core/body/landmarks.h"
#include "core/body/skeleton.h"
#include "core/pipeline/coach_snapshot.h"

namespace posecoach {

struct BodyMeasuringOptions {
  double count_down_s = 3, looking_s = 3;
  std::optional<double> height_m;
};

class BodyMeasuring {
 public:
  explicit BodyMeasuring(const BodyMeasuringOptions& options) : options_(options) {}

  // `placed` as LiveLift gives it. Returns the body in the step in which it is measured.
  std::optional<Skeleton> step(MediaTime time, const std::optional<WorldKeypoints>& placed);
  // What to show. Its answer stays for some seconds.
  Measuring state() const;
  bool is_over() const { return is_over_; }

 private:
  std::optional<Skeleton> finish();

  BodyMeasuringOptions options_;
  Measuring::Stage stage_ = Measuring::Stage::CountDown;
  std::optional<MediaTime> since_;  // of the stage
  MediaTime now_;
  std::vector<WorldKeypoints> looks_;
  int looks_asked_ = 0;
  std::string words_;
  bool is_over_ = false;
};

}  // namespace posecoach
