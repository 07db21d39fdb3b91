#include "core/motion/authored/authored_motion.h"

#include <gtest/gtest.h>

#include <random>

#include "core/body/named_body.h"
#include "tests/core/motion/authored/golfer_measures.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

AuthoredMotion make(std::string_view name, double frames_per_second = 120,
                    const Skeleton& body = make_standard_body({.height_m = 1.80}),
                    Handedness hand = Handedness::Right) {
  return make_authored_motion(bundled_script(name).value(), body, frames_per_second, hand).value();
}

double hand_speed(const Motion& motion, int frame) {
  return glm::length(hands_at(motion, frame + 1) - hands_at(motion, frame - 1)) /
         to_seconds(motion.time(frame + 1) - motion.time(frame - 1));
}

// When the hands are slowest between two events, as a detector that sees only joints would find the top.
double slowest_time(const AuthoredMotion& authored, std::string_view after, std::string_view before) {
  int slowest = frame_at(authored, after);
  for (int frame = slowest; frame < frame_at(authored, before); ++frame)
    if (hand_speed(authored.motion, frame) < hand_speed(authored.motion, slowest)) slowest = frame;
  return to_seconds(authored.motion.time(slowest));
}

double fastest_before(const AuthoredMotion& authored, std::string_view after, std::string_view before) {
  double fastest = 0;
  for (int frame = frame_at(authored, after); frame < frame_at(authored, before); ++frame)
    fastest = std::max(fastest, hand_speed(authored.motion, frame));
  return fastest;
}

// The first time that the hands move at this part of the backswing's greatest speed.
double takeaway_time(const AuthoredMotion& authored, double part) {
  const double fastest = fastest_before(authored, "address", "top");
  int frame = frame_at(authored, "address");
  while (hand_speed(authored.motion, frame) < part * fastest) ++frame;
  return to_seconds(authored.motion.time(frame));
}

double impact_time(const AuthoredMotion& authored) {
  int nearest = frame_at(authored, "top");
  const auto distance = [&](int frame) {
    return glm::distance(authored.club[static_cast<std::size_t>(frame)].head, authored.ball);
  };
  for (int frame = nearest; frame < authored.motion.frame_count(); ++frame)
    if (distance(frame) < distance(nearest)) nearest = frame;
  return to_seconds(authored.motion.time(nearest));
}

TEST(AuthoredSwing, tempo_is_three_to_one_and_the_joints_say_the_same) {
  const AuthoredMotion swing = make("swing", 480);
  const double ratio =
      (swing.time_of("top") - swing.time_of("takeaway")) / (swing.time_of("impact") - swing.time_of("top"));
  EXPECT_NEAR(ratio, 3.0, 0.06);
  EXPECT_NEAR(swing.time_of("top") - swing.time_of("takeaway"), 0.8, 0.05);
  EXPECT_NEAR(takeaway_time(swing, 0.06), swing.time_of("takeaway"), 0.02);
  EXPECT_NEAR(slowest_time(swing, "mid_backswing", "impact"), swing.time_of("top"), 0.008);
  EXPECT_NEAR(impact_time(swing), swing.time_of("impact"), 0.004);
}

TEST(AuthoredPutt, tempo_is_two_to_one_and_the_joints_say_the_same) {
  const AuthoredMotion putt = make("putt", 480);
  const double ratio =
      (putt.time_of("top") - putt.time_of("takeaway")) / (putt.time_of("impact") - putt.time_of("top"));
  EXPECT_NEAR(ratio, 2.0, 0.04);
  EXPECT_NEAR(putt.time_of("impact") - putt.time_of("takeaway"), 1.0, 0.1);
  EXPECT_NEAR(takeaway_time(putt, 0.06), putt.time_of("takeaway"), 0.02);
  EXPECT_NEAR(slowest_time(putt, "mid_backswing", "impact"), putt.time_of("top"), 0.008);
  EXPECT_NEAR(impact_time(putt), putt.time_of("impact"), 0.01);
}

TEST(AuthoredSwing, turns_are_a_golfers) {
  const AuthoredMotion swing = make("swing");
  const auto turn = [&](std::string_view event, auto measure) {
    return measure(swing.motion, frame_at(swing, event)) - measure(swing.motion, 0);
  };
  EXPECT_NEAR(turn("top", shoulder_turn_deg), -92.5, 5);
  EXPECT_NEAR(turn("top", hip_turn_deg), -43, 4);
  EXPECT_NEAR(turn("impact", hip_turn_deg), 40, 5);
  EXPECT_NEAR(turn("impact", shoulder_turn_deg), 28, 6);
  EXPECT_GT(turn("finish", shoulder_turn_deg), 85);
  EXPECT_GT(turn("finish", hip_turn_deg), 80);
  const Motion& motion = swing.motion;
  const int top = frame_at(swing, "top"), finish = frame_at(swing, "finish");
  EXPECT_LT(bend_deg(motion, top, LeftShoulder, LeftElbow, LeftWrist), 15);
  EXPECT_GT(bend_deg(motion, top, RightShoulder, RightElbow, RightWrist), 70);
  EXPECT_GT(hands_at(motion, top).y, joint_at(motion, top, Head).y + 0.05);
  // Over the lead foot, the trail heel up.
  EXPECT_NEAR(hips_at(motion, finish).x, joint_at(motion, finish, LeftAnkle).x, 0.10);
  EXPECT_GT(joint_at(motion, finish, RightAnkle).y, joint_at(motion, 0, RightAnkle).y + 0.08);
}

