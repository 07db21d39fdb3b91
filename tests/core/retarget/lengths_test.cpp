// Motions of every length, cut anywhere, and what is no motion at all.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/base/math.h"
#include "core/body/standard_body.h"
#include "core/retarget/retarget.h"
#include "core/retarget/streamed.h"
#include "core/retarget/webcam_noise.h"
#include "tests/core/retarget/motions.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

constexpr RetargetMethod kMethods[] = {RetargetMethod::Rotation, RetargetMethod::Direction,
                                       RetargetMethod::Scale, RetargetMethod::Paper, RetargetMethod::Network};
constexpr int kHour = 60 * 60 * 30;

// The fewest joints that retargeting asks for.
Skeleton small_body(double size) {
  std::vector<Joint> joints = {{"hips", kNoJoint, {0, 0.9 * size, 0}, Pelvis},
                               {"chest", 0, {0, 0.4 * size, 0}, Chest}};
  const auto limb = [&](int parent, const Vec3& place, const Vec3& upper, const Vec3& lower,
                        HumanoidJoint root, HumanoidJoint middle, HumanoidJoint end) {
    const int first = static_cast<int>(joints.size());
    joints.push_back({std::string(to_string(root)), parent, place * size, root});
    joints.push_back({std::string(to_string(middle)), first, upper * size, middle});
    joints.push_back({std::string(to_string(end)), first + 1, lower * size, end});
  };
  limb(0, {0.1, 0, 0}, {0, -0.45, 0}, {0, -0.45, 0}, LeftHip, LeftKnee, LeftAnkle);
  limb(0, {-0.1, 0, 0}, {0, -0.45, 0}, {0, -0.45, 0}, RightHip, RightKnee, RightAnkle);
  limb(1, {0.18, 0.1, 0}, {0.28, 0, 0}, {0.26, 0, 0}, LeftShoulder, LeftElbow, LeftWrist);
  limb(1, {-0.18, 0.1, 0}, {-0.28, 0, 0}, {-0.26, 0, 0}, RightShoulder, RightElbow, RightWrist);
  return *Skeleton::make(joints);
}

double largest_difference(const Motion& a, const Motion& b) {
  EXPECT_EQ(a.frame_count(), b.frame_count());
  double worst = 0;
  for (int f = 0; f < a.frame_count(); ++f)
    for (int j = 0; j < a.joint_count(); ++j)
      worst = std::max(worst, glm::distance(a.position(f, j), b.position(f, j)));
  return worst;
}

const Motion& hour() {
  static const Motion motion = random_motion(small_body(1), kHour, 31);
  return motion;
}

class Lengths : public testing::TestWithParam<RetargetMethod> {};

TEST_P(Lengths, a_few_frames_are_a_motion_too) {
  const Motion exact = random_motion(make_standard_body(), 3, 32);
  std::mt19937_64 random(33);
  const Motion filmed = with_webcam_noise(exact, random);
  for (const Motion& whole : {exact, without_rotations(exact), filmed})
    for (const int frames : {1, 2, 3})
      for (const Contacts contacts : {Contacts::Off, Contacts::On}) {
        const Motion coach = whole.slice(0, frames);
        const auto student = retarget(coach, test_landmark_body(1.1), {GetParam(), contacts});
        ASSERT_TRUE(student) << student.error().message;
        EXPECT_EQ(student->motion.frame_count(), frames);
        EXPECT_EQ(student->motion.time(frames - 1), coach.time(frames - 1));
        EXPECT_TRUE(GetParam() == RetargetMethod::Scale || student->bone_length_error_max < 1e-9);
      }
}

TEST_P(Lengths, joints_that_were_never_seen_do_not_spoil_the_answer) {
  const Motion exact = random_motion(make_standard_body(), 20, 34);
  std::vector<Vec3> positions;
  for (int f = 0; f < exact.frame_count(); ++f)
    positions.insert(positions.end(), exact.positions(f).begin(), exact.positions(f).end());
  const std::vector<double> unseen(positions.size(), 0.0);
  const Motion coach = *Motion::from_positions(exact.skeleton(), {exact.times().begin(), exact.times().end()},
                                               positions, unseen);
  const auto student = retarget(coach, make_standard_body({.height_m = 1.6}), {GetParam(), Contacts::On});
  ASSERT_TRUE(student) << student.error().message;
  for (int j = 0; j < student->motion.joint_count(); ++j)
    EXPECT_TRUE(is_finite(student->motion.position(19, j)));
}

