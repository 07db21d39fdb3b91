#include "core/coaching/part_differences.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <initializer_list>
#include <span>

#include "core/coaching/posture.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

constexpr double kMoment_s = 0.02;

constexpr std::array kChestJoints = {Chest, Neck, LeftClavicle, LeftShoulder, RightClavicle, RightShoulder};
constexpr std::array kHeadJoints = {Head, HeadTop};
constexpr std::array kLeadArm = {LeftElbow, LeftWrist};
constexpr std::array kTrailArm = {RightElbow, RightWrist};
constexpr std::array kArms = {LeftElbow, LeftWrist, RightElbow, RightWrist};
constexpr std::array kHipJoints = {Pelvis, LeftHip, RightHip, Spine, SpineMiddle};

// Axes that turn with the chest: shoulder line, spine, and what is square to both.
Mat3 chest_axes(const JointTrack& body) {
  const Vec3 across = glm::normalize(body.position(0, LeftShoulder) - body.position(0, RightShoulder));
  const Vec3 spine = middle_of_shoulders(body, 0) - middle_of_hips(body, 0);
  const Vec3 front = glm::normalize(glm::cross(across, spine));
  return {across, glm::cross(front, across), front};
}

double least_confidence(const JointTrack& student, std::initializer_list<HumanoidJoint> joints) {
  double least = 1;
  for (const HumanoidJoint joint : joints) least = std::min(least, student.confidence(0, joint));
  return least;
}

class Differences {
 public:
  Differences(const JointTrack& student, const JointTrack& coach, const BodyAxes& axes, const Vec3& feet)
      : student_(student), coach_(coach), axes_(axes) {
    // Feet together: the joint errors that the shares are of.
    for (const HumanoidJoint joint : student.joints()) {
      if (!coach.has(joint)) continue;
      joints_.push_back(joint);
      errors_.push_back(student.position(0, joint) - coach.position(0, joint) - feet);
      total_ += glm::length(errors_.back());
    }
  }

  // What would be gone if `joints` were not displaced by `by` (world axes).
  double share(const Vec3& by, std::initializer_list<std::span<const HumanoidJoint>> groups) const {
    double gone = 0;
    for (const std::span<const HumanoidJoint> group : groups)
      for (const HumanoidJoint joint : group)
        for (std::size_t k = 0; k < joints_.size(); ++k)
          if (joints_[k] == joint) gone += glm::length(errors_[k]) - glm::length(errors_[k] - by);
    return total_ > 0 ? std::clamp(gone / total_, 0.0, 1.0) : 0;
  }

  void add(Feature feature, double amount, const Vec3& by, double share, double confidence) {
    found_.push_back({feature, amount, in_axes(axes_, by), share, confidence, true});
  }

  // A displacement as three features, one a direction.
  void add_place(std::array<Feature, 3> features, const Vec3& by, double confidence,
                 std::initializer_list<std::span<const HumanoidJoint>> carried) {
    const std::array directions = {axes_.left, axes_.up, axes_.front};
    for (std::size_t k = 0; k < 3; ++k) {
      const double amount = glm::dot(by, directions[k]);
      add(features[k], amount, amount * directions[k], share(amount * directions[k], carried), confidence);
    }
  }

  const JointTrack& student() const { return student_; }
  const JointTrack& coach() const { return coach_; }
  const BodyAxes& axes() const { return axes_; }
  std::vector<PartDifference> take() { return std::move(found_); }

 private:
  const JointTrack& student_;
  const JointTrack& coach_;
  BodyAxes axes_;
  std::vector<HumanoidJoint> joints_;
  std::vector<Vec3> errors_;
  double total_ = 0;
  std::vector<PartDifference> found_;
};

double turn_between(const Differences& d, HumanoidJoint left, HumanoidJoint right) {
  return std::remainder(
      turn_deg(d.student(), 0, left, right, d.axes()) - turn_deg(d.coach(), 0, left, right, d.axes()), 360.0);
}

void add_trunk(Differences& d, const Vec3& feet, HeadOver head_over) {
  const Vec3 hips = middle_of_hips(d.student(), 0) - middle_of_hips(d.coach(), 0) - feet;
  const double hips_confidence = least_confidence(d.student(), {LeftHip, RightHip, LeftAnkle, RightAnkle});
  d.add_place({Feature::HipsToTarget, Feature::HipsUp, Feature::HipsToBall}, hips, hips_confidence,
              {kHipJoints, kChestJoints, kHeadJoints, kArms});
  const Vec3 shoulders = middle_of_shoulders(d.student(), 0) - middle_of_shoulders(d.coach(), 0) - feet;
  const double chest_confidence =
      least_confidence(d.student(), {LeftShoulder, RightShoulder, LeftHip, RightHip});
  d.add_place({Feature::ChestToTarget, Feature::ChestUp, Feature::ChestToBall}, shoulders - hips,
              chest_confidence, {kChestJoints, kHeadJoints, kArms});
  // As far up the head as both know it.
  for (const HumanoidJoint joint : {HeadTop, Head}) {
    if (!d.student().has(joint) || !d.coach().has(joint)) continue;
    const Vec3 head = d.student().position(0, joint) - d.coach().position(0, joint) - feet;
    Vec3 seen = head;
    if (head_over == HeadOver::Shoulders) seen -= Vec3(shoulders.x, 0, shoulders.z);
    d.add_place({Feature::HeadToTarget, Feature::HeadUp, Feature::HeadToBall}, seen,
                least_confidence(d.student(), {joint, LeftShoulder, RightShoulder}), {kHeadJoints});
    break;
  }
}

