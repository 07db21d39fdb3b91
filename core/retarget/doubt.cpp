#include "core/retarget/doubt.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/assert.h"
#include "core/base/index.h"
#include "core/retarget/smoothing.h"

namespace posecoach {
namespace {

constexpr double kSureError = 0.005, kDoubtfulError = 0.025;
constexpr double kDoubtSmoothing_s = 0.25;

// Only canonical bones: hair and clothes may stretch.
double bone_error(const Motion& motion, int frame, const std::vector<int>& bones) {
  double error = 0, weight = 0;
  for (const int j : bones) {
    const int parent = motion.skeleton().joint(j).parent;
    const double wanted = motion.skeleton().bone_length(j);
    error += std::abs(glm::distance(motion.position(frame, j), motion.position(frame, parent)) - wanted);
    error += 0.2 * wanted * (1 - std::min(motion.confidence(frame, j), motion.confidence(frame, parent)));
    weight += wanted;
  }
  return weight > 0 ? error / weight : 0;
}

}  // namespace

bool is_seen_by_camera(const Motion& motion) {
  std::size_t guessed = 0;
  for (int frame = 0; frame < motion.frame_count(); ++frame)
    for (int j = 0; j < motion.joint_count(); ++j) {
      const double confidence = motion.confidence(frame, j);
      if (confidence > 0 && confidence < 1) ++guessed;
    }
  return 2 * guessed > index(motion.frame_count()) * index(motion.joint_count());
}

std::vector<double> doubts(const Motion& motion) {
  std::vector<double> doubt(index(motion.frame_count()), 0);
  if (!is_seen_by_camera(motion)) return doubt;
  std::vector<int> bones;
  for (int j = 1; j < motion.joint_count(); ++j)
    if (motion.skeleton().joint(j).role && motion.skeleton().bone_length(j) > 0.02) bones.push_back(j);
  std::vector<Vec3> errors;
  for (int frame = 0; frame < motion.frame_count(); ++frame)
    errors.emplace_back(bone_error(motion, frame, bones), 0, 0);
  errors = smoothed_over_time(errors, motion.times(), kDoubtSmoothing_s);
  for (std::size_t i = 0; i < doubt.size(); ++i)
    doubt[i] = std::clamp((errors[i].x - kSureError) / (kDoubtfulError - kSureError), 0.0, 1.0);
  return doubt;
}

Motion smoothed_where_doubtful(const Motion& motion, double sigma_s) {
  const std::vector<double> doubt = doubts(motion);
  if (std::all_of(doubt.begin(), doubt.end(), [](double d) { return d == 0; })) return motion;
  const std::size_t joints = index(motion.joint_count()), frames = doubt.size();
  std::vector<Vec3> positions(frames * joints), path(frames);
  std::vector<double> confidence(frames * joints);
  for (int j = 0; j < motion.joint_count(); ++j) {
    for (std::size_t f = 0; f < frames; ++f) path[f] = motion.position(static_cast<int>(f), j);
    const std::vector<Vec3> smooth = smoothed_over_time(path, motion.times(), sigma_s);
    for (std::size_t f = 0; f < frames; ++f) {
      positions[f * joints + index(j)] = path[f] + doubt[f] * (smooth[f] - path[f]);
      confidence[f * joints + index(j)] = motion.confidence(static_cast<int>(f), j);
    }
  }
  Result<Motion> made =
      Motion::from_positions(motion.skeleton(), {motion.times().begin(), motion.times().end()},
                             std::move(positions), std::move(confidence));
  POSECOACH_ASSERT(made.has_value());
  return *std::move(made);
}

}  // namespace posecoach
