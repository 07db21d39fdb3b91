#include "core/pipeline/address_watch.h"

#include "core/coaching/address_advice.h"

namespace posecoach {
namespace {

constexpr double kWindow_s = 0.5, kEvery_s = 0.5;
constexpr std::size_t kFewestLooks = 5;

}  // namespace

const std::vector<std::string>& AddressWatch::step(MediaTime time, const LiveStudent& student,
                                                   bool is_at_address, const PersonalCoach& coach,
                                                   Handedness hand) {
  if (!is_at_address) {
    reset();
    return advice_;
  }
  if (!looks_.empty() && time <= looks_.back().time) looks_.clear();
  looks_.push_back({time, student});
  while (to_seconds(time - looks_.front().time) > kWindow_s) looks_.pop_front();
  const bool is_due = !told_at_ || to_seconds(time - *told_at_) >= kEvery_s;
  if (is_due && looks_.size() >= kFewestLooks) {
    advice_ = look(coach, hand);
    told_at_ = time;
  }
  return advice_;
}

std::vector<std::string> AddressWatch::look(const PersonalCoach& coach, Handedness hand) const {
  std::vector<MediaTime> times;
  std::vector<Vec3> positions;
  std::vector<double> confidence;
  for (const Look& one : looks_) {
    times.push_back(one.time);
    positions.insert(positions.end(), one.student.positions.begin(), one.student.positions.end());
    confidence.insert(confidence.end(), one.student.confidence.begin(), one.student.confidence.end());
  }
  const Result<Motion> motion =
      Motion::from_positions(*coach.body, std::move(times), std::move(positions), std::move(confidence));
  if (!motion) return {};
  const Result<JointTrack> track = JointTrack::from_motion(*motion);
  if (!track) return {};
  const JointTrack student = track->averaged(0, track->duration()), address = coach.address();
  const Viewpoint view = judged_from(looks_.back().student.side);
  return hand == Handedness::Left ? address_advice(student.mirrored(), address.mirrored(), view)
                                  : address_advice(student, address, view);
}

}  // namespace posecoach