INSTANTIATE_TEST_SUITE_P(Methods, Lengths, testing::ValuesIn(kMethods),
                         [](const auto& method) { return std::string(to_string(method.param)); });

TEST(Lengths, what_is_not_a_number_is_no_motion_and_is_refused_at_the_door) {
  const Motion exact = random_motion(make_standard_body(), 4, 35);
  std::vector<Vec3> positions;
  for (int f = 0; f < exact.frame_count(); ++f)
    positions.insert(positions.end(), exact.positions(f).begin(), exact.positions(f).end());
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    std::vector<Vec3> spoilt = positions;
    spoilt[40].y = bad;
    const auto made =
        Motion::from_positions(exact.skeleton(), {exact.times().begin(), exact.times().end()}, spoilt);
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().code, ErrorCode::Malformed);
    // A stream refuses the frame and goes on with the next.
    for (const RetargetMethod method : {RetargetMethod::Rotation, RetargetMethod::Network}) {
      RetargetOptions options;
      options.method = method;
      StreamedRetargeter stream(exact.skeleton(), make_standard_body({.height_m = 1.6}), options);
      const std::vector<double> sure(static_cast<std::size_t>(exact.joint_count()), 1.0);
      const auto joints = sure.size();
      ASSERT_TRUE(stream.push(exact.time(0), exact.positions(0), sure));
      const auto refused = stream.push(exact.time(1), std::span(spoilt).subspan(joints, joints), sure);
      ASSERT_FALSE(refused);
      EXPECT_EQ(refused.error().code, ErrorCode::Malformed);
      EXPECT_TRUE(stream.push(exact.time(2), exact.positions(2), sure));
    }
  }
}

class Cuts : public testing::TestWithParam<RetargetMethod> {};

TEST_P(Cuts, a_motion_cut_anywhere_gives_the_same_poses) {
  const Motion coach = random_motion(make_standard_body(), 120, 36);
  const Skeleton body = make_standard_body({.height_m = 1.6, .arms = 1.15, .shins = 1.1});
  for (const Motion& motion : {coach, without_rotations(coach)}) {
    const auto whole = retarget(motion, body, {.method = GetParam()});
    ASSERT_TRUE(whole);
    for (const auto& [from, to] :
         {std::pair(0, 64), std::pair(32, 96), std::pair(7, 8), std::pair(53, 120)}) {
      const auto part = retarget(motion.slice(from, to), body, {.method = GetParam()});
      ASSERT_TRUE(part);
      EXPECT_LT(largest_difference(part->motion, whole->motion.slice(from, to)), 1e-12);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, Cuts,
                         testing::Values(RetargetMethod::Rotation, RetargetMethod::Direction,
                                         RetargetMethod::Scale, RetargetMethod::Network),
                         [](const auto& method) { return std::string(to_string(method.param)); });

TEST(Lengths, an_hour_goes_through_at_once_as_it_does_in_pieces) {
  const Skeleton body = small_body(0.9);
  for (const RetargetMethod method : {RetargetMethod::Rotation, RetargetMethod::Network}) {
    const auto whole = retarget(hour(), body, {.method = method});
    ASSERT_TRUE(whole) << whole.error().message;
    EXPECT_EQ(whole->motion.frame_count(), kHour);
    EXPECT_LT(whole->bone_length_error_max, 1e-9);
    for (const int from : {0, 50000, kHour - 100}) {
      const auto part = retarget(hour().slice(from, from + 100), body, {.method = method});
      ASSERT_TRUE(part);
      EXPECT_LT(largest_difference(part->motion, whole->motion.slice(from, from + 100)), 1e-9);
    }
  }
}

TEST(Lengths, an_hour_streams) {
  const Skeleton body = small_body(0.9);
  StreamedRetargeter stream(hour().skeleton(), body, {});
  const std::vector<double> sure(static_cast<std::size_t>(hour().joint_count()), 1.0);
  for (int f = 0; f < kHour; f += 3) {
    const auto student = stream.push(hour().time(f), hour().positions(f), sure);
    ASSERT_TRUE(student) << student.error().message;
    if (f % 9999 == 0) {
      const auto alone = retarget(without_rotations(hour().slice(f, f + 1)), body);
      ASSERT_TRUE(alone);
      EXPECT_LT(largest_difference(*student, alone->motion), 1e-12);
    }
  }
}

}  // namespace
}  // namespace posecoach
