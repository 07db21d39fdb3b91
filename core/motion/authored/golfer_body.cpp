#include "core/motion/authored/golfer_body.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/body/standard_body.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

// From `ancestor` (left out) down to `joint`, or empty when it is no ancestor.
std::vector<int> chain(const Skeleton& skeleton, int ancestor, int joint) {
  std::vector<int> path;
  for (; joint != kNoJoint && joint != ancestor; joint = skeleton.joint(joint).parent) path.push_back(joint);
  if (joint != ancestor) return {};
  std::reverse(path.begin(), path.end());
  return path;
}

bool is_above(const Skeleton& skeleton, int ancestor, int joint) {
  while (joint != kNoJoint && joint != ancestor) joint = skeleton.joint(joint).parent;
  return joint == ancestor;
}

Vec3 rest(const Skeleton& skeleton, int joint) {
  return skeleton.rest_positions()[static_cast<std::size_t>(joint)];
}

Limb make_limb(const Skeleton& skeleton, std::array<HumanoidJoint, 3> roles, const Vec3& bend) {
  Limb limb;
  limb.upper = skeleton.find(roles[0]);
  limb.middle = skeleton.find(roles[1]);
  limb.end = skeleton.find(roles[2]);
  const Vec3 upper = rest(skeleton, limb.middle) - rest(skeleton, limb.upper);
  const Vec3 lower = rest(skeleton, limb.end) - rest(skeleton, limb.middle);
  limb.upper_length = glm::length(upper);
  limb.lower_length = glm::length(lower);
  limb.upper_rest = upper / limb.upper_length;
  limb.lower_rest = lower / limb.lower_length;
  limb.bend_rest = bend;
  return limb;
}

}  // namespace

double Limb::reach(double flexion) const {
  return std::sqrt(upper_length * upper_length + lower_length * lower_length +
                   2 * upper_length * lower_length * std::cos(flexion));
}

Result<GolferBody> GolferBody::make(const Skeleton& skeleton) {
  std::string missing;
  for (const HumanoidJoint role : {Pelvis, LeftShoulder, LeftElbow, LeftWrist, RightShoulder, RightElbow,
                                   RightWrist, LeftHip, LeftKnee, LeftAnkle, RightHip, RightKnee, RightAnkle})
    if (!skeleton.has(role)) missing += (missing.empty() ? "" : ", ") + std::string(to_string(role));
  if (!missing.empty())
    return fail(ErrorCode::Incomplete, "this body cannot swing a club: it has no " + missing);

  GolferBody body{.skeleton = skeleton};
  body.pelvis = skeleton.find(Pelvis);
  const int left_shoulder = skeleton.find(LeftShoulder), right_shoulder = skeleton.find(RightShoulder);
  body.chest = skeleton.joint(left_shoulder).parent;
  while (body.chest != kNoJoint && !is_above(skeleton, body.chest, right_shoulder))
    body.chest = skeleton.joint(body.chest).parent;
  body.back = body.chest == kNoJoint ? std::vector<int>{} : chain(skeleton, body.pelvis, body.chest);
  if (body.back.empty())
    return fail(ErrorCode::Incomplete,
                "this body cannot swing a club: it has no back between pelvis and shoulders");
  if (skeleton.has(Head)) body.neck = chain(skeleton, body.chest, skeleton.find(Head));

  body.arms = {make_limb(skeleton, {LeftShoulder, LeftElbow, LeftWrist}, {0, 0, -1}),
               make_limb(skeleton, {RightShoulder, RightElbow, RightWrist}, {0, 0, -1})};
  body.legs = {make_limb(skeleton, {LeftHip, LeftKnee, LeftAnkle}, {0, 0, 1}),
               make_limb(skeleton, {RightHip, RightKnee, RightAnkle}, {0, 0, 1})};
  for (const Limb* limb : {&body.arms[0], &body.arms[1], &body.legs[0], &body.legs[1]})
    if (limb->upper_length < 1e-6 || limb->lower_length < 1e-6)
      return fail(ErrorCode::Incomplete, "this body cannot swing a club: " +
                                             skeleton.joint(limb->middle).name + " has a bone of no length");
  body.clavicles = {skeleton.find(LeftClavicle), skeleton.find(RightClavicle)};
  body.toes = {skeleton.find(LeftToe), skeleton.find(RightToe)};

  double floor = rest(skeleton, body.legs[Lead].end).y;
  for (const HumanoidJoint role : {RightAnkle, LeftToe, RightToe, LeftToeTip, RightToeTip})
    if (skeleton.has(role)) floor = std::min(floor, rest(skeleton, skeleton.find(role)).y);
  const double stature = skeleton.leg_length() / 0.491;
  for (const Side side : {Lead, Trail}) {
    const Vec3 ankle = rest(skeleton, body.legs[side].end);
    body.ankle_to_toe[side] = body.toes[side] == kNoJoint ? Vec3(0, -0.03 * stature, 0.09 * stature)
                                                          : rest(skeleton, body.toes[side]) - ankle;
    body.ankle_height += 0.5 * (ankle.y - floor);
  }
  if (body.toes[Lead] == kNoJoint) body.ankle_height = std::max(body.ankle_height, 0.039 * stature);
  const Skeleton usual = make_standard_body({.height_m = 1.80});
  const auto distance = [](const Skeleton& of, HumanoidJoint a, HumanoidJoint b) {
    return glm::distance(rest(of, of.find(a)), rest(of, of.find(b)));
  };
  body.hip_distance = distance(skeleton, LeftHip, RightHip);
  body.usual_hip_distance = distance(usual, LeftHip, RightHip);
  body.usual_shoulder_distance = distance(usual, LeftShoulder, RightShoulder);
  body.size = skeleton.leg_length() / usual.leg_length();
  body.middle_of_hips_from_pelvis =
      0.5 * (rest(skeleton, body.legs[Lead].upper) + rest(skeleton, body.legs[Trail].upper)) -
      rest(skeleton, body.pelvis);
  return body;
}

}  // namespace posecoach