// A turn moves the ends of a line about its middle.
Vec3 end_displacement(const Differences& d, HumanoidJoint left, const Vec3& middle) {
  return d.student().position(0, left) - d.coach().position(0, left) - middle;
}

void add_turns(Differences& d) {
  const Vec3 hips = middle_of_hips(d.student(), 0) - middle_of_hips(d.coach(), 0);
  const Vec3 shoulders = middle_of_shoulders(d.student(), 0) - middle_of_shoulders(d.coach(), 0);
  const double hip_turn = turn_between(d, LeftHip, RightHip);
  const double shoulder_turn = turn_between(d, LeftShoulder, RightShoulder);
  const Vec3 hip_end = end_displacement(d, LeftHip, hips);
  const Vec3 shoulder_end = end_displacement(d, LeftShoulder, shoulders);
  d.add(Feature::HipTurn, hip_turn, hip_end, d.share(hip_end, {std::array{LeftHip}}),
        least_confidence(d.student(), {LeftHip, RightHip}));
  const double confidence = least_confidence(d.student(), {LeftShoulder, RightShoulder});
  d.add(Feature::ShoulderTurn, shoulder_turn, shoulder_end,
        d.share(shoulder_end, {std::array{LeftShoulder}, std::array{LeftClavicle}, kLeadArm}), confidence);
  d.add(Feature::ShoulderTilt,
        tilt_deg(d.student(), 0, LeftShoulder, RightShoulder) -
            tilt_deg(d.coach(), 0, LeftShoulder, RightShoulder),
        Vec3(0, shoulder_end.y, 0), d.share(Vec3(0, shoulder_end.y, 0), {std::array{LeftShoulder}, kLeadArm}),
        confidence);
}

// How far an elbow stands off the line from shoulder to wrist.
double off_line(const JointTrack& body, HumanoidJoint shoulder, HumanoidJoint elbow, HumanoidJoint wrist) {
  const Vec3 line = body.position(0, wrist) - body.position(0, shoulder);
  const Vec3 upper = body.position(0, elbow) - body.position(0, shoulder);
  return glm::length(glm::cross(line, upper)) / std::max(1e-6, glm::length(line));
}

// The part of an elbow's displacement that is left when what a straighter arm takes from it is not counted:
// the student's arms are as long as the coach's, but his hands need not be as near.
double unexplained_by_straightening(const Differences& d, const Vec3& by, HumanoidJoint shoulder,
                                    HumanoidJoint elbow, HumanoidJoint wrist) {
  const double straighter =
      off_line(d.coach(), shoulder, elbow, wrist) - off_line(d.student(), shoulder, elbow, wrist);
  return straighter <= 0 ? 1 : std::max(0.0, 1 - straighter / std::max(1e-6, glm::length(by)));
}

