#include "core/motion/motion.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "core/base/assert.h"
#include "core/base/median.h"
#include "core/body/forward_kinematics.h"
#include "core/body/mirror.h"

namespace posecoach {
namespace {

Result<void> check_times(std::span<const MediaTime> times) {
  if (times.empty()) return fail(ErrorCode::Incomplete, "the motion has no frames");
  for (std::size_t i = 1; i < times.size(); ++i)
    if (times[i] <= times[i - 1])
      return fail(ErrorCode::Malformed, "time does not increase at frame " + std::to_string(i));
  return {};
}

template <typename T>
Result<void> check_values(std::span<const T> values, std::size_t frames, std::size_t per_frame,
                          const char* what) {
  if (values.size() != frames * per_frame)
    return fail(ErrorCode::Malformed,
                std::string("the number of ") + what + " does not fit the frames and joints");
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!is_finite(values[i]))
      return fail(ErrorCode::Malformed, std::string("frame ") + std::to_string(i / per_frame) + " has " +
                                            what + " that are not finite numbers");
  return {};
}

}  // namespace

Motion::Motion(Skeleton skeleton, std::vector<MediaTime> times, std::vector<Vec3> positions,
               std::vector<Quat> rotations, std::vector<double> confidence)
    : skeleton_(std::move(skeleton)),
      times_(std::move(times)),
      positions_(std::move(positions)),
      rotations_(std::move(rotations)),
      confidence_(std::move(confidence)) {}

Result<Motion> Motion::from_rotations(Skeleton skeleton, std::vector<MediaTime> times,
                                      std::vector<Vec3> root_positions, std::vector<Quat> local_rotations) {
  const auto joints = static_cast<std::size_t>(skeleton.size());
  if (auto ok = check_times(times); !ok) return tl::unexpected(ok.error());
  if (auto ok = check_values<Vec3>(root_positions, times.size(), 1, "root positions"); !ok)
    return tl::unexpected(ok.error());
  if (auto ok = check_values<Quat>(local_rotations, times.size(), joints, "rotations"); !ok)
    return tl::unexpected(ok.error());
  for (Quat& rotation : local_rotations) rotation = glm::normalize(rotation);
  std::vector<Vec3> positions(times.size() * joints);
  std::vector<Quat> global(joints);
  for (std::size_t frame = 0; frame < times.size(); ++frame) {
    global_rotations(skeleton, std::span(local_rotations).subspan(frame * joints, joints), global);
    joint_positions(skeleton, root_positions[frame], global,
                    std::span(positions).subspan(frame * joints, joints));
  }
  return Motion(std::move(skeleton), std::move(times), std::move(positions), std::move(local_rotations), {});
}

Result<Motion> Motion::from_positions(Skeleton skeleton, std::vector<MediaTime> times,
                                      std::vector<Vec3> positions, std::vector<double> confidence) {
  const auto joints = static_cast<std::size_t>(skeleton.size());
  if (auto ok = check_times(times); !ok) return tl::unexpected(ok.error());
  if (auto ok = check_values<Vec3>(positions, times.size(), joints, "positions"); !ok)
    return tl::unexpected(ok.error());
  if (!confidence.empty() && confidence.size() != positions.size())
    return fail(ErrorCode::Malformed, "the number of confidences does not fit the frames and joints");
  if (std::any_of(confidence.begin(), confidence.end(), [](double c) { return !(c >= 0 && c <= 1); }))
    return fail(ErrorCode::Malformed, "a confidence lies outside 0 to 1");
  return Motion(std::move(skeleton), std::move(times), std::move(positions), {}, std::move(confidence));
}

double Motion::frame_rate() const {
  if (times_.size() < 2) return 0;
  std::vector<Duration> steps;
  for (std::size_t i = 1; i < times_.size(); ++i) steps.push_back(times_[i] - times_[i - 1]);
  return 1.0 / to_seconds(median(std::move(steps)));
}

std::span<const Quat> Motion::rotations(int frame) const {
  POSECOACH_ASSERT(has_rotations());
  return {&rotations_[first(frame)], row()};
}

