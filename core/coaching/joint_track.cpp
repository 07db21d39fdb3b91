#include "core/coaching/joint_track.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/assert.h"
#include "core/base/median.h"
#include "core/body/mirror.h"
#include "core/coaching/text/refusal_text.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

constexpr std::array kNeeded = {LeftShoulder, RightShoulder, LeftElbow, RightElbow, LeftWrist, RightWrist,
                                LeftHip,      RightHip,      LeftKnee,  RightKnee,  LeftAnkle, RightAnkle};
constexpr int kFewestFrames = 5;

}  // namespace

void JointTrack::add_joint(HumanoidJoint joint) {
  column_[static_cast<std::size_t>(joint)] = static_cast<int>(joints_.size());
  joints_.push_back(joint);
}

Result<JointTrack> JointTrack::from_motion(const Motion& motion) {
  const Skeleton& skeleton = motion.skeleton();
  std::string missing;
  for (const HumanoidJoint joint : kNeeded)
    if (!skeleton.has(joint)) missing += (missing.empty() ? "" : ", ") + std::string(to_string(joint));
  if (!missing.empty()) return fail(ErrorCode::Incomplete, text::no_such_joints(missing));
  if (motion.frame_count() < kFewestFrames)
    return fail(ErrorCode::Incomplete, text::too_few_frames_to_analyse(motion.frame_count(), kFewestFrames));
  JointTrack track;
  for (const HumanoidJoint joint : kHumanoidJoints)
    if (skeleton.has(joint) || joint == Pelvis || joint == Neck) track.add_joint(joint);
  for (int frame = 0; frame < motion.frame_count(); ++frame) {
    track.times_.push_back(to_seconds(motion.time(frame) - motion.time(0)));
    const auto add_middle = [&](HumanoidJoint left, HumanoidJoint right) {
      const int a = skeleton.find(left), b = skeleton.find(right);
      track.positions_.push_back(0.5 * (motion.position(frame, a) + motion.position(frame, b)));
      track.confidence_.push_back(std::min(motion.confidence(frame, a), motion.confidence(frame, b)));
    };
    for (const HumanoidJoint joint : track.joints_) {
      if (const int at = skeleton.find(joint); at != kNoJoint) {
        track.positions_.push_back(motion.position(frame, at));
        track.confidence_.push_back(motion.confidence(frame, at));
      } else if (joint == Pelvis) {
        add_middle(LeftHip, RightHip);
      } else {
        add_middle(LeftShoulder, RightShoulder);
      }
    }
  }
  return track;
}

double JointTrack::frame_rate() const {
  if (times_.size() < 2) return 0;
  std::vector<double> steps;
  for (std::size_t i = 1; i < times_.size(); ++i) steps.push_back(times_[i] - times_[i - 1]);
  return 1 / median(std::move(steps));
}

JointTrack JointTrack::averaged(double begin_s, double end_s) const {
  constexpr int kInstants = 5;
  std::vector<double> times;
  for (int i = 0; i < kInstants; ++i)
    times.push_back(
        std::clamp(begin_s + (end_s - begin_s) * i / (kInstants - 1), times_.front(), times_.back()));
  JointTrack mean = at(std::move(times));
  const std::size_t width = joints_.size();
  for (std::size_t k = 0; k < width; ++k) {
    Vec3 sum(0);
    double confidence = 0;
    for (std::size_t i = 0; i < kInstants; ++i) {
      sum += mean.positions_[i * width + k];
      confidence += mean.confidence_[i * width + k];
    }
    mean.positions_[k] = sum / static_cast<double>(kInstants);
    mean.confidence_[k] = confidence / kInstants;
  }
  mean.positions_.resize(width);
  mean.confidence_.resize(width);
  mean.times_ = {0.5 * (begin_s + end_s)};
  return mean;
}

JointTrack JointTrack::mirrored() const {
  JointTrack track = *this;
  for (int frame = 0; frame < frame_count(); ++frame)
    for (const HumanoidJoint joint : joints_) {
      const HumanoidJoint partner = has(posecoach::mirrored(joint)) ? posecoach::mirrored(joint) : joint;
      track.positions_[index(frame, joint)] = posecoach::mirrored(position(frame, partner));
      track.confidence_[index(frame, joint)] = confidence(frame, partner);
    }
  return track;
}

int JointTrack::frame_before(double time_s) const {
  const auto after = std::upper_bound(times_.begin(), times_.end(), time_s);
  const auto frame = static_cast<int>(after - times_.begin()) - 1;
  return std::clamp(frame, 0, std::max(0, frame_count() - 2));
}

double JointTrack::fractional_frame(double time_s) const {
  if (frame_count() < 2) return 0;
  const int left = frame_before(time_s);
  const double part = (time_s - time(left)) / (time(left + 1) - time(left));
  return left + std::clamp(part, 0.0, 1.0);
}

int JointTrack::nearest_frame(double time_s) const {
  return static_cast<int>(std::lround(fractional_frame(time_s)));
}

JointTrack JointTrack::resampled(double frames_per_second, double begin_s, double end_s) const {
  POSECOACH_ASSERT(frames_per_second > 0);
  begin_s = std::max(begin_s, times_.front());
  end_s = std::min(end_s, times_.back());
  std::vector<double> times;
  const auto steps = static_cast<int>(std::floor((end_s - begin_s) * frames_per_second + 1e-6));
  for (int i = 0; i <= steps; ++i) times.push_back(begin_s + i / frames_per_second);
  if (end_s - times.back() > 1e-6) times.push_back(end_s);
  return at(std::move(times));
}

JointTrack JointTrack::at(std::vector<double> times_s) const {
  JointTrack track;
  track.joints_ = joints_;
  track.column_ = column_;
  const std::size_t width = joints_.size();
  const auto frames = static_cast<std::size_t>(frame_count());
  for (const double wanted : times_s) {
    if (frames < 2) {
      track.positions_.insert(track.positions_.end(), positions_.begin(), positions_.end());
      track.confidence_.insert(track.confidence_.end(), confidence_.begin(), confidence_.end());
      continue;
    }
    const auto i = static_cast<std::size_t>(frame_before(wanted));
    const double step = times_[i + 1] - times_[i];
    const double u = std::clamp((wanted - times_[i]) / step, 0.0, 1.0);
    for (std::size_t k = 0; k < width; ++k) {
      const auto p = [&](std::size_t frame) { return positions_[frame * width + k]; };
      // Slopes by central differences over uneven steps; one-sided at the ends.
      const auto slope = [&](std::size_t frame) {
        const std::size_t a = frame == 0 ? 0 : frame - 1, b = std::min(frame + 1, frames - 1);
        return (p(b) - p(a)) / (times_[b] - times_[a]);
      };
      const double u2 = u * u, u3 = u2 * u;
      const Vec3 position = u == 0   ? p(i)
                            : u == 1 ? p(i + 1)
                                     : (2 * u3 - 3 * u2 + 1) * p(i) + (u3 - 2 * u2 + u) * step * slope(i) +
                                           (3 * u2 - 2 * u3) * p(i + 1) + (u3 - u2) * step * slope(i + 1);
      track.positions_.push_back(position);
      track.confidence_.push_back((1 - u) * confidence_[i * width + k] +
                                  u * confidence_[(i + 1) * width + k]);
    }
  }
  track.times_ = std::move(times_s);
  return track;
}

}  // namespace posecoach
