#include "core/coaching/address_advice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/coaching/posture.h"
#include "core/coaching/text/advice_text.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

constexpr std::size_t kMostAtAddress = 2;
constexpr double kClearlySeen = 0.5;
// Differences that one camera can be trusted with, and that a golfer can feel.
constexpr double kClearStance_m = 0.06, kClearSpine_deg = 8, kClearSide_deg = 6, kClearKnee_deg = 12,
                 kClearHands_m = 0.07;

struct Setup {
  double stance_m = 0;        // between the ankles
  double spine_deg = 0;       // towards the ball
  double side_deg = 0;        // away from the target
  double knee_deg[2] = {};    // bend, lead and trail
  double hand_out_m[2] = {};  // over the middle of the ankles towards the ball, lead and trail
};

Setup posture_of(const JointTrack& body) {
  const BodyAxes axes = body_axes(body, 0, 0);
  const Vec3 feet = middle_of(body, 0, LeftAnkle, RightAnkle);
  return {
      glm::distance(body.position(0, LeftAnkle), body.position(0, RightAnkle)),
      spine_forward_deg(body, 0, axes),
      spine_side_deg(body, 0, axes),
      {bend_deg(body, 0, LeftHip, LeftKnee, LeftAnkle), bend_deg(body, 0, RightHip, RightKnee, RightAnkle)},
      {in_axes(axes, body.position(0, LeftWrist) - feet).z,
       in_axes(axes, body.position(0, RightWrist) - feet).z}};
}

// Down the line one side hides the other: the side that is seen better speaks for both.
int clearer_side(const JointTrack& student, HumanoidJoint left, HumanoidJoint right) {
  return student.confidence(0, left) >= student.confidence(0, right) ? 0 : 1;
}

bool sees(const JointTrack& student, std::initializer_list<HumanoidJoint> joints) {
  return std::all_of(joints.begin(), joints.end(),
                     [&](HumanoidJoint joint) { return student.confidence(0, joint) >= kClearlySeen; });
}

}  // namespace

std::vector<std::string> address_advice(const JointTrack& student, const JointTrack& coach, Viewpoint view) {
  const Setup his = posture_of(student), coachs = posture_of(coach);
  struct Difference {
    double severity = 0;
    std::string text;
  };
  std::vector<Difference> found;
  const auto compare = [&](bool is_known, double off, double clear, text::Posture what) {
    if (is_known && std::abs(off) >= clear)
      found.push_back({std::abs(off) / clear, text::address(what, off)});
  };
  // At an angle neither is seen well enough to send somebody about.
  const bool sees_side = sees_target_direction(view) && view != Viewpoint::Between;
  const bool sees_front = sees_ball_direction(view) && view != Viewpoint::Between;
  compare(sees_side && sees(student, {LeftAnkle, RightAnkle}), his.stance_m - coachs.stance_m, kClearStance_m,
          text::Posture::Stance);
  compare(sees_front && (sees(student, {LeftShoulder, LeftHip}) || sees(student, {RightShoulder, RightHip})),
          his.spine_deg - coachs.spine_deg, kClearSpine_deg, text::Posture::Spine);
  compare(sees_side && sees(student, {LeftShoulder, RightShoulder, LeftHip, RightHip}),
          his.side_deg - coachs.side_deg, kClearSide_deg, text::Posture::Side);
  const int leg = clearer_side(student, LeftKnee, RightKnee);
  // From the front a knee that bends comes towards the camera, and only its depth would tell.
  compare(sees_front && (sees(student, {LeftKnee, LeftAnkle}) || sees(student, {RightKnee, RightAnkle})),
          his.knee_deg[leg] - coachs.knee_deg[leg], kClearKnee_deg, text::Posture::Knees);
  const int hand = clearer_side(student, LeftWrist, RightWrist);
  compare(sees_front && (sees(student, {LeftWrist}) || sees(student, {RightWrist})),
          his.hand_out_m[hand] - coachs.hand_out_m[hand], kClearHands_m, text::Posture::Hands);
  std::stable_sort(found.begin(), found.end(),
                   [](const Difference& a, const Difference& b) { return a.severity > b.severity; });
  std::vector<std::string> advice;
  for (const Difference& difference : found)
    if (advice.size() < kMostAtAddress) advice.push_back(difference.text);
  return advice;
}

}  // namespace posecoach
