#include "capture/golfer_figure.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "core/base/assert.h"
#include "core/body/standard_body.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

constexpr SurfaceColour kSkin = {0.87F, 0.65F, 0.53F};
constexpr SurfaceColour kEar = {0.72F, 0.48F, 0.40F};
constexpr SurfaceColour kBrow = {0.52F, 0.36F, 0.27F};
constexpr SurfaceColour kLips = {0.70F, 0.34F, 0.33F};
constexpr SurfaceColour kHair = {0.23F, 0.15F, 0.10F};
constexpr SurfaceColour kEyeWhite = {0.96F, 0.95F, 0.94F};
constexpr SurfaceColour kPupil = {0.10F, 0.08F, 0.08F};
constexpr SurfaceColour kShirt = {0.16F, 0.38F, 0.78F};
constexpr SurfaceColour kCollar = {0.86F, 0.89F, 0.95F};
constexpr SurfaceColour kBelt = {0.62F, 0.58F, 0.52F};
constexpr SurfaceColour kTrousers = {0.15F, 0.16F, 0.20F};
constexpr SurfaceColour kShoe = {0.96F, 0.96F, 0.96F};
constexpr SurfaceColour kSole = {0.55F, 0.55F, 0.56F};
constexpr SurfaceColour kGrip = {0.08F, 0.08F, 0.08F};
constexpr SurfaceColour kShaft = {0.72F, 0.74F, 0.77F};
constexpr SurfaceColour kClubHead = {0.46F, 0.48F, 0.52F};
constexpr SurfaceColour kBall = {1.0F, 1.0F, 1.0F};

double at_rest_distance(const Skeleton& skeleton, HumanoidJoint a, HumanoidJoint b) {
  return glm::distance(skeleton.rest_positions()[static_cast<std::size_t>(skeleton.find(a))],
                       skeleton.rest_positions()[static_cast<std::size_t>(skeleton.find(b))]);
}

}  // namespace

// A joint's place and axes in this pose.
struct GolferFigure::Body {
  struct Part {
    Vec3 origin;
    Quat rotation;
    Vec3 at(double x, double y, double z) const { return origin + rotation * Vec3(x, y, z); }
    Vec3 at(const Vec3& v) const { return origin + rotation * v; }
  };
  Part pelvis, waist, ribs, shoulders,
      head;  // origins: middle of hips, ..., middle of shoulders, middle of skull
  Vec3 neck;
  std::array<Vec3, 2> shoulder, elbow, wrist, hip, knee, ankle;
  std::array<Vec3, 2> shin_forward;
  std::array<Part, 2> hand, foot;  // foot: origin under the ankle on the sole
};

GolferFigure::GolferFigure(const Skeleton& skeleton) : skeleton_(skeleton) {
  const Skeleton average = make_standard_body({.height_m = 1.80});
  size_ =
      0.5 * (skeleton.leg_length() / average.leg_length() + skeleton.rest_height() / average.rest_height());
  breadth_ = at_rest_distance(skeleton, LeftShoulder, RightShoulder) /
             at_rest_distance(average, LeftShoulder, RightShoulder);
  hips_ = at_rest_distance(skeleton, LeftHip, RightHip) / at_rest_distance(average, LeftHip, RightHip);
  double floor = 1e9;
  for (const HumanoidJoint role : {LeftAnkle, RightAnkle, LeftToe, RightToe, LeftToeTip, RightToeTip})
    if (skeleton.has(role))
      floor = std::min(floor, skeleton.rest_positions()[static_cast<std::size_t>(skeleton.find(role))].y);
  for (const int side : {0, 1}) {
    const auto rest = [&](HumanoidJoint role) {
      return skeleton.rest_positions()[static_cast<std::size_t>(skeleton.find(role))];
    };
    const Vec3 ankle = rest(side == 0 ? LeftAnkle : RightAnkle);
    const HumanoidJoint tip = side == 0 ? LeftToeTip : RightToeTip;
    sole_[side] = {0, std::min(floor - ankle.y, -0.05 * size_), 0};
    toe_tip_[side] =
        skeleton.has(tip) ? rest(tip) - ankle : Vec3(0, sole_[side].y + 0.01 * size_, 0.225 * size_);
  }
}

