#include "core/coaching/film_gaps.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace posecoach {
namespace {

// Nobody counts for less: a hidden arm is still somewhere near.
constexpr double kLeastWeight = 0.05;

}  // namespace

FilmGaps::FilmGaps(const Alignment& alignment, const FilmStages& stages, const BodyAxes& axes,
                   double leg_length_m, const UsualFilmError& usual_error)
    : stages_(stages.count()),
      phases_(stages.phases()),
      joints_(alignment.joints),
      sight_(alignment.sight),
      usual_error_(usual_error) {
  if (sight_.direction) sight_.direction = in_axes(axes, *sight_.direction);
  const std::size_t width = joints_.size();
  gaps_.assign(static_cast<std::size_t>(stages_) * width, Vec3(0));
  std::vector<double> weights(gaps_.size(), 0);
  for (const auto& [i, j] : alignment.steps)
    for (int stage = 0; stage < stages_; ++stage) {
      const double near = stages.weight(stage, alignment.coach.time(j));
      if (near == 0) continue;
      for (std::size_t k = 0; k < width; ++k) {
        const HumanoidJoint joint = joints_[k];
        const Vec3 apart =
            alignment.student.position(i, joint) - alignment.student.position(i, HumanoidJoint::Pelvis) -
            (alignment.coach.position(j, joint) - alignment.coach.position(j, HumanoidJoint::Pelvis));
        const double weight = near * (kLeastWeight + alignment.student.confidence(i, joint));
        const std::size_t at = static_cast<std::size_t>(stage) * width + k;
        gaps_[at] += weight / leg_length_m * in_axes(axes, apart);
        weights[at] += weight;
      }
    }
  for (std::size_t at = 0; at < gaps_.size(); ++at)
    if (weights[at] > 0) gaps_[at] /= weights[at];
  usual_error_ = usual_error.shown(shown_part());
  for (int stage = 0; stage < stages_; ++stage)
    for (std::size_t k = 0; k < width; ++k)
      left_.push_back(glm::length(
          sight_.seen(seen(stage, k) - usual_error_.share() * usual_error_.offset(joints_[k], stage))));
}

// What is seen, projected on the habits.
double FilmGaps::shown_part() const {
  double along = 0, habits = 0;
  for (int stage = 0; stage < stages_; ++stage)
    for (std::size_t k = 0; k < joints_.size(); ++k) {
      const Vec3 habit = sight_.seen(usual_error_.offset(joints_[k], stage));
      along += glm::dot(sight_.seen(seen(stage, k)), habit);
      habits += glm::dot(habit, habit);
    }
  return habits > 0 ? along / habits : 0;
}

}  // namespace posecoach