TEST(AuthoredSwing, parts_reach_their_speed_from_the_ground_up) {
  const AuthoredMotion swing = make("swing", 480);
  const Motion& motion = swing.motion;
  const auto peak = [&](auto angle) {
    int fastest = frame_at(swing, "top");
    const auto speed = [&](int frame) { return angle(frame + 2) - angle(frame - 2); };
    for (int frame = fastest; frame < frame_at(swing, "impact"); ++frame)
      if (speed(frame) > speed(fastest)) fastest = frame;
    return to_seconds(motion.time(fastest));
  };
  const double pelvis = peak([&](int frame) { return hip_turn_deg(motion, frame); });
  const double chest = peak([&](int frame) { return shoulder_turn_deg(motion, frame); });
  const auto club_speed = [&](int frame) {
    return glm::distance(swing.club[static_cast<std::size_t>(frame + 1)].head,
                         swing.club[static_cast<std::size_t>(frame - 1)].head);
  };
  int club_frame = frame_at(swing, "top");
  for (int frame = club_frame; frame < frame_at(swing, "mid_follow_through"); ++frame)
    if (club_speed(frame) > club_speed(club_frame)) club_frame = frame;
  const double club = to_seconds(motion.time(club_frame));
  EXPECT_LT(pelvis, chest);
  EXPECT_LT(chest, club);
  EXPECT_NEAR(club, swing.time_of("impact"), 0.02);
}

TEST(AuthoredPutt, rocks_the_shoulders_and_keeps_the_legs_still) {
  const AuthoredMotion putt = make("putt");
  const Motion& motion = putt.motion;
  const int top = frame_at(putt, "top"), end = frame_at(putt, "end"), impact = frame_at(putt, "impact");
  EXPECT_NEAR(shoulder_turn_deg(motion, 0) - shoulder_turn_deg(motion, top), 7, 2);
  EXPECT_GT(forward_bend_deg(motion, 0), 40);
  EXPECT_LT(forward_bend_deg(motion, 0), 50);
  const double back = hands_at(motion, 0).x - hands_at(motion, top).x;
  const double through = hands_at(motion, end).x - hands_at(motion, impact).x;
  EXPECT_GT(back, 0.05);
  EXPECT_NEAR(through / back, 1.6, 0.45);
  for (int frame = 0; frame < motion.frame_count(); ++frame)
    for (const auto& [hip, knee, ankle] :
         {std::array{LeftHip, LeftKnee, LeftAnkle}, std::array{RightHip, RightKnee, RightAnkle}})
      ASSERT_NEAR(bend_deg(motion, frame, hip, knee, ankle), bend_deg(motion, 0, hip, knee, ankle), 2.5);
}

// Greatest change of acceleration from frame to frame, over the greatest acceleration: noise and jumps make
// it large; at 480 frames a second a smooth motion changes little.
double roughness(const Motion& motion, HumanoidJoint joint) {
  double most = 0, change = 0;
  Vec3 before;
  for (int frame = 1; frame + 1 < motion.frame_count(); ++frame) {
    const Vec3 acceleration = joint_at(motion, frame + 1, joint) + joint_at(motion, frame - 1, joint) -
                              2.0 * joint_at(motion, frame, joint);
    if (frame > 1) change = std::max(change, glm::length(acceleration - before));
    most = std::max(most, glm::length(acceleration));
    before = acceleration;
  }
  return most < 1e-7 ? 0 : change / most;  // it stands still
}

TEST(AuthoredMotionProperty, every_joint_moves_without_jerks) {
  for (const char* name : {"swing", "putt"}) {
    const AuthoredMotion authored = make(name, 480);
    for (const HumanoidJoint joint :
         {LeftWrist, RightWrist, LeftElbow, RightElbow, LeftShoulder, RightShoulder, Head, LeftHip, RightHip,
          LeftKnee, RightKnee, RightAnkle})
      EXPECT_LT(roughness(authored.motion, joint), 0.25) << name << " " << to_string(joint);
  }
}