GolferFigure::Body GolferFigure::place(const Posed& posed) const {
  POSECOACH_ASSERT(posed.positions.size() == static_cast<std::size_t>(skeleton_.size()) &&
                   posed.rotations.size() == posed.positions.size());
  const auto index = [&](HumanoidJoint role) { return static_cast<std::size_t>(skeleton_.find(role)); };
  const auto position = [&](HumanoidJoint role) { return posed.positions[index(role)]; };
  Body body;
  body.shoulder = {position(LeftShoulder), position(RightShoulder)};
  body.elbow = {position(LeftElbow), position(RightElbow)};
  body.wrist = {position(LeftWrist), position(RightWrist)};
  body.hip = {position(LeftHip), position(RightHip)};
  body.knee = {position(LeftKnee), position(RightKnee)};
  body.ankle = {position(LeftAnkle), position(RightAnkle)};
  body.hand[0] = {body.wrist[0], posed.rotations[index(LeftWrist)]};
  body.hand[1] = {body.wrist[1], posed.rotations[index(RightWrist)]};
  for (const std::size_t side : {0U, 1U})
    body.shin_forward[side] = posed.rotations[index(side == 0 ? LeftKnee : RightKnee)] * Vec3(0, 0, 1);
  const std::array<Quat, 2> feet = {posed.rotations[index(LeftAnkle)], posed.rotations[index(RightAnkle)]};
  for (const std::size_t side : {0U, 1U})
    body.foot[side] = {body.ankle[side] + feet[side] * sole_[side], feet[side]};

  const Quat pelvis = posed.rotations[index(Pelvis)];
  const int chest_joint = skeleton_.joint(static_cast<int>(index(LeftShoulder))).parent;
  int trunk = chest_joint;
  while (trunk != kNoJoint && skeleton_.joint(trunk).role == LeftClavicle)
    trunk = skeleton_.joint(trunk).parent;
  const Quat chest = posed.rotations[static_cast<std::size_t>(trunk)];
  body.pelvis = {0.5 * (body.hip[0] + body.hip[1]), pelvis};
  body.shoulders = {0.5 * (body.shoulder[0] + body.shoulder[1]), chest};
  const Vec3 spine = body.shoulders.origin - body.pelvis.origin;
  body.waist = {body.pelvis.origin + 0.36 * spine, glm::slerp(pelvis, chest, 0.4)};
  body.ribs = {body.pelvis.origin + 0.68 * spine, glm::slerp(pelvis, chest, 0.8)};
  body.neck = body.shoulders.at(0, 0.02 * size_, -0.015 * size_);

  Quat skull = chest;
  Vec3 base = body.shoulders.at(0, 0.10 * size_, 0.018 * size_);
  if (skeleton_.has(Head)) {
    skull = posed.rotations[index(Head)];
    base = position(Head);
  }
  const double tall =
      skeleton_.has(Head) && skeleton_.has(HeadTop) ? glm::distance(base, position(HeadTop)) : 0.193 * size_;
  body.head = {base + skull * Vec3(0, tall - 0.100 * size_, 0), skull};
  return body;
}

