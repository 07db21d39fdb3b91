// Progress of long work and its cancellation, seen from the worker: call `report` now and then; stop when it
// says no.
#pragma once

#include <functional>
#include <string_view>

namespace posecoach {

// `fraction` in [0, 1], or negative when the end is not known. Returns false when the user wants the work to
// stop; the worker then ends with ErrorCode::Cancelled. An empty function means: nobody watches, never stop.
using Progress = std::function<bool(std::string_view stage, double fraction)>;

inline bool report(const Progress& progress, std::string_view stage, double fraction) {
  return !progress || progress(stage, fraction);
}

}  // namespace posecoach
