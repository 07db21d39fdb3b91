#include "core/motion/authored/golfer_poser.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/index.h"
#include "core/body/two_bone_ik.h"

namespace posecoach {
namespace {

using enum GolfChannel;

const Vec3 kUp(0, 1, 0);

Quat about_up(double degrees) {
  return glm::angleAxis(radians_from_degrees(degrees), kUp);
}

// Right-handed axes with the first along `along` and the second towards `side`.
Mat3 axes(const Vec3& along, const Vec3& side) {
  const Vec3 z = glm::normalize(glm::cross(along, side));
  return {along, glm::cross(z, along), z};
}

Quat rotation_between(const Mat3& from, const Mat3& to) {
  return glm::normalize(glm::quat_cast(to * glm::transpose(from)));
}

// Smooth minimum: never above either, at most `softness * ln 2` below the smaller.
double soft_minimum(double a, double b, double softness) {
  return std::min(a, b) - softness * std::log1p(std::exp(-std::abs(a - b) / softness));
}

// Direction at an angle in a plane through the target line, see golf_channels.h.
Vec3 direction_in_plane(double angle_deg, double plane_deg) {
  const double angle = radians_from_degrees(angle_deg), plane = radians_from_degrees(plane_deg);
  return {std::sin(angle), -std::sin(plane) * std::cos(angle), std::cos(plane) * std::cos(angle)};
}

// Distance along a ray from inside a ball to its surface.
double distance_to_sphere(const Vec3& start, const Vec3& direction, const Vec3& centre, double radius) {
  const Vec3 to_start = start - centre;
  const double b = glm::dot(to_start, direction);
  return -b + std::sqrt(std::max(0.0, b * b - glm::dot(to_start, to_start) + radius * radius));
}

// Where the wrists are in the club's axes (shaft to the head, face normal, out of the swing plane), and where
// each hand's middle is along the shaft; metres.
constexpr std::array<std::array<double, 3>, 2> kWristFromGrip = {
    {{-0.070, 0.014, 0.042}, {0.008, -0.016, 0.046}}};
constexpr std::array<double, 2> kHandFromGrip = {-0.038, 0.042};

// Of the club's head over the ground.
constexpr double kHeadCentre = 0.02;

// Legs and arms bend at least so much: a joint that locks would jerk.
constexpr double kStraightestKnee = 0.10;

// Sets the rotations of a limb's two bones from where its joints shall be.
void turn_limb(const Limb& limb, const Vec3& root, const TwoBoneSolution& solution,
               std::vector<Quat>& global) {
  const Vec3 upper = glm::normalize(solution.middle - root);
  const Vec3 lower = glm::normalize(solution.end - solution.middle);
  const Vec3 straight = glm::normalize(solution.end - root);
  Vec3 bend = (solution.middle - root) - straight * glm::dot(straight, solution.middle - root);
  if (glm::length(bend) < 1e-9) bend = global[index(limb.upper)] * limb.bend_rest;
  global[index(limb.upper)] = rotation_between(axes(limb.upper_rest, limb.bend_rest), axes(upper, bend));
  global[index(limb.middle)] = rotation_between(axes(limb.lower_rest, limb.bend_rest), axes(lower, bend));
}

// Joints that nothing turned follow their parent.
void inherit(const Skeleton& skeleton, const std::vector<bool>& set, std::vector<Quat>& global) {
  for (int i = 0; i < skeleton.size(); ++i)
    if (!set[index(i)] && skeleton.joint(i).parent != kNoJoint)
      global[index(i)] = global[index(skeleton.joint(i).parent)];
}

}  // namespace

struct GolferPoser::Torso {
  Vec3 middle_of_hips;
  std::vector<Quat> global;  // of every joint; limbs follow the torso for now
  std::vector<Vec3> positions;
};

struct GolferPoser::Grip {
  Vec3 point, shaft, face, normal;  // unit axes of the club
  Vec3 wrist(int side) const {
    const auto& offset = kWristFromGrip[index(side)];
    return point + shaft * offset[0] + face * offset[1] + normal * offset[2];
  }
};

struct GolferPoser::Foot {
  Vec3 ankle;
  Quat foot, toes;
};

Quat GolferPoser::segment_rotation(double turn_deg, double bend_deg, double side_deg) const {
  const Vec3 axis = glm::normalize(
      Vec3(-std::tan(radians_from_degrees(side_deg)), 1, std::tan(radians_from_degrees(bend_deg))));
  return swing_between(kUp, axis) * about_up(turn_deg);
}

Vec3 GolferPoser::planted_ankle(int side) const {
  // As wide as the script says on the body that it was written for; on others the legs spread alike.
  const double hips = 0.5 * body_.hip_distance;
  const double half =
      hips + body_.size * 0.5 *
                 (stance_.width_of_shoulders * body_.usual_shoulder_distance - body_.usual_hip_distance);
  return {side == GolferBody::Lead ? half : -half, body_.ankle_height, 0};
}

GolferPoser::Foot GolferPoser::foot(int side, const GolfPose& numbers) const {
  const bool lead = side == GolferBody::Lead;
  const double flare = lead ? stance_.lead_flare_deg : -stance_.trail_flare_deg;
  const Vec3 ball_of_toes = planted_ankle(side) + about_up(flare) * body_.ankle_to_toe[index(side)];
  const double spin = lead ? 0.0 : numbers[TrailFootSpin], lift = lead ? 0.0 : numbers[TrailHeelLift];
  Foot foot;
  foot.toes = about_up(flare + spin);
  foot.foot = foot.toes * glm::angleAxis(radians_from_degrees(lift), Vec3(1, 0, 0));
  foot.ankle = ball_of_toes - foot.foot * body_.ankle_to_toe[index(side)];
  return foot;
}

double GolferPoser::address_hips_height() const {
  const Limb& leg = body_.legs[GolferBody::Lead];
  const double reach = leg.reach(radians_from_degrees(stance_.knee_flex_deg));
  const Vec3 hip = body_.skeleton.rest_positions()[index(leg.upper)];
  const Vec3 other = body_.skeleton.rest_positions()[index(body_.legs[GolferBody::Trail].upper)];
  const double sideways = planted_ankle(GolferBody::Lead).x - 0.5 * std::abs(hip.x - other.x);
  const double back = stance_.hips_back_cm / 100 * body_.size;
  return body_.ankle_height + std::sqrt(std::max(0.01, reach * reach - sideways * sideways - back * back));
}

GolferPoser::Torso GolferPoser::place_torso(const GolfPose& numbers) const {
  const Skeleton& skeleton = body_.skeleton;
  const Quat pelvis = segment_rotation(numbers[PelvisTurn], numbers[PelvisBend] + 0.6 * bend_offset_deg_,
                                       numbers[PelvisSide]);
  const Quat chest =
      segment_rotation(numbers[ChestTurn], numbers[ChestBend] + bend_offset_deg_, numbers[ChestSide]);
  Torso torso;
  torso.global.assign(index(skeleton.size()), Quat(1, 0, 0, 0));
  std::vector<bool> set(index(skeleton.size()), false);
  const auto turn = [&](int joint, const Quat& rotation) {
    torso.global[index(joint)] = rotation;
    set[index(joint)] = true;
  };
  turn(body_.pelvis, pelvis);
  for (std::size_t i = 0; i < body_.back.size(); ++i)
    turn(body_.back[i],
         glm::slerp(pelvis, chest, static_cast<double>(i + 1) / static_cast<double>(body_.back.size())));
  for (const int side : {GolferBody::Lead, GolferBody::Trail}) {
    const int clavicle = body_.clavicles[index(side)];
    if (clavicle == kNoJoint) continue;
    const bool lead = side == GolferBody::Lead;
    const double sign = lead ? 1 : -1;
    const double forward = numbers[lead ? LeadShoulderForward : TrailShoulderForward];
    const double up = numbers[lead ? LeadShoulderUp : TrailShoulderUp];
    turn(clavicle,
         chest * about_up(-sign * forward) * glm::angleAxis(radians_from_degrees(sign * up), Vec3(0, 0, 1)));
  }
  inherit(skeleton, set, torso.global);

  const double scale = body_.size / 100;
  torso.middle_of_hips = {
      numbers[PelvisSway] * scale,
      hips_height_m_ - hips_offset_m_ - sink_at_impact_m_ * numbers[BallAim] + numbers[PelvisLift] * scale,
      (numbers[PelvisThrust] - stance_.hips_back_cm) * scale};
  // Both feet must stay in reach.
  for (const int side : {GolferBody::Lead, GolferBody::Trail}) {
    const Limb& leg = body_.legs[index(side)];
    const Vec3 hip_from_middle =
        pelvis * (skeleton.rest_positions()[index(leg.upper)] -
                  skeleton.rest_positions()[index(body_.pelvis)] - body_.middle_of_hips_from_pelvis);
    const Vec3 ankle = foot(side, numbers).ankle;
    const Vec3 hip = torso.middle_of_hips + hip_from_middle;
    const double reach = leg.reach(kStraightestKnee);
    const double flat = (hip.x - ankle.x) * (hip.x - ankle.x) + (hip.z - ankle.z) * (hip.z - ankle.z);
    const double highest = ankle.y + std::sqrt(std::max(0.0, reach * reach - flat)) - hip_from_middle.y;
    torso.middle_of_hips.y = soft_minimum(torso.middle_of_hips.y, highest, 0.008 * body_.size);
  }

  const Vec3 pelvis_position = torso.middle_of_hips - pelvis * body_.middle_of_hips_from_pelvis;
  torso.positions.resize(index(skeleton.size()));
  joint_positions(skeleton, Vec3(0), torso.global, torso.positions);
  const Vec3 shift = pelvis_position - torso.positions[index(body_.pelvis)];
  for (Vec3& position : torso.positions) position += shift;
  return torso;
}

void GolferPoser::place_head(const GolfPose& numbers, std::vector<Quat>& global) const {
  const Quat chest = global[index(body_.chest)];
  const Quat head =
      segment_rotation(numbers[HeadTurn], numbers[HeadBend] + 0.5 * bend_offset_deg_, numbers[HeadSide]);
  for (std::size_t i = 0; i < body_.neck.size(); ++i)
    global[index(body_.neck[i])] =
        glm::slerp(chest, head, static_cast<double>(i + 1) / static_cast<double>(body_.neck.size()));
}

GolferPoser::Grip GolferPoser::place_grip(const GolfPose& numbers,
                                          const std::array<Vec3, 2>& shoulders) const {
  const Vec3 hub = 0.5 * (shoulders[0] + shoulders[1]);
  const Vec3 to_hands = glm::normalize(direction_in_plane(numbers[HandsAngle], numbers[HandsPlane]) +
                                       Vec3(0, 0, std::tan(radians_from_degrees(numbers[HandsOut]))));
  const double angle = radians_from_degrees(numbers[ClubAngle]);
  // The body's own lie counts where the club is low.
  const double plane_deg = numbers[ClubPlane] + lie_offset_deg_ * 0.5 * (1 + std::cos(angle));
  const double plane = radians_from_degrees(plane_deg);
  const Vec3 keyed_shaft = direction_in_plane(numbers[ClubAngle], plane_deg);
  const Vec3 up_plane(0, std::sin(plane), -std::cos(plane)),
      plane_normal(0, std::cos(plane), std::sin(plane));
  const Vec3 along_arc = up_plane * std::sin(angle) + Vec3(1, 0, 0) * std::cos(angle);
  const double roll = radians_from_degrees(numbers[ClubRoll]);

  const Quat aim = glm::slerp(Quat(1, 0, 0, 0), aim_at_impact_, numbers[BallAim]);
  Grip grip;
  grip.shaft = aim * keyed_shaft;
  grip.normal = aim * (plane_normal * std::cos(roll) + along_arc * std::sin(roll));
  grip.face = aim * (along_arc * std::cos(roll) - plane_normal * std::sin(roll));
  double reach = 1e9;
  for (const int side : {GolferBody::Lead, GolferBody::Trail}) {
    const Limb& arm = body_.arms[index(side)];
    const double flexion = radians_from_degrees(numbers[side == GolferBody::Lead ? LeadElbow : TrailElbow]);
    const Vec3 wrist_offset = grip.wrist(side) - grip.point;
    const double distance =
        distance_to_sphere(hub, to_hands, shoulders[index(side)] - wrist_offset, arm.reach(flexion));
    reach = side == GolferBody::Lead ? distance : soft_minimum(reach, distance, 0.006 * body_.size);
  }
  grip.point = hub + to_hands * reach;
  return grip;
}

double GolferPoser::place_arms(const GolfPose& numbers, const Grip& grip,
                               const std::array<Vec3, 2>& shoulders, std::vector<Quat>& global) const {
  double deficit = 0;
  const Quat chest = global[index(body_.chest)];
  for (const int side : {GolferBody::Lead, GolferBody::Trail}) {
    const bool lead = side == GolferBody::Lead;
    const Limb& arm = body_.arms[index(side)];
    const double out = numbers[lead ? LeadElbowOut : TrailElbowOut];
    const Vec3 points_to = chest * Vec3(lead ? out : -out, -numbers[lead ? LeadElbowDown : TrailElbowDown],
                                        -numbers[lead ? LeadElbowBack : TrailElbowBack]);
    const Vec3 wrist = grip.wrist(side);
    const TwoBoneSolution solution =
        solve_two_bones(shoulders[index(side)], wrist, shoulders[index(side)] + points_to, arm.upper_length,
                        arm.lower_length);
    deficit = std::max(deficit, solution.deficit);
    turn_limb(arm, shoulders[index(side)], solution, global);
    // The hand lies across the grip with the thumb down the shaft.
    const Vec3 fingers = glm::normalize(grip.point + grip.shaft * kHandFromGrip[index(side)] - wrist);
    global[index(arm.end)] =
        rotation_between(axes(Vec3(lead ? 1 : -1, 0, 0), Vec3(0, 0, 1)), axes(fingers, grip.shaft));
  }
  return deficit;
}

double GolferPoser::place_legs(const GolfPose& numbers, const std::array<Vec3, 2>& hips,
                               std::vector<Quat>& global) const {
  double deficit = 0;
  for (const int side : {GolferBody::Lead, GolferBody::Trail}) {
    const Limb& leg = body_.legs[index(side)];
    const Foot planted = foot(side, numbers);
    const Vec3 forward =
        about_up(numbers[side == GolferBody::Lead ? LeadKneeYaw : TrailKneeYaw]) * Vec3(0, 0, 1);
    const TwoBoneSolution solution = solve_two_bones(
        hips[index(side)], planted.ankle, hips[index(side)] + forward, leg.upper_length, leg.lower_length);
    deficit = std::max(deficit, solution.deficit);
    turn_limb(leg, hips[index(side)], solution, global);
    global[index(leg.end)] = planted.foot;
    if (body_.toes[index(side)] != kNoJoint) global[index(body_.toes[index(side)])] = planted.toes;
  }
  return deficit;
}

GolferPose GolferPoser::pose(const GolfPose& numbers) const {
  const Skeleton& skeleton = body_.skeleton;
  Torso torso = place_torso(numbers);
  const auto pair = [&](const std::array<Limb, 2>& limbs) {
    return std::array{torso.positions[index(limbs[0].upper)], torso.positions[index(limbs[1].upper)]};
  };
  const std::array<Vec3, 2> shoulders = pair(body_.arms), hips = pair(body_.legs);
  std::vector<Quat>& global = torso.global;
  place_head(numbers, global);
  const Grip grip = place_grip(numbers, shoulders);

  GolferPose golfer;
  golfer.deficit_m = place_arms(numbers, grip, shoulders, global);
  golfer.deficit_m = std::max(golfer.deficit_m, place_legs(numbers, hips, global));
  std::vector<bool> set(index(skeleton.size()), false);
  set[index(body_.pelvis)] = true;
  for (const auto* joints : {&body_.back, &body_.neck})
    for (const int joint : *joints) set[index(joint)] = true;
  for (const int side : {0, 1}) {
    for (const Limb* limb : {&body_.arms[index(side)], &body_.legs[index(side)]})
      for (const int joint : {limb->upper, limb->middle, limb->end}) set[index(joint)] = true;
    for (const int joint : {body_.clavicles[index(side)], body_.toes[index(side)]})
      if (joint != kNoJoint) set[index(joint)] = true;
  }
  inherit(skeleton, set, global);
  golfer.pose.root_position = torso.positions[0];
  golfer.pose.rotations.resize(global.size());
  local_rotations(skeleton, global, golfer.pose.rotations);
  golfer.club = {grip.point - grip.shaft * club_.grip_to_butt_m, grip.point,
                 grip.point + grip.shaft * club_.grip_to_head_m};
  return golfer;
}

void GolferPoser::fit_club(const GolfPose& address) {
  // As long as it takes to reach the ground from the posture that the script asks for.
  constexpr double kShortest = 0.70, kLongest = 1.35;
  const ClubPose club = pose(address).club;
  const double down = (club.grip.y - club.head.y) / club_.grip_to_head_m;
  const double wanted = (club.grip.y - kHeadCentre) / std::max(0.1, down);
  club_.grip_to_head_m *= std::clamp(wanted / club_.grip_to_head_m, kShortest, kLongest);
}

void GolferPoser::fit_address(const GolfPose& address) {
  // Bend, then sink, until the club's head is on the ground.
  const GolfPose& numbers = address;
  const auto head_height = [&](double bend_deg, double sink_m) {
    bend_offset_deg_ = bend_deg;
    hips_offset_m_ = sink_m;
    return pose(numbers).club.head.y;
  };
  constexpr double kMostBend = 14, kMostSink = 0.15;
  double low = -kMostBend, high = kMostBend;  // bending lowers the hands
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (head_height(middle, 0) > kHeadCentre ? low : high) = middle;
  }
  double least = -0.04 * body_.size, most = kMostSink * body_.size;
  const double bend = 0.5 * (low + high);
  if (head_height(bend, 0) > kHeadCentre + 1e-4 || head_height(bend, 0) < kHeadCentre - 1e-4) {
    for (int i = 0; i < 40; ++i) {
      const double middle = 0.5 * (least + most);
      (head_height(bend, middle) > kHeadCentre ? least : most) = middle;
    }
  } else {
    least = most = 0;
  }
  head_height(bend, 0.5 * (least + most));
  // What is still missing, the lie of the shaft makes up.
  if (std::abs(pose(numbers).club.head.y - kHeadCentre) > 1e-4) {
    double flatter = -25, steeper = 25;
    for (int i = 0; i < 40; ++i) {
      lie_offset_deg_ = 0.5 * (flatter + steeper);
      (pose(numbers).club.head.y > kHeadCentre ? flatter : steeper) = lie_offset_deg_;
    }
  }
  ball_ = pose(numbers).club.head;
}

