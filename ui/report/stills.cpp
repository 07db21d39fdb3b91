#include "ui/report/stills.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "ui/render/words.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

constexpr double kAspect = 2.0 / 3.0;
constexpr std::size_t kMostStills = 5;
// Two stills are at least this part of the whole motion apart.
constexpr double kApart = 0.06;

constexpr std::array kSpokenJoints = {Head,       LeftShoulder, RightShoulder, LeftElbow,
                                      RightElbow, LeftWrist,    RightWrist,    LeftHip,
                                      RightHip,   LeftKnee,     RightKnee};

std::optional<Vec3> seen(const BodyState& body, HumanoidJoint role) {
  const int joint = body.skeleton.find(role);
  if (joint == kNoJoint) return std::nullopt;
  const auto i = static_cast<std::size_t>(joint);
  if (!body.confidence.empty() && body.confidence[i] < 0.5) return std::nullopt;
  return body.positions[i];
}

// Of the pair of the path that is nearest to a frame of the student.
int coach_frame_at(const Analysis& analysis, int student_frame) {
  const auto nearest =
      std::min_element(analysis.path.begin(), analysis.path.end(), [&](const auto& a, const auto& b) {
        return std::abs(a.first - student_frame) < std::abs(b.first - student_frame);
      });
  return nearest->second;
}

}  // namespace

std::vector<StillMoment> still_moments(const Analysis& analysis) {
  std::vector<StillMoment> chosen;
  if (analysis.path.empty()) return chosen;
  const double apart = std::max(1.0, kApart * (analysis.path.back().first - analysis.path.front().first));
  const auto add = [&](int student_frame, int coach_frame, std::optional<HumanoidJoint> joint) {
    for (const StillMoment& other : chosen)
      if (std::abs(other.student_frame - student_frame) < apart) return;
    if (chosen.size() < kMostStills) chosen.push_back({student_frame, coach_frame, joint});
  };
  for (const Advice& advice : analysis.advice) {
    if (advice.kind == AdviceKind::None) continue;
    std::optional<HumanoidJoint> joint;
    for (const SpatialAdvice& spatial : analysis.spatial)
      if (advice.kind == AdviceKind::Spatial && spatial.student_frame == advice.student_frame && !joint)
        joint = humanoid_joint_from_string(spatial.joint);
    add(advice.student_frame, advice.coach_frame, joint);
  }
  for (const FramePair& pair : analysis.worst_frames) add(pair.student_frame, pair.coach_frame, {});
  for (const char* name : {"top", "impact", "finish", "address"})
    for (const SwingEvent& event : analysis.student_events)
      if (event.name == name) add(event.frame, coach_frame_at(analysis, event.frame), {});
  std::sort(chosen.begin(), chosen.end(),
            [](const StillMoment& a, const StillMoment& b) { return a.student_frame < b.student_frame; });
  return chosen;
}

std::optional<JointApart> joint_apart(const BodyState& student, const BodyState& coach,
                                      std::optional<HumanoidJoint> wanted, const Vec3& unseen) {
  const auto his_root = seen(student, Pelvis), coachs_root = seen(coach, Pelvis);
  if (!his_root || !coachs_root) return std::nullopt;
  const auto measure = [&](HumanoidJoint role) -> std::optional<JointApart> {
    const auto his = seen(student, role), coachs = seen(coach, role);
    if (!his || !coachs) return std::nullopt;
    Vec3 apart = *his - *coachs;
    if (role != Pelvis) apart -= *his_root - *coachs_root;
    return JointApart{role, *his, *coachs, glm::length(apart - glm::dot(apart, unseen) * unseen)};
  };
  if (wanted)
    if (const auto apart = measure(*wanted)) return apart;
  std::optional<JointApart> farthest;
  for (const HumanoidJoint role : kSpokenJoints)
    if (const auto apart = measure(role); apart && (!farthest || apart->distance_m > farthest->distance_m))
      farthest = apart;
  return farthest;
}

std::string still_caption(const std::string& phase, const std::optional<JointApart>& apart) {
  if (!apart) return phase;
  std::string joint = title_from_name(to_string(apart->joint));
  if (!phase.empty()) joint[0] = static_cast<char>(joint[0] - 'A' + 'a');
  return (phase.empty() ? "" : phase + ": ") + joint + " " + decimal(100 * apart->distance_m, 0) + " cm away";
}

PixelCrop crop_around(const std::vector<Vec2>& points, int width, int height) {
  Vec2 low(1e9), high(-1e9);
  for (const Vec2& p : points) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  if (points.empty()) return {0, 0, width, height};
  const Vec2 air(1.15 * (high.x - low.x), 1.2 * (high.y - low.y));
  const double tall =
      std::min({std::max(air.y, air.x / kAspect), static_cast<double>(height), width / kAspect});
  if (tall < 8) return {0, 0, width, height};
  const Vec2 size(kAspect * tall, tall);
  const Vec2 corner = glm::clamp(0.5 * (low + high) - 0.5 * size, Vec2(0), Vec2(width, height) - size);
  const auto whole = [](double value) { return static_cast<int>(std::floor(value)); };
  return {whole(corner.x), whole(corner.y), whole(size.x), whole(size.y)};
}

Image cut_out(const Image& image, const PixelCrop& crop) {
  Image result = Image::black(crop.width, crop.height);
  for (int y = 0; y < crop.height; ++y)
    std::copy_n(image.pixel(crop.left, crop.top + y), 3 * static_cast<std::size_t>(crop.width),
                result.pixel(0, y));
  return result;
}

}  // namespace posecoach