ConeScene GolferFigure::scene(const Posed& posed) const {
  const Body body = place(posed);
  ConeScene scene;
  const double s = size_;
  const auto cone = [&](const Vec3& a, double radius_a, const Vec3& b, double radius_b,
                        const SurfaceColour& colour) {
    scene.cones.push_back({a, b, radius_a * s, radius_b * s, colour});
  };
  const auto ball = [&](const Vec3& centre, double radius, const SurfaceColour& colour) {
    cone(centre, radius, centre, radius, colour);
  };
  const auto mix = [](const Vec3& a, const Vec3& b, double part) { return a + part * (b - a); };

  // Head: skull, jaw, hair, face. Offsets from the middle of the skull, in metres for a stature of 1.80 m.
  const auto face = [&](double x, double y, double z) { return body.head.at(x * s, y * s, z * s); };
  cone(face(0, 0.022, -0.012), 0.078, face(0, 0.014, 0.020), 0.073, kSkin);
  cone(face(0, -0.012, 0.026), 0.062, face(0, -0.074, 0.046), 0.035, kSkin);
  cone(face(-0.020, -0.064, 0.040), 0.034, face(0.020, -0.064, 0.040), 0.034, kSkin);
  cone(face(0, 0.036, -0.026), 0.083, face(0, -0.006, -0.036), 0.073, kHair);
  cone(face(-0.020, 0.064, -0.006), 0.058, face(0.020, 0.064, -0.006), 0.058, kHair);
  cone(face(0, 0.076, -0.010), 0.054, face(0, 0.078, 0.018), 0.034, kHair);
  cone(face(-0.032, 0.074, 0.026), 0.026, face(0.032, 0.074, 0.026), 0.026, kHair);
  for (const double side : {1.0, -1.0}) {
    cone(face(side * 0.026, 0.012, 0.083), 0.0115, face(side * 0.037, 0.012, 0.081), 0.0105, kEyeWhite);
    ball(face(side * 0.031, 0.011, 0.0875), 0.0085, kPupil);
    cone(face(side * 0.015, 0.034, 0.089), 0.0045, face(side * 0.046, 0.035, 0.079), 0.0040, kBrow);
    cone(face(side * 0.076, 0.016, -0.004), 0.017, face(side * 0.075, -0.020, 0.002), 0.012, kSkin);
    ball(face(side * 0.084, 0.002, 0.004), 0.009, kEar);
  }
  cone(face(0, 0.014, 0.091), 0.010, face(0, -0.018, 0.106), 0.0150, kSkin);
  for (const double side : {1.0, -1.0}) ball(face(side * 0.010, -0.026, 0.104), 0.0075, kSkin);
  cone(face(-0.022, -0.047, 0.083), 0.0065, face(0.022, -0.047, 0.083), 0.0065, kLips);
  cone(body.shoulders.at(0, 0.015 * s, -0.010 * s), 0.060, face(0, -0.060, -0.012), 0.054, kSkin);
  cone(body.shoulders.at(-0.020 * s, 0.030 * s, 0.000 * s), 0.050,
       body.shoulders.at(0.020 * s, 0.030 * s, 0.000 * s), 0.050, kCollar);

  // Trunk: columns side by side give it breadth.
  const double wide = breadth_, hips = hips_;
  const auto shoulders = [&](double x, double y, double z) {
    return body.shoulders.at(x * s * wide, y * s, z * s);
  };
  const auto ribs = [&](double x, double z) { return body.ribs.at(x * s * wide, 0, z * s); };
  const auto waist = [&](double x, double z) { return body.waist.at(x * s * 0.5 * (wide + hips), 0, z * s); };
  const auto pelvis = [&](double x, double y, double z) {
    return body.pelvis.at(x * s * hips, y * s, z * s);
  };
  for (const double side : {1.0, -1.0}) {
    const std::size_t i = side > 0 ? 0 : 1;
    cone(body.neck, 0.056, mix(body.neck, body.shoulder[i], 0.80), 0.058, kShirt);
    cone(shoulders(side * 0.085, -0.055, 0.005), 0.098, ribs(side * 0.078, 0.008), 0.094, kShirt);
    cone(mix(body.shoulders.origin, body.shoulder[i], 0.80), 0.068, ribs(side * 0.086, 0.0), 0.080, kShirt);
    cone(ribs(side * 0.078, 0.008), 0.094, waist(side * 0.070, 0.004), 0.086, kShirt);
    cone(waist(side * 0.070, 0.004), 0.086, pelvis(side * 0.074, 0.120, -0.002), 0.088, kShirt);
    cone(pelvis(side * 0.074, 0.098, -0.002), 0.0905, pelvis(side * 0.074, 0.090, -0.002), 0.0905, kBelt);
    cone(pelvis(side * 0.075, 0.085, -0.003), 0.0895, pelvis(side * 0.088, -0.030, -0.012), 0.094, kTrousers);
  }
  cone(shoulders(0, -0.050, 0.010), 0.100, ribs(0, 0.018), 0.096, kShirt);
  cone(ribs(0, 0.018), 0.096, waist(0, 0.010), 0.090, kShirt);
  cone(waist(0, 0.010), 0.090, pelvis(0, 0.120, 0.002), 0.091, kShirt);
  cone(pelvis(0, 0.099, 0.001), 0.0925, pelvis(0, 0.091, 0.001), 0.0925, kBelt);
  cone(pelvis(0, 0.086, 0.001), 0.0915, pelvis(0, -0.020, -0.012), 0.090, kTrousers);

  for (const std::size_t i : {0U, 1U}) {
    // Arms: a short sleeve, then skin.
    const Vec3 sleeve = mix(body.shoulder[i], body.elbow[i], 0.50);
    cone(body.shoulder[i], 0.060, sleeve, 0.051, kShirt);
    cone(sleeve, 0.044, body.elbow[i], 0.034, kSkin);
    cone(body.elbow[i], 0.035, mix(body.elbow[i], body.wrist[i], 0.28), 0.041, kSkin);
    cone(mix(body.elbow[i], body.wrist[i], 0.28), 0.041, body.wrist[i], 0.025, kSkin);
    // Legs.
    cone(body.hip[i], 0.092, mix(body.hip[i], body.knee[i], 0.5), 0.076, kTrousers);
    cone(mix(body.hip[i], body.knee[i], 0.5), 0.076, body.knee[i], 0.058, kTrousers);
    const Vec3 kneecap = body.knee[i] + body.shin_forward[i] * (0.014 * s);
    cone(mix(kneecap, body.hip[i], 0.06), 0.053, kneecap, 0.050, kTrousers);
    cone(body.knee[i], 0.056, mix(body.knee[i], body.ankle[i], 0.35), 0.058, kTrousers);
    cone(mix(body.knee[i], body.ankle[i], 0.35), 0.058, mix(body.knee[i], body.ankle[i], 0.96), 0.044,
         kTrousers);
    // Shoes: heel, upper, toes, sole.
    const auto& foot = body.foot[i];
    const double length = toe_tip_[i].z;
    const auto shoe = [&](double x, double y, double z) { return foot.at(x * s, y * s, z); };
    cone(shoe(0, 0.034, -0.022 * s), 0.034, shoe(0, 0.036, 0.010 * s), 0.036, kShoe);
    cone(shoe(0, 0.036, 0.010 * s), 0.036, shoe(0, 0.036, 0.70 * length), 0.035, kShoe);
    cone(shoe(0.010, 0.034, 0.62 * length), 0.033, shoe(0.004, 0.030, 0.90 * length), 0.027, kShoe);
    cone(shoe(-0.010, 0.034, 0.62 * length), 0.033, shoe(-0.004, 0.030, 0.90 * length), 0.027, kShoe);
    cone(shoe(0, 0.016, -0.030 * s), 0.018, shoe(0, 0.016, 0.94 * length), 0.018, kSole);
    // Hands: palm, fingers round the grip, thumb along it.
    const double out = i == 0 ? 1.0 : -1.0;
    const auto hand = [&](double along, double up, double thumb) {
      return body.hand[i].at(out * along * s, up * s, thumb * s);
    };
    cone(hand(0.010, 0, 0), 0.028, hand(0.060, 0.004, 0.012), 0.034, kSkin);
    cone(hand(0.060, 0.004, -0.018), 0.026, hand(0.064, 0.002, 0.026), 0.026, kSkin);
    cone(hand(0.066, -0.024, -0.024), 0.017, hand(0.068, -0.024, 0.030), 0.017, kSkin);
    cone(hand(0.030, -0.012, 0.028), 0.014, hand(0.062, -0.020, 0.058), 0.011, kSkin);
  }

  // Club: its sizes do not follow the body's.
  const auto fixed = [&](const Vec3& a, double radius_a, const Vec3& b, double radius_b,
                         const SurfaceColour& colour) {
    scene.cones.push_back({a, b, radius_a, radius_b, colour});
  };
  const ClubPose& club = posed.club;
  const Vec3 shaft = glm::normalize(club.head - club.butt);
  fixed(club.butt, 0.013, club.grip + shaft * 0.16, 0.010, kGrip);
  fixed(club.grip + shaft * 0.16, 0.0065, club.head, 0.0060, kShaft);
  // The head points away from the golfer's feet side: along the part of the ground normal across the shaft.
  Vec3 toe = glm::cross(glm::cross(shaft, Vec3(0, 0, 1)), shaft);
  if (glm::length(toe) < 1e-6) toe = Vec3(0, 0, 1);
  toe = glm::normalize(toe);
  if (posed.is_putter)
    fixed(club.head - toe * 0.02, 0.015, club.head + toe * 0.085, 0.015, kClubHead);
  else
    fixed(club.head, 0.014, club.head + toe * 0.065, 0.020, kClubHead);
  if (posed.ball) fixed(*posed.ball, 0.0214, *posed.ball, 0.0214, kBall);

  for (const std::size_t i : {0U, 1U}) {
    const Vec3 heel = body.foot[i].at(0, 0, -0.04 * s), tip = body.foot[i].at(0, 0, toe_tip_[i].z);
    scene.shadows.push_back({heel, tip, 0.13 * s, 0.55});
  }
  const Vec3 between = mix(body.foot[0].origin, body.foot[1].origin, 0.5);
  scene.shadows.push_back(
      {mix(between, body.foot[0].origin, 0.7), mix(between, body.foot[1].origin, 0.7), 0.55 * s, 0.30});
  if (posed.ball) scene.shadows.push_back({*posed.ball, *posed.ball, 0.045, 0.5});
  return scene;
}