void GolferPoser::fit_impact(const GolfPose& written, const GolfPose& impact) {
  const auto aim_at_ball = [&](const GolfPose& numbers) {
    const ClubPose club = pose(numbers).club;
    aim_at_impact_ = glm::normalize(swing_between(club.head - club.grip, ball_ - club.grip) * aim_at_impact_);
  };
  // Sink or rise until the ball is one club away from the hands, and turn the shaft to it. Each moves the
  // other a little: a few rounds settle them.
  constexpr double kMostSink = 0.06;
  for (int round = 0; round < 4; ++round) {
    double least = -kMostSink * body_.size, most = kMostSink * body_.size;
    for (int i = 0; i < 30; ++i) {
      sink_at_impact_m_ = 0.5 * (least + most);
      const bool is_far = glm::distance(pose(written).club.grip, ball_) > club_.grip_to_head_m;
      (is_far ? least : most) = sink_at_impact_m_;
    }
    aim_at_ball(written);
  }
  // A fault may take the hands elsewhere: the body does not make up for it, but the club still goes for the
  // ball.
  for (int round = 0; round < 3; ++round) aim_at_ball(impact);
}

Result<GolferPoser> GolferPoser::make(const Skeleton& skeleton, const GolfScript& script) {
  Result<GolferBody> body = GolferBody::make(skeleton);
  if (!body) return tl::unexpected(body.error());
  GolferPoser poser(*std::move(body));
  poser.club_ = script.club();
  poser.stance_ = script.stance();
  poser.hips_height_m_ = poser.address_hips_height();
  poser.fit_club(script.pose(0));
  poser.fit_address(script.pose(0));
  const double impact_s = script.time_of("impact");
  poser.fit_impact(script.written_pose(impact_s), script.pose(impact_s));
  return poser;
}

}  // namespace posecoach
