// The 1-euro filter (Casiez, Roussel, Vogel: "1€ Filter", CHI 2012): a low pass whose cutoff rises with
// speed, so that what rests does not tremble and what moves does not lag.
#pragma once

#include <optional>

#include "core/base/time.h"

namespace posecoach {

struct OneEuroOptions {
  double least_cutoff_hz = 1;  // at rest: lower trembles less
  double speed_weight = 0;     // how much the cutoff rises with speed: higher lags less
  double speed_cutoff_hz = 1;  // low pass of the speed itself
};

class OneEuroFilter {
 public:
  explicit OneEuroFilter(const OneEuroOptions& options);

  // `scale` turns the value's unit into the one that `speed_weight` is for. Values come in the order of their
  // time; one that does not come later than the one before passes as it is and leaves no trace.
  double filter(MediaTime time, double value, double scale);
  void reset() { state_.reset(); }

 private:
  struct State {
    MediaTime time;
    double frequency_hz = 0;
    double raw = 0;
    double smooth = 0;
    double speed = 0;
  };
  OneEuroOptions options_;
  std::optional<State> state_;
};

}  // namespace posecoach