LandmarkArray<Vec3> GolferFigure::landmarks(const Posed& posed) const {
  using enum Landmark;
  const Body body = place(posed);
  const double s = size_;
  const auto face = [&](double x, double y, double z) { return body.head.at(x * s, y * s, z * s); };
  LandmarkArray<Vec3> points{};
  points[Nose] = face(0, -0.018, 0.120);
  const std::array<std::array<Landmark, 5>, 2> faces = {
      {{LeftEyeInner, LeftEye, LeftEyeOuter, LeftEar, MouthLeft},
       {RightEyeInner, RightEye, RightEyeOuter, RightEar, MouthRight}}};
  const std::array<std::array<Landmark, 12>, 2> limbs = {
      {{Landmark::LeftShoulder, Landmark::LeftElbow, Landmark::LeftWrist, LeftPinky, LeftIndex, LeftThumb,
        Landmark::LeftHip, Landmark::LeftKnee, Landmark::LeftAnkle, LeftHeel, LeftFootIndex, LeftFootIndex},
       {Landmark::RightShoulder, Landmark::RightElbow, Landmark::RightWrist, RightPinky, RightIndex,
        RightThumb, Landmark::RightHip, Landmark::RightKnee, Landmark::RightAnkle, RightHeel, RightFootIndex,
        RightFootIndex}}};
  for (const std::size_t i : {0U, 1U}) {
    const double side = i == 0 ? 1.0 : -1.0;
    points[faces[i][0]] = face(side * 0.019, 0.012, 0.090);
    points[faces[i][1]] = face(side * 0.031, 0.012, 0.092);
    points[faces[i][2]] = face(side * 0.044, 0.012, 0.084);
    points[faces[i][3]] = face(side * 0.083, 0.000, 0.002);
    points[faces[i][4]] = face(side * 0.024, -0.047, 0.087);
    const auto hand = [&](double along, double up, double thumb) {
      return body.hand[i].at(side * along * s, up * s, thumb * s);
    };
    points[limbs[i][0]] = body.shoulder[i];
    points[limbs[i][1]] = body.elbow[i];
    points[limbs[i][2]] = body.wrist[i];
    points[limbs[i][3]] = hand(0.066, 0.004, -0.026);
    points[limbs[i][4]] = hand(0.072, 0.004, 0.030);
    points[limbs[i][5]] = hand(0.050, -0.014, 0.044);
    points[limbs[i][6]] = body.hip[i];
    points[limbs[i][7]] = body.knee[i];
    points[limbs[i][8]] = body.ankle[i];
    points[limbs[i][9]] = body.foot[i].at(0, 0.020 * s, -0.050 * s);
    points[limbs[i][10]] = body.foot[i].at(0, 0.020 * s, toe_tip_[i].z);
  }
  return points;
}

}  // namespace posecoach
