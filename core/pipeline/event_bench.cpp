#include "core/pipeline/event_bench.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace posecoach {

std::vector<BenchEventRow> tally_events(const std::vector<BenchAnswer>& answers) {
  constexpr double kFrame_s = 1.0 / 30;
  std::vector<BenchEventRow> rows;
  for (const BenchAnswer& answer : answers)
    for (const auto& [event, late_s] : answer.events_late) {
      auto row = std::find_if(rows.begin(), rows.end(), [&, &name = event](const BenchEventRow& r) {
        return r.eye == answer.asked.eye && r.motion == answer.asked.motion && r.event == name;
      });
      if (row == rows.end()) row = rows.insert(rows.end(), {answer.asked.eye, answer.asked.motion, event});
      ++row->strokes;
      row->within += std::abs(late_s) <= kFrame_s ? 1 : 0;
      row->late_s += late_s;
      row->spread_s += late_s * late_s;
    }
  for (BenchEventRow& row : rows) {
    row.late_s /= row.strokes;
    row.spread_s = std::sqrt(std::max(0.0, row.spread_s / row.strokes - row.late_s * row.late_s));
  }
  std::stable_sort(rows.begin(), rows.end(), [](const BenchEventRow& a, const BenchEventRow& b) {
    return std::tuple(a.eye, a.motion != "swing") < std::tuple(b.eye, b.motion != "swing");
  });
  return rows;
}

}  // namespace posecoach
