#include "core/transfer/synthetic_body.h"

#include <algorithm>
#include <cmath>

#include "core/body/two_bone_ik.h"

namespace posecoach {
namespace {

constexpr double kShortest = 1e-6;

double uniform(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
double normal(std::mt19937_64& random, double deviation) {
  return std::normal_distribution<double>(0, deviation)(random);
}

// Columns: to the person's left, up along `up`, forwards.
Mat3 frame_of(const Vec3& up, const Vec3& to_left) {
  const Vec3 y = glm::length(up) > kShortest ? glm::normalize(up) : Vec3{0, 1, 0};
  Vec3 x = to_left - glm::dot(to_left, y) * y;
  if (glm::length(x) < kShortest) x = std::abs(y.x) < 0.9 ? Vec3{1, 0, 0} - y.x * y : Vec3{0, 0, 1} - y.z * y;
  x = glm::normalize(x);
  return {x, y, glm::cross(x, y)};
}

// `direction` turned as if the limb's rest direction `rest` had been `rest + change`, all in `frame`.
Vec3 with_rest_change(const Vec3& direction, const Mat3& frame, const Vec3& rest, const Vec3& change) {
  const double length = glm::length(direction);
  if (length < kShortest) return direction;
  const Quat swing = swing_between(frame * rest, direction);
  return glm::normalize(swing * (frame * (rest + change))) * length;
}

}  // namespace

SyntheticBody random_body(std::mt19937_64& random, SyntheticVariety variety) {
  const bool extreme = variety == SyntheticVariety::Extreme ||
                       (variety == SyntheticVariety::Mixed && uniform(random, 0, 1) < 0.5);
  const double spread = extreme ? 0.34 : 0.09;
  const auto factor = [&] {
    return std::exp(std::clamp(normal(random, spread), -2.2 * spread, 2.2 * spread));
  };
  const double stature = extreme ? uniform(random, 0.8, 2.1) : uniform(random, 1.3, 2.0);
  const double torso = factor(), head = factor(), shoulders = factor();
  const double hips = factor() * (extreme ? uniform(random, 0.8, 2.2) : uniform(random, 0.9, 1.3));
  const double arms = factor(), legs = factor();
  // The two bones of a limb belong together in people; cartoon characters care little.
  const auto own = [&] { return extreme ? std::pow(factor(), 0.8) : std::sqrt(factor()); };
  const double forearms = arms * own(), shins = legs * own();
  const double upper_arms = arms * own(), thighs = legs * own();
  const std::array<double, kBone2dCount> factors = {torso,      head,     shoulders, shoulders, upper_arms,
                                                    upper_arms, forearms, forearms,  hips,      hips,
                                                    thighs,     thighs,   shins,     shins};
  SyntheticBody body;
  for (std::size_t b = 0; b < kBone2dCount; ++b)
    body.length_m[b] = stature * kAverageBoneLengths[b] * factors[b];
  // Some rigs know only the base of the skull, films know the tip of the nose.
  const bool has_nose = uniform(random, 0, 1) < 0.5;
  body.nose_forward_up_m = stature * head *
                           (has_nose ? Vec2{uniform(random, 0.0, 0.1), uniform(random, -0.04, 0.05)}
                                     : Vec2{normal(random, 0.025), normal(random, 0.01)});
  const double angle = extreme ? 0.08 : 0.05;
  body.spine_lean = normal(random, extreme ? 0.09 : 0.06);
  body.thigh_splay = {normal(random, angle), normal(random, 0.6 * angle)};
  body.shin_splay = {normal(random, angle), normal(random, angle)};
  body.shoulder_lift = normal(random, 0.6 * angle);
  return body;
}

Pose3d on_body(const Pose3d& recorded, const std::array<double, kBone2dCount>& recorded_lengths,
               const SyntheticBody& body) {
  const Vec3 up = recorded[Joint2d::Neck] - recorded[Joint2d::MidHip];
  const Mat3 pelvis = frame_of(up, recorded[Joint2d::LeftHip] - recorded[Joint2d::RightHip]);
  const Mat3 chest = frame_of(up, recorded[Joint2d::LeftShoulder] - recorded[Joint2d::RightShoulder]);
  Pose3d result;
  result[Joint2d::MidHip] = recorded[Joint2d::MidHip];
  for (std::size_t b = 0; b < kBone2dCount; ++b) {
    const Bone2d& bone = kBones2d[b];
    Vec3 vector = recorded[bone.child] - recorded[bone.parent];
    const double side = bone.twin < b ? -1 : 1;  // right bones stand after their left twins
    switch (bone.child) {
      case Joint2d::Neck:
        vector = glm::angleAxis(body.spine_lean, pelvis[0]) * vector;
        break;
      case Joint2d::LeftElbow:
      case Joint2d::RightElbow:
        vector = with_rest_change(vector, chest, {side, 0, 0}, {0, body.shoulder_lift, 0});
        break;
      case Joint2d::LeftKnee:
      case Joint2d::RightKnee:
        vector =
            with_rest_change(vector, pelvis, {0, -1, 0}, {side * body.thigh_splay.x, 0, body.thigh_splay.y});
        break;
      case Joint2d::LeftAnkle:
      case Joint2d::RightAnkle:
        vector =
            with_rest_change(vector, pelvis, {0, -1, 0}, {side * body.shin_splay.x, 0, body.shin_splay.y});
        break;
      default:
        break;
    }
    vector *= body.length_m[b] / std::max(recorded_lengths[b], 1e-3);
    if (bone.child == Joint2d::Nose)
      vector += chest * Vec3{0, body.nose_forward_up_m.y, body.nose_forward_up_m.x};
    result[bone.child] = result[bone.parent] + vector;
  }
  return result;
}

}  // namespace posecoach
