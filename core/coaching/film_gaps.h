// How far the joints that a camera saw are from the coach's, stage by stage: the mean over the moments about
// a stage, so that what trembles cancels, before and after the pose stage's usual errors are taken off.
#pragma once

#include <string_view>
#include <vector>

#include "core/coaching/alignment.h"
#include "core/coaching/body_axes.h"
#include "core/coaching/film_error.h"

namespace posecoach {

class FilmGaps {
 public:
  // `axes`: the coach's at address, as he is turned in the alignment.
  FilmGaps(const Alignment& alignment, const FilmStages& stages, const BodyAxes& axes, double leg_length_m,
           const UsualFilmError& usual_error);

  int stages() const { return stages_; }
  const FilmStages::Phases& phases() const { return phases_; }
  const std::vector<HumanoidJoint>& joints() const { return joints_; }
  // Leg lengths along left, up and front; as seen.
  const Vec3& seen(int stage, std::size_t joint) const {
    return gaps_[static_cast<std::size_t>(stage) * joints_.size() + joint];
  }
  // Where the camera looks, along the same axes.
  Vec3 sight() const { return sight_.direction.value_or(Vec3(0)); }
  // As far as this film shows the habits.
  const UsualFilmError& usual_error() const { return usual_error_; }
  // Without the habits, leg lengths.
  double left(int stage, std::size_t joint) const {
    return left_[static_cast<std::size_t>(stage) * joints_.size() + joint];
  }

 private:
  double shown_part() const;

  int stages_ = 0;
  FilmStages::Phases phases_;
  std::vector<HumanoidJoint> joints_;
  std::vector<Vec3> gaps_;    // stage * joints + joint
  std::vector<double> left_;  // likewise
  Sight sight_;
  UsualFilmError usual_error_;
};

}  // namespace posecoach