TEST(AuthoredMotionProperty, hand_speed_has_one_peak_on_each_side_of_the_top) {
  const AuthoredMotion swing = make("swing");
  const double fastest = fastest_before(swing, "top", "mid_follow_through");
  // After the peak it never again rises by more than a tenth of it.
  double lowest_since_peak = 1e9;
  bool past = false;
  for (int frame = frame_at(swing, "top") + 1; frame < frame_at(swing, "finish"); ++frame) {
    const double speed = hand_speed(swing.motion, frame);
    past = past || speed > fastest - 1e-9;
    if (!past) continue;
    lowest_since_peak = std::min(lowest_since_peak, speed);
    ASSERT_LT(speed, lowest_since_peak + 0.1 * fastest);
  }
  EXPECT_TRUE(past);
}

void expect_a_golfer(const AuthoredMotion& authored, const std::string& what) {
  const Motion& motion = authored.motion;
  EXPECT_LT(authored.deficit_m, 0.002) << what;
  for (int frame = 0; frame < motion.frame_count(); ++frame) {
    ASSERT_LT(glm::distance(joint_at(motion, frame, LeftWrist), joint_at(motion, frame, RightWrist)), 0.12)
        << what;
    ASSERT_NEAR(glm::distance(joint_at(motion, frame, LeftWrist), joint_at(motion, frame, RightWrist)),
                glm::distance(joint_at(motion, 0, LeftWrist), joint_at(motion, 0, RightWrist)), 0.004)
        << what << " frame " << frame;
    for (const HumanoidJoint joint : {LeftAnkle, LeftToe, RightToe})
      ASSERT_LT(glm::distance(joint_at(motion, frame, joint), joint_at(motion, 0, joint)), 0.002) << what;
    for (int j = 1; j < motion.joint_count(); ++j)
      ASSERT_NEAR(
          glm::distance(motion.position(frame, j), motion.position(frame, motion.skeleton().joint(j).parent)),
          motion.skeleton().bone_length(j), 1e-9);
  }
  const ClubPose& address = authored.club.front();
  EXPECT_NEAR(address.head.y, 0.02, 0.03) << what;
}

TEST(AuthoredMotionProperty, works_in_bodies_from_150_to_200_cm_with_limbs_a_quarter_longer_or_shorter) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> height(1.5, 2.0), factor(0.75, 1.25);
  for (int round = 0; round < 24; ++round) {
    const BodyProportions p{.height_m = height(random),
                            .arms = factor(random),
                            .forearms = 1,
                            .shoulders = factor(random),
                            .torso = factor(random),
                            .hips = factor(random),
                            .thighs = factor(random),
                            .shins = factor(random)};
    const std::string what = "height " + std::to_string(p.height_m) + " arms " + std::to_string(p.arms) +
                             " shoulders " + std::to_string(p.shoulders) + " torso " +
                             std::to_string(p.torso) + " thighs " + std::to_string(p.thighs) + " shins " +
                             std::to_string(p.shins);
    for (const char* name : {"swing", "putt"}) {
      const auto authored = make_authored_motion(bundled_script(name).value(), make_standard_body(p), 60);
      ASSERT_TRUE(authored);
      expect_a_golfer(*authored, std::string(name) + " " + what);
    }
  }
}

TEST(AuthoredMotionProperty, named_bodies_play) {
  for (const NamedBody& body : named_bodies())
    for (const char* name : {"swing", "putt"})
      expect_a_golfer(make(name, 60, make_standard_body(body.proportions)),
                      std::string(name) + " " + std::string(body.name));
}

TEST(AuthoredMotionProperty, left_hander_is_the_mirror_image) {
  const AuthoredMotion right = make("swing", 60),
                       left = make("swing", 60, make_standard_body({.height_m = 1.80}), Handedness::Left);
  for (int frame = 0; frame < right.motion.frame_count(); ++frame) {
    ASSERT_LT(glm::distance(joint_at(left.motion, frame, LeftWrist),
                            mirrored(joint_at(right.motion, frame, RightWrist))),
              1e-9);
    ASSERT_LT(glm::distance(left.club[static_cast<std::size_t>(frame)].head,
                            mirrored(right.club[static_cast<std::size_t>(frame)].head)),
              1e-9);
  }
  EXPECT_GT(shoulder_turn_deg(left.motion, frame_at(left, "top")), 85);
}

TEST(AuthoredMotionErrors, body_without_arms_is_named) {
  const Skeleton legs = Skeleton::make({{"pelvis", kNoJoint, {0, 1, 0}, Pelvis}}).value();
  const auto made = make_authored_motion(bundled_script("swing").value(), legs, 60);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::Incomplete);
  EXPECT_NE(made.error().message.find("left_wrist"), std::string::npos);
  EXPECT_FALSE(make_authored_motion(bundled_script("swing").value(), make_standard_body(), 0));
}

}  // namespace
}  // namespace posecoach
