// How far from the truth the events of the fault bench's strokes are found.
#pragma once

#include <string>
#include <vector>

#include "core/pipeline/fault_bench.h"

namespace posecoach {

// Of all answers of one eye and motion, one event.
struct BenchEventRow {
  BenchEye eye = BenchEye::TrueJoints;
  std::string motion, event;
  int strokes = 0, within = 0;  // a frame at 30 frames a second
  double late_s = 0;            // mean
  double spread_s = 0;          // one standard deviation
};
std::vector<BenchEventRow> tally_events(const std::vector<BenchAnswer>& answers);

}  // namespace posecoach
