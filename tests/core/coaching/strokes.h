// Strokes with known truth for the tests of coaching.
#pragma once

#include <random>
#include <string_view>
#include <vector>

#include "core/body/standard_body.h"
#include "core/motion/authored/authored_motion.h"
#include "core/motion/bundled_motion.h"

namespace posecoach {

struct StrokeShape {
  std::string_view name = "swing";
  double frames_per_second = 120;
  BodyProportions body = {};
  Handedness hand = Handedness::Right;
};

inline AuthoredMotion make_stroke(const GolfScript& script, const StrokeShape& shape = {}) {
  return make_authored_motion(script, make_standard_body(shape.body), shape.frames_per_second, shape.hand)
      .value();
}

inline AuthoredMotion make_stroke(const StrokeShape& shape = {}) {
  return make_stroke(bundled_script(shape.name).value(), shape);
}

inline std::vector<MediaTime> times_of(const Motion& motion) {
  return {motion.times().begin(), motion.times().end()};
}

// The same body with every position passed through `map(frame, joint, position)`.
template <typename Map>
Motion with_positions(const Motion& motion, const Map& map, std::vector<double> confidence = {}) {
  std::vector<Vec3> positions;
  for (int frame = 0; frame < motion.frame_count(); ++frame)
    for (int joint = 0; joint < motion.joint_count(); ++joint)
      positions.push_back(map(frame, joint, motion.position(frame, joint)));
  return Motion::from_positions(motion.skeleton(), times_of(motion), std::move(positions),
                                std::move(confidence))
      .value();
}

inline Motion turned_by(const Motion& motion, double yaw) {
  return with_positions(motion, [yaw](int, int, const Vec3& p) {
    return Vec3(std::cos(yaw) * p.x + std::sin(yaw) * p.z, p.y, std::cos(yaw) * p.z - std::sin(yaw) * p.x);
  });
}

// The same poses at `factor` times the time.
inline Motion slowed_by(const Motion& motion, double factor) {
  std::vector<MediaTime> times;
  std::vector<Vec3> positions;
  for (int frame = 0; frame < motion.frame_count(); ++frame) {
    times.push_back(media_time_from_seconds(factor * to_seconds(motion.time(frame) - motion.time(0))));
    positions.insert(positions.end(), motion.positions(frame).begin(), motion.positions(frame).end());
  }
  return Motion::from_positions(motion.skeleton(), std::move(times), std::move(positions)).value();
}

// White noise on every joint, the same in every run.
inline Motion trembling(const Motion& motion, double metres, double confidence = 1) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0, metres);
  const std::size_t count =
      static_cast<std::size_t>(motion.frame_count()) * static_cast<std::size_t>(motion.joint_count());
  return with_positions(
      motion,
      [&](int, int, const Vec3& p) { return p + Vec3(normal(random), normal(random), normal(random)); },
      std::vector<double>(count, confidence));
}

}  // namespace posecoach
