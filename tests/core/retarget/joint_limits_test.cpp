#include "core/retarget/joint_limits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>

#include "core/body/mirror.h"
#include "core/body/standard_body.h"
#include "core/motion/bundled_motion.h"
#include "core/motion/motion_file.h"
#include "tests/core/retarget/motions.h"
#include "tests/support/shared_data.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

struct LimbRoles {
  HumanoidJoint root, middle, end;
  Vec3 hinge;  // about which the limb bends backwards from the T-pose
};
const LimbRoles kLimbs[] = {{LeftHip, LeftKnee, LeftAnkle, {-1, 0, 0}},
                            {RightHip, RightKnee, RightAnkle, {-1, 0, 0}},
                            {LeftShoulder, LeftElbow, LeftWrist, {0, 1, 0}},
                            {RightShoulder, RightElbow, RightWrist, {0, -1, 0}}};

// One limb of a standing body bends about its hinge by `angle_at(seconds)`; negative is the usual way.
template <typename Angle>
Motion bending(const LimbRoles& limb, int frames, double fps, const Angle& angle_at) {
  const Skeleton body = make_standard_body();
  std::vector<Vec3> roots;
  std::vector<Quat> rotations;
  for (int f = 0; f < frames; ++f) {
    roots.push_back(body.joint(0).offset);
    std::vector<Quat> pose(static_cast<std::size_t>(body.size()), Quat(1, 0, 0, 0));
    pose[static_cast<std::size_t>(body.find(limb.middle))] = glm::angleAxis(angle_at(f / fps), limb.hinge);
    rotations.insert(rotations.end(), pose.begin(), pose.end());
  }
  return *Motion::from_rotations(body, frame_times(frames, fps), roots, rotations);
}

double bend_degrees(const Motion& motion, int frame, const LimbRoles& limb) {
  const auto at = [&](HumanoidJoint role) { return motion.position(frame, motion.skeleton().find(role)); };
  const Vec3 upper = at(limb.middle) - at(limb.root), lower = at(limb.end) - at(limb.middle);
  return degrees_from_radians(std::atan2(glm::length(glm::cross(upper, lower)), glm::dot(upper, lower)));
}

Motion limited(const Motion& motion, JointLimitReport* report = nullptr) {
  PosedMotion posed(motion);
  const JointLimitReport done = keep_joint_limits(posed);
  if (report) *report = done;
  return posed.motion();
}

double largest_difference(const Motion& a, const Motion& b) {
  double worst = 0;
  for (int f = 0; f < a.frame_count(); ++f)
    for (int j = 0; j < a.joint_count(); ++j)
      worst = std::max(worst, glm::distance(a.position(f, j), b.position(f, j)));
  return worst;
}

TEST(JointLimits, golf_stays_as_it_is_to_the_last_bit) {
  const Skeleton body = make_standard_body({.height_m = 1.65, .arms = 1.1, .thighs = 0.95});
  for (const char* name : {"swing", "putt"}) {
    const Motion coach = resample(*bundled_motion(name), 60);
    EXPECT_EQ(joint_limit_excess(coach).share, 0);
    const auto off = retarget(coach, body, {.limits = JointLimits::Off});
    const auto on = retarget(coach, body, {.limits = JointLimits::On});
    ASSERT_TRUE(off && on);
    EXPECT_EQ(on->limits.turned_frames, 0);
    for (int f = 0; f < coach.frame_count(); ++f)
      for (int j = 0; j < body.size(); ++j) EXPECT_EQ(on->motion.position(f, j), off->motion.position(f, j));
  }
}

TEST(JointLimits, every_usual_bend_stays_as_it_is) {
  for (const LimbRoles& limb : kLimbs) {
    const Motion motion = bending(limb, 160, 1, [](double s) { return -radians_from_degrees(s - 9); });
    PosedMotion posed(motion);
    EXPECT_EQ(keep_joint_limits(posed).turned_frames, 0);
    for (int f = 0; f < motion.frame_count(); ++f)
      for (int j = 0; j < motion.joint_count(); ++j)
        EXPECT_EQ(posed.position(f, j), PosedMotion(motion).position(f, j));
  }
}

TEST(JointLimits, a_limb_bent_backwards_comes_back_and_further_ones_from_further) {
  for (const LimbRoles& limb : kLimbs) {
    const Motion motion = bending(limb, 59, 1, [](double s) { return radians_from_degrees(0.5 * s + 0.5); });
    JointLimitReport report;
    const Motion kept = limited(motion, &report);
    EXPECT_EQ(report.turned_frames, 39);
    EXPECT_GT(joint_limit_excess(motion).largest_degrees, 14);
    EXPECT_EQ(joint_limit_excess(kept).share, 0);
    for (int f = 21; f < motion.frame_count(); ++f) {
      EXPECT_GT(bend_degrees(kept, f, limb), bend_degrees(kept, f - 1, limb));
      EXPECT_LT(bend_degrees(kept, f, limb), 15);
    }
    EXPECT_LT(bone_length_error(kept), 1e-9);
  }
}

