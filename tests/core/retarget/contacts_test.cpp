#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "core/body/standard_body.h"
#include "core/motion/bundled_motion.h"
#include "core/retarget/feet.h"
#include "core/retarget/grip.h"
#include "core/retarget/retarget.h"
#include "tests/core/retarget/motions.h"

namespace posecoach {
namespace {

const Motion& swing() {
  static const Motion motion = resample(*bundled_motion("swing"), 60);
  return motion;
}

RetargetResult with_contacts(const Motion& coach, const Skeleton& body) {
  Result<RetargetResult> result = retarget(coach, body, {RetargetMethod::Rotation, Contacts::On});
  EXPECT_TRUE(result) << result.error().message;
  return *std::move(result);
}

double percentile_95(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[(values.size() - 1) * 95 / 100];
}

std::vector<double> grip_errors(const Motion& coach, const Motion& student) {
  const std::vector<double> weights = grip_weights(coach);
  std::vector<double> errors;
  for (int f = 0; f < coach.frame_count(); ++f)
    if (weights[static_cast<std::size_t>(f)] > 1 - 1e-9)
      errors.push_back(glm::distance(wrist_relation(coach.skeleton(), coach.positions(f)),
                                     wrist_relation(student.skeleton(), student.positions(f))));
  return errors;
}

// Largest acceleration of any joint, m/s^2.
double peak_acceleration(const Motion& motion) {
  double peak = 0;
  for (int f = 1; f + 1 < motion.frame_count(); ++f) {
    const double dt = 0.5 * to_seconds(motion.time(f + 1) - motion.time(f - 1));
    for (int j = 0; j < motion.joint_count(); ++j)
      peak = std::max(peak, glm::length(motion.position(f + 1, j) - 2.0 * motion.position(f, j) +
                                        motion.position(f - 1, j)) /
                                (dt * dt));
  }
  return peak;
}

double slide_m(const Motion& motion, bool left, const std::vector<PlantedFoot>& contacts) {
  double slide = 0;
  for (const PlantedFoot& contact : contacts) {
    const int joint = anchor_joint(motion.skeleton(), contact.anchor, left);
    for (int f = contact.begin + 1; f < contact.end; ++f) {
      Vec3 step = motion.position(f, joint) - motion.position(f - 1, joint);
      step.y = 0;
      slide += glm::length(step);
    }
  }
  return slide;
}

std::vector<Skeleton> odd_bodies() {
  std::vector<Skeleton> bodies;
  for (const double arms : {0.8, 1.0, 1.2})
    for (const double shoulders : {0.8, 1.0, 1.2})
      bodies.push_back(make_standard_body({.height_m = 1.70, .arms = arms, .shoulders = shoulders}));
  bodies.push_back(make_standard_body({.height_m = 1.55, .torso = 1.1, .thighs = 0.9, .shins = 1.15}));
  bodies.push_back(
      make_standard_body({.height_m = 1.95, .torso = 0.9, .hips = 1.2, .thighs = 1.1, .shins = 0.9}));
  bodies.push_back(test_landmark_body(0.95));
  bodies.push_back(test_landmark_body(1.15));
  return bodies;
}

TEST(Grip, the_bundled_swing_is_held_throughout) {
  for (const double weight : grip_weights(swing())) EXPECT_DOUBLE_EQ(weight, 1);
}

TEST(Grip, a_clap_is_no_grip) {
  const Skeleton body = make_standard_body();
  const int frames = 90;
  std::vector<Vec3> positions;
  for (int f = 0; f < frames; ++f) {
    std::vector<Vec3> rest(body.rest_positions().begin(), body.rest_positions().end());
    const double apart = std::abs(f - 45) < 5 ? 0.1 : 0.8;
    rest[static_cast<std::size_t>(body.find(HumanoidJoint::LeftWrist))] = {0.5 * apart, 1.2, 0.4};
    rest[static_cast<std::size_t>(body.find(HumanoidJoint::RightWrist))] = {-0.5 * apart, 1.2, 0.4};
    positions.insert(positions.end(), rest.begin(), rest.end());
  }
  for (const double weight : grip_weights(*Motion::from_positions(body, frame_times(frames), positions)))
    EXPECT_EQ(weight, 0);
}

TEST(Grip, wrists_stand_as_the_coachs_do_whatever_the_arms_and_shoulders) {
  for (const Skeleton& body : odd_bodies()) {
    const RetargetResult result = with_contacts(swing(), body);
    EXPECT_EQ(result.contacts.grip_frames, swing().frame_count());
    EXPECT_TRUE(result.contacts.unreachable_frames.empty());
    EXPECT_LT(percentile_95(grip_errors(swing(), result.motion)), 0.003);
    EXPECT_LT(result.bone_length_error_max, 1e-9);
  }
}

TEST(Grip, arms_that_cannot_reach_report_by_how_much_and_come_as_near_as_they_can) {
  const Skeleton body = make_standard_body({.height_m = 1.70, .arms = 0.30, .shoulders = 2.2});
  const RetargetResult result = with_contacts(swing(), body);
  EXPECT_GT(result.contacts.reach_deficit_max_m, 0.02);
  EXPECT_FALSE(result.contacts.unreachable_frames.empty());
  const auto errors = grip_errors(swing(), result.motion);
  EXPECT_LT(*std::max_element(errors.begin(), errors.end()), result.contacts.reach_deficit_max_m + 0.003);
}

TEST(Grip, a_coach_in_his_own_body_hardly_moves) {
  const RetargetResult result = with_contacts(swing(), swing().skeleton());
  for (int f = 0; f < swing().frame_count(); ++f)
    for (int j = 0; j < swing().joint_count(); ++j)
      EXPECT_LT(glm::distance(result.motion.position(f, j), swing().position(f, j)), 0.02);
}

TEST(Contacts, corrections_do_not_shake_the_body) {
  const double coach_peak = peak_acceleration(swing());
  for (const Skeleton& body : odd_bodies()) {
    const double size = std::max(1.0, body.rest_height() / swing().skeleton().rest_height());
    EXPECT_LT(peak_acceleration(with_contacts(swing(), body).motion), 1.6 * size * coach_peak);
  }
}

TEST(Contacts, only_limbs_and_the_place_of_the_hips_change) {
  const Skeleton body = make_standard_body({.height_m = 1.70, .arms = 1.2, .shoulders = 0.8, .thighs = 1.1});
  const Motion before = retarget(swing(), body)->motion, after = with_contacts(swing(), body).motion;
  using enum HumanoidJoint;
  for (const HumanoidJoint role : {Spine, Chest, Neck, Head, LeftShoulder, RightHip})
    for (int f = 0; f < before.frame_count(); ++f) {
      const int j = body.find(role);
      EXPECT_LT(glm::distance(before.position(f, j) - before.position(f, 0),
                              after.position(f, j) - after.position(f, 0)),
                1e-9);
      EXPECT_LT(glm::distance(before.position(f, 0), after.position(f, 0)), 0.06);
    }
}

TEST(Feet, the_lead_foot_of_the_swing_is_planted) {
  const FootContacts contacts = find_foot_contacts(swing());
  ASSERT_FALSE(contacts.left.empty());
  int planted = 0;
  for (const PlantedFoot& contact : contacts.left) planted += contact.end - contact.begin;
  EXPECT_GT(planted, swing().frame_count() * 8 / 10);
}

TEST(Feet, a_step_is_not_a_contact) {
  const Skeleton body = make_standard_body();
  const int frames = 120;
  std::vector<Vec3> positions;
  const auto lift = [](int f) { return f < 40 || f >= 70 ? 0.0 : std::sin(kPi * (f - 40) / 30.0); };
  for (int f = 0; f < frames; ++f) {
    std::vector<Vec3> rest(body.rest_positions().begin(), body.rest_positions().end());
    for (const HumanoidJoint role :
         {HumanoidJoint::LeftAnkle, HumanoidJoint::LeftToe, HumanoidJoint::LeftToeTip})
      rest[static_cast<std::size_t>(body.find(role))] +=
          Vec3(0, 0.2 * lift(f), f < 40 ? 0 : std::min(0.3, 0.01 * (f - 40)));
    positions.insert(positions.end(), rest.begin(), rest.end());
  }
  const FootContacts contacts =
      find_foot_contacts(*Motion::from_positions(body, frame_times(frames), positions));
  ASSERT_GE(contacts.left.size(), 2U);
  for (const PlantedFoot& contact : contacts.left) EXPECT_TRUE(contact.end <= 44 || contact.begin >= 67);
  EXPECT_EQ(contacts.left.front().begin, 0);
  EXPECT_EQ(contacts.left.back().end, frames);
  EXPECT_EQ(contacts.right.size(), 1U);
}

TEST(Feet, planted_feet_slide_no_more_than_the_coachs_and_stand_on_the_floor) {
  const FootContacts contacts = find_foot_contacts(swing());
  for (const Skeleton& body : odd_bodies()) {
    const Motion student = with_contacts(swing(), body).motion;
    for (const bool left : {true, false}) {
      const auto& planted = left ? contacts.left : contacts.right;
      EXPECT_LE(slide_m(student, left, planted), slide_m(swing(), left, planted) + 0.005);
      const int ankle = anchor_joint(body, FootAnchor::Ankle, left);
      const double rest = body.rest_positions()[static_cast<std::size_t>(ankle)].y;
      for (const PlantedFoot& contact : planted) {
        if (contact.anchor != FootAnchor::Ankle || contact.begin > 0) continue;
        for (int f = contact.begin; f < contact.end; ++f)
          EXPECT_NEAR(student.position(f, ankle).y, rest + contacts.floor_m, 0.012);
      }
    }
  }
}

}  // namespace
}  // namespace posecoach