Motion Motion::slice(int begin, int end) const {
  POSECOACH_ASSERT(0 <= begin && begin < end && end <= frame_count());
  const auto cut = [&](const auto& all, std::size_t per_frame) {
    if (all.empty()) return all;
    const auto at = [&](int frame) {
      return all.begin() + static_cast<std::ptrdiff_t>(index(frame) * per_frame);
    };
    return std::decay_t<decltype(all)>(at(begin), at(end));
  };
  return {skeleton_, cut(times_, 1), cut(positions_, row()), cut(rotations_, row()), cut(confidence_, row())};
}

Motion resample(const Motion& motion, std::span<const MediaTime> times) {
  const auto joints = static_cast<std::size_t>(motion.joint_count());
  std::vector<Vec3> roots, positions;
  std::vector<Quat> rotations;
  std::vector<double> confidence;
  int left = 0;
  for (const MediaTime time : times) {
    while (left + 2 < motion.frame_count() && motion.time(left + 1) <= time) ++left;
    const int right = std::min(left + 1, motion.frame_count() - 1);
    const double span = to_seconds(motion.time(right) - motion.time(left));
    const double part = span > 0 ? std::clamp(to_seconds(time - motion.time(left)) / span, 0.0, 1.0) : 0.0;
    for (int j = 0; j < static_cast<int>(joints); ++j) {
      const Vec3 position = glm::mix(motion.position(left, j), motion.position(right, j), part);
      if (j == 0) roots.push_back(position);
      if (motion.has_rotations()) {
        const auto a = motion.rotations(left)[static_cast<std::size_t>(j)];
        const auto b = motion.rotations(right)[static_cast<std::size_t>(j)];
        rotations.push_back(glm::slerp(a, b, part));
      } else {
        positions.push_back(position);
        confidence.push_back(glm::mix(motion.confidence(left, j), motion.confidence(right, j), part));
      }
    }
  }
  std::vector<MediaTime> stamps(times.begin(), times.end());
  Result<Motion> made = motion.has_rotations()
                            ? Motion::from_rotations(motion.skeleton(), std::move(stamps), std::move(roots),
                                                     std::move(rotations))
                            : Motion::from_positions(motion.skeleton(), std::move(stamps),
                                                     std::move(positions), std::move(confidence));
  POSECOACH_ASSERT(made.has_value());
  return *std::move(made);
}

Motion resample(const Motion& motion, double frames_per_second) {
  POSECOACH_ASSERT(frames_per_second > 0);
  const double seconds = to_seconds(motion.duration());
  const auto count = static_cast<std::size_t>(std::floor(seconds * frames_per_second + 1e-6)) + 1;
  std::vector<MediaTime> times;
  times.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    times.push_back(motion.time(0) + duration_from_seconds(static_cast<double>(i) / frames_per_second));
  return resample(motion, times);
}

Motion mirrored(const Motion& motion) {
  const std::vector<int> partners = mirror_partners(motion.skeleton());
  const Skeleton skeleton = mirrored(motion.skeleton());
  const std::vector<MediaTime> times(motion.times().begin(), motion.times().end());
  std::vector<Vec3> roots, positions;
  std::vector<Quat> rotations;
  std::vector<double> confidence;
  for (int frame = 0; frame < motion.frame_count(); ++frame) {
    roots.push_back(mirrored(motion.position(frame, 0)));
    for (const int partner : partners) {
      if (motion.has_rotations()) {
        rotations.push_back(mirrored(motion.rotations(frame)[static_cast<std::size_t>(partner)]));
      } else {
        positions.push_back(mirrored(motion.position(frame, partner)));
        confidence.push_back(motion.confidence(frame, partner));
      }
    }
  }
  Result<Motion> made =
      motion.has_rotations()
          ? Motion::from_rotations(skeleton, times, std::move(roots), std::move(rotations))
          : Motion::from_positions(skeleton, times, std::move(positions), std::move(confidence));
  POSECOACH_ASSERT(made.has_value());
  return *std::move(made);
}

}  // namespace posecoach