TEST(JointLimits, a_limb_folded_into_itself_opens) {
  for (const LimbRoles& limb : kLimbs) {
    const Motion motion = bending(limb, 20, 1, [](double s) { return -radians_from_degrees(158 + s); });
    const Motion kept = limited(motion);
    for (int f = 0; f < motion.frame_count(); ++f) {
      EXPECT_GT(bend_degrees(kept, f, limb), 155);
      EXPECT_LT(bend_degrees(kept, f, limb), 160);
    }
  }
}

TEST(JointLimits, only_what_hangs_on_the_joint_moves_and_feet_keep_their_orientation) {
  const Motion motion = bending(kLimbs[0], 30, 1, [](double s) { return radians_from_degrees(2 * s); });
  PosedMotion posed(motion);
  const PosedMotion before(motion);
  keep_joint_limits(posed);
  const Skeleton& body = motion.skeleton();
  for (int f = 0; f < motion.frame_count(); ++f) {
    for (int j = 0; j < body.size(); ++j)
      EXPECT_TRUE(j == body.find(LeftAnkle) || j == body.find(LeftToe) || j == body.find(LeftToeTip) ||
                  posed.position(f, j) == before.position(f, j));
    EXPECT_EQ(posed.rotation(f, body.find(LeftAnkle)), before.rotation(f, body.find(LeftAnkle)));
  }
}

// A smooth function of time has second differences that fall with the square of the step.
TEST(JointLimits, a_smooth_motion_stays_smooth) {
  const auto roughness = [](const LimbRoles& limb, double fps) {
    const Motion kept = limited(bending(limb, static_cast<int>(2 * fps), fps, [](double s) {
      return radians_from_degrees(20 + 60 * std::sin(4 * s));
    }));
    const int end = kept.skeleton().find(limb.end);
    double worst = 0;
    for (int f = 1; f + 1 < kept.frame_count(); ++f)
      worst = std::max(worst, glm::length(kept.position(f + 1, end) - 2.0 * kept.position(f, end) +
                                          kept.position(f - 1, end)));
    return worst;
  };
  for (const LimbRoles& limb : kLimbs)
    EXPECT_LT(roughness(limb, 480), roughness(limb, 240) / 3.5) << to_string(limb.middle);
}

TEST(JointLimits, follow_the_world_and_the_mirror) {
  const Motion motion = without_rotations(random_motion(make_standard_body(), 60, 21));
  JointLimitReport report;
  const Motion kept = limited(motion, &report);
  EXPECT_GT(report.turned_frames, 0);
  const Quat yaw = glm::angleAxis(0.8, Vec3(0, 1, 0));
  const Vec3 shift(0.5, 0, 1);
  EXPECT_LT(largest_difference(limited(transformed(motion, yaw, shift)), transformed(kept, yaw, shift)),
            1e-9);
  EXPECT_LT(largest_difference(limited(mirrored(motion)), mirrored(kept)), 1e-9);
}

// A rig whose rest pose has a bent knee: turns away from it lead a straight knee beyond.
TEST(JointLimits, knees_that_a_bent_rest_pose_would_overstretch_are_held_and_can_be_let_go) {
  const Skeleton body = make_standard_body();
  const Motion coach =
      with_rest_pose_changed(standing_motion(body, 5), LeftKnee, Vec3(1, 0, 0), radians_from_degrees(14));
  const auto free = retarget(coach, body, {.limits = JointLimits::Off});
  const auto held = retarget(coach, body, {.limits = JointLimits::On});
  ASSERT_TRUE(free && held);
  EXPECT_NEAR(bend_degrees(free->motion, 0, kLimbs[0]), 14, 1e-6);
  EXPECT_EQ(free->limits.turned_frames, 0);
  EXPECT_EQ(held->limits.turned_frames, 5);
  EXPECT_LT(bend_degrees(held->motion, 0, kLimbs[0]), 13);
  EXPECT_NEAR(held->limits.largest_turn_degrees, 14 - bend_degrees(held->motion, 0, kLimbs[0]), 1e-6);
}

TEST(JointLimits, real_golfers_are_within_them) {
  const auto data = shared_data("data/golf");
  if (!data) GTEST_SKIP() << "no recorded golf here";
  for (const auto& file : std::filesystem::directory_iterator(*data)) {
    const auto read = read_motion_file(file.path());
    if (!read) continue;
    PosedMotion posed(resample(read->motion, 30));
    EXPECT_EQ(keep_joint_limits(posed).turned_frames, 0) << file.path();
  }
}

}  // namespace
}  // namespace posecoach