void add_arms(Differences& d, const Vec3& feet, ArmAxes arm_axes) {
  const bool is_chest = arm_axes == ArmAxes::Chest;
  const Mat3 student_axes = is_chest ? chest_axes(d.student()) : Mat3(1);
  const Mat3 coach_axes = is_chest ? chest_axes(d.coach()) : Mat3(1);
  const auto place_on_chest = [&](auto&& of) {
    const Vec3 s = glm::transpose(student_axes) * (of(d.student()) - middle_of_shoulders(d.student(), 0));
    const Vec3 c = glm::transpose(coach_axes) * (of(d.coach()) - middle_of_shoulders(d.coach(), 0));
    return coach_axes * (s - c);
  };
  const auto add_arm = [&](Feature place, Feature bend, HumanoidJoint shoulder, HumanoidJoint elbow,
                           HumanoidJoint wrist, std::span<const HumanoidJoint> carried) {
    const Vec3 by = place_on_chest([&](const JointTrack& body) { return body.position(0, elbow); });
    const double confidence = least_confidence(d.student(), {shoulder, elbow, wrist});
    const Vec3 misplaced = by * unexplained_by_straightening(d, by, shoulder, elbow, wrist);
    d.add(place, glm::length(misplaced), misplaced, d.share(misplaced, {carried}), confidence);
    const Vec3 hand = place_on_chest([&](const JointTrack& body) { return body.position(0, wrist); });
    d.add(bend,
          bend_deg(d.student(), 0, shoulder, elbow, wrist) - bend_deg(d.coach(), 0, shoulder, elbow, wrist),
          by, std::max(d.share(by, {carried}), d.share(hand, {carried})), confidence);
  };
  add_arm(Feature::LeadElbowPlace, Feature::LeadArmBend, LeftShoulder, LeftElbow, LeftWrist, kLeadArm);
  add_arm(Feature::TrailElbowPlace, Feature::TrailArmBend, RightShoulder, RightElbow, RightWrist, kTrailArm);
  const Vec3 hands =
      place_on_chest([](const JointTrack& body) { return middle_of(body, 0, LeftWrist, RightWrist); });
  d.add(Feature::HandsPlace, glm::length(hands), hands, d.share(hands, {kArms}),
        least_confidence(d.student(), {LeftWrist, RightWrist}));
  const Vec3 over_feet = middle_of(d.student(), 0, LeftWrist, RightWrist) -
                         middle_of(d.coach(), 0, LeftWrist, RightWrist) - feet;
  const double out = glm::dot(over_feet, d.axes().front);
  d.add(Feature::HandsToBall, out, out * d.axes().front, d.share(out * d.axes().front, {kArms}),
        least_confidence(d.student(), {LeftWrist, RightWrist}));
}

void add_wrists(Differences& d) {
  const auto grip = [](const JointTrack& body) {
    return body.position(0, RightWrist) - body.position(0, LeftWrist);
  };
  const Vec3 by = grip(d.student()) - grip(d.coach());
  d.add(Feature::LeadWristBreak,
        std::remainder(wrist_break_deg(d.student(), 0, d.axes()) - wrist_break_deg(d.coach(), 0, d.axes()),
                       360.0),
        by, d.share(by, {std::array{RightWrist}}),
        least_confidence(d.student(), {LeftElbow, LeftWrist, RightWrist}));
}

void add_legs(Differences& d, const Vec3& feet) {
  const auto add_knee = [&](Feature bend, HumanoidJoint hip, HumanoidJoint knee, HumanoidJoint ankle) {
    const Vec3 by = d.student().position(0, knee) - d.coach().position(0, knee) - feet;
    d.add(bend, bend_deg(d.student(), 0, hip, knee, ankle) - bend_deg(d.coach(), 0, hip, knee, ankle), by,
          d.share(by, {std::array{knee}}), least_confidence(d.student(), {hip, knee, ankle}));
  };
  add_knee(Feature::LeadKneeBend, LeftHip, LeftKnee, LeftAnkle);
  add_knee(Feature::TrailKneeBend, RightHip, RightKnee, RightAnkle);
  const auto width = [&](const JointTrack& body) {
    return glm::dot(body.position(0, LeftAnkle) - body.position(0, RightAnkle), d.axes().left);
  };
  const double wider = width(d.student()) - width(d.coach());
  const Vec3 by = 0.5 * wider * d.axes().left;
  d.add(Feature::StanceWidth, wider, by, d.share(by, {std::array{LeftAnkle, LeftToe, LeftToeTip, LeftKnee}}),
        least_confidence(d.student(), {LeftAnkle, RightAnkle}));
}

}  // namespace

std::string_view to_string(Feature feature) {
  static constexpr std::array<std::string_view, kFeatureCount> kNames = {
      "hips_to_target", "hips_up",         "hips_to_ball",   "chest_to_target", "chest_up",
      "chest_to_ball",  "head_to_target",  "head_up",        "head_to_ball",    "hip_turn",
      "shoulder_turn",  "shoulder_tilt",   "lead_elbow",     "trail_elbow",     "lead_arm_bend",
      "trail_arm_bend", "hands",           "lead_knee_bend", "trail_knee_bend", "stance_width",
      "hands_to_ball",  "lead_wrist_break"};
  return kNames[static_cast<std::size_t>(feature)];
}

JointTrack moment_of(const JointTrack& track, double time_s) {
  return track.averaged(time_s - kMoment_s, time_s + kMoment_s);
}

std::vector<PartDifference> part_differences(const JointTrack& student, const JointTrack& coach,
                                             const BodyAxes& axes, const DifferenceOptions& options) {
  const auto ankles = [&options](const JointTrack& body) {
    return options.anchor == Anchor::LeadFoot ? body.position(0, LeftAnkle)
                                              : middle_of(body, 0, LeftAnkle, RightAnkle);
  };
  const Vec3 feet = ankles(student) - ankles(coach);
  Differences differences(student, coach, axes, feet);
  add_trunk(differences, feet, options.head_over);
  add_turns(differences);
  add_arms(differences, feet, options.arm_axes);
  add_legs(differences, feet);
  add_wrists(differences);
  return differences.take();
}

}  // namespace posecoach
