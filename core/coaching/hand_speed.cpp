#include "core/coaching/hand_speed.h"

#include <glm/geometric.hpp>

namespace posecoach {
namespace {

using enum HumanoidJoint;

constexpr double kWindow_s = 0.2;
constexpr double kGap_s = 0.5;
// What the filtered joints of somebody who stands still do not reach, and a slow putt does.
constexpr double kStillHands = 0.12, kStillFeet = 0.20;

}  // namespace

void HandSpeed::step(MediaTime time, const JointMoment& student, const Sight& sight) {
  const double seconds = places_.empty() ? 0 : to_seconds(time - places_.back().time);
  if (seconds <= 0 || seconds > kGap_s) reset();
  places_.push_back({time, sight.seen(student.middle(LeftWrist, RightWrist) - student.at(Pelvis)),
                     sight.seen(student.middle(LeftAnkle, RightAnkle))});
  // Two are always there, however slow the pose stage is.
  while (places_.size() > 2 && to_seconds(time - places_[0].time) > kWindow_s + 1e-6) places_.pop_front();
  if (places_.size() < 2) return;
  const std::size_t half = places_.size() / 2;
  const auto mean = [&](std::size_t first) {
    Places sum{places_[first].time, {}, {}};
    Duration time_sum{0};
    for (std::size_t i = first; i < first + half; ++i) {
      sum.hands += places_[i].hands / static_cast<double>(half);
      sum.feet += places_[i].feet / static_cast<double>(half);
      time_sum += places_[i].time - places_[first].time;
    }
    sum.time += time_sum / static_cast<Duration::rep>(half);
    return sum;
  };
  const Places before = mean(0), after = mean(places_.size() - half);
  const double between = to_seconds(after.time - before.time);
  hands_ = glm::distance(after.hands, before.hands) / between;
  feet_ = glm::distance(after.feet, before.feet) / between;
  still_s_ = hands_ < kStillHands && feet_ < kStillFeet ? still_s_ + seconds : 0;
}

}  // namespace posecoach
