#include "core/coaching/online_dtw.h"

#include <algorithm>
#include <limits>

#include "core/base/assert.h"

namespace posecoach {

OnlineWarp::OnlineWarp(PoseSequence coach, int look_ahead)
    : coach_(std::move(coach)),
      look_ahead_(look_ahead),
      row_(static_cast<std::size_t>(coach_.frames())),
      above_(row_.size()) {
  POSECOACH_ASSERT(look_ahead >= 1);
}

void OnlineWarp::reset() {
  position_ = 0;
  is_first_ = true;
}

int OnlineWarp::step(const PoseSequence& student) {
  cost_row(student, 0, coach_, costs_);
  std::swap(row_, above_);
  double left = std::numeric_limits<double>::infinity(), smallest = left;
  for (std::size_t j = 0; j < row_.size(); ++j) {
    double best = is_first_ ? (j == 0 ? 0 : std::numeric_limits<double>::infinity())
                            : std::min(above_[j], j > 0 ? above_[j - 1] : above_[j]);
    best = std::min(best, left);
    left = row_[j] = best + static_cast<double>(costs_[j]);
    smallest = std::min(smallest, left);
  }
  is_first_ = false;
  // Only differences count; a golfer may stand at address for minutes.
  for (double& value : row_) value -= smallest;
  // Towards the best of all that lies ahead, so that a place that only seems good does not hold it back.
  const auto best = std::min_element(row_.begin() + position_, row_.end());
  position_ = std::min(position_ + look_ahead_, static_cast<int>(best - row_.begin()));
  return position_;
}

double OnlineWarp::distance_m(const PoseSequence& student, int coach_frame) const {
  return pair_cost(student, 0, coach_, coach_frame) / coach_.joints();
}

}  // namespace posecoach
