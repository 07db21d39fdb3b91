#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "core/body/standard_body.h"
#include "core/motion/bundled_motion.h"
#include "core/retarget/doubt.h"
#include "core/retarget/grip.h"
#include "core/retarget/retarget.h"
#include "core/retarget/streamed.h"
#include "core/retarget/webcam_noise.h"
#include "tests/core/retarget/motions.h"

namespace posecoach {
namespace {

Motion filmed_swing(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  return with_webcam_noise(resample(*bundled_motion("swing"), 30), random);
}

TEST(WebcamNoise, is_the_same_for_the_same_seed_and_worse_in_depth) {
  const Motion clean = resample(*bundled_motion("swing"), 30), one = filmed_swing(1), same = filmed_swing(1);
  EXPECT_FALSE(one.has_rotations());
  Vec3 squares(0);
  for (int f = 0; f < one.frame_count(); ++f)
    for (int j = 0; j < one.joint_count(); ++j) {
      EXPECT_EQ(one.position(f, j), same.position(f, j));
      const Vec3 off = one.position(f, j) - clean.position(f, j);
      squares += off * off;
    }
  EXPECT_GT(squares.z, 4 * squares.x);
}

TEST(Doubt, leaves_exact_motions_alone_and_sees_what_a_webcam_did) {
  const Motion clean = resample(*bundled_motion("swing"), 30);
  for (const Motion& motion : {clean, without_rotations(clean)})
    for (const double doubt : doubts(motion)) EXPECT_EQ(doubt, 0);
  for (const double doubt : doubts(filmed_swing(2))) EXPECT_EQ(doubt, 1);
}

// Skin slides over bones, and some markers are lost at times.
TEST(Doubt, leaves_markers_alone_that_change_their_distances) {
  const Motion clean = resample(*bundled_motion("swing"), 120);
  std::mt19937_64 random(3);
  std::normal_distribution<double> slide(0, 0.03);
  std::vector<Vec3> positions;
  std::vector<double> confidence;
  for (int f = 0; f < clean.frame_count(); ++f)
    for (int j = 0; j < clean.joint_count(); ++j) {
      positions.push_back(clean.position(f, j) + Vec3(slide(random), slide(random), slide(random)));
      confidence.push_back(f % 10 == 0 && j % 3 == 0 ? 0.5 : 1);
    }
  const Motion markers = *Motion::from_positions(
      clean.skeleton(), {clean.times().begin(), clean.times().end()}, positions, confidence);
  EXPECT_FALSE(is_seen_by_camera(markers));
  EXPECT_TRUE(is_seen_by_camera(filmed_swing(2)));
  for (const double doubt : doubts(markers)) EXPECT_EQ(doubt, 0);
}

TEST(Network, keeps_the_hands_of_a_filmed_coach_on_the_club) {
  const Motion coach = filmed_swing(4);
  const Skeleton body = make_standard_body({.height_m = 1.7});
  const auto student = retarget(coach, body, {RetargetMethod::Network, Contacts::On});
  ASSERT_TRUE(student);
  const auto apart = [](const Motion& motion, int frame) {
    return glm::length(wrist_relation(motion.skeleton(), motion.positions(frame)));
  };
  double widest_seen = 0;
  for (int f = 0; f < coach.frame_count(); ++f) {
    widest_seen = std::max(widest_seen, apart(coach, f));
    EXPECT_LT(apart(student->motion, f), 0.12) << f;
  }
  EXPECT_GT(widest_seen, 0.2);
}

TEST(Network, is_geometry_but_for_the_stride_where_there_is_nothing_to_doubt) {
  const Motion coach = resample(*bundled_motion("swing"), 30);
  const Skeleton body = make_standard_body({.height_m = 1.6, .arms = 1.15, .thighs = 1.1});
  RetargetOptions options;
  options.stride = Stride::LikeCoach;
  for (const Motion& motion : {coach, without_rotations(coach)}) {
    const auto network = retarget(motion, body, {.method = RetargetMethod::Network});
    const auto geometry = retarget(motion, body, options);
    ASSERT_TRUE(network && geometry);
    for (int f = 0; f < coach.frame_count(); ++f)
      for (int j = 0; j < body.size(); ++j)
        EXPECT_EQ(network->motion.position(f, j), geometry->motion.position(f, j));
  }
}

TEST(Stride, legs_point_where_the_coachs_do_and_knees_stay_bent_as_they_are) {
  const Motion coach = with_rest_pose_changed(resample(*bundled_motion("swing"), 30), HumanoidJoint::LeftHip,
                                              Vec3(1, 0, 0), radians_from_degrees(6));
  const Skeleton body = make_standard_body({.height_m = 1.8, .thighs = 0.9, .shins = 1.1});
  const auto turned = retarget(coach, body, {.stride = Stride::AsTurned});
  const auto student = retarget(coach, body, {.stride = Stride::LikeCoach});
  ASSERT_TRUE(student && turned);
  using enum HumanoidJoint;
  double turned_off = 0;
  for (int f = 0; f < coach.frame_count(); ++f)
    for (const auto& [hip, ankle] : {std::pair(LeftHip, LeftAnkle), std::pair(RightHip, RightAnkle)}) {
      const auto way = [&](const Motion& motion) {
        return motion.position(f, motion.skeleton().find(ankle)) -
               motion.position(f, motion.skeleton().find(hip));
      };
      EXPECT_LT(glm::distance(glm::normalize(way(student->motion)), glm::normalize(way(coach))), 1e-6);
      EXPECT_NEAR(glm::length(way(student->motion)), glm::length(way(turned->motion)), 1e-9);
      turned_off = std::max(turned_off,
                            glm::distance(glm::normalize(way(turned->motion)), glm::normalize(way(coach))));
    }
  EXPECT_GT(turned_off, 0.05);
  EXPECT_LT(student->bone_length_error_max, 1e-9);
}

TEST(Network, keeps_bones_and_times_of_filmed_motions_of_any_length) {
  const Skeleton body = make_standard_body({.height_m = 1.6, .arms = 1.15});
  const Motion filmed = filmed_swing(3);
  for (const int frames : {1, 3, filmed.frame_count()}) {
    const Motion coach = filmed.slice(0, frames);
    const auto carried = retarget(coach, body, {.method = RetargetMethod::Network});
    ASSERT_TRUE(carried) << carried.error().message;
    EXPECT_EQ(carried->motion.frame_count(), frames);
    EXPECT_LT(carried->bone_length_error_max, 1e-9);
  }
}

TEST(StreamedRetargeter, gives_an_exact_coach_the_same_poses_as_the_whole_motion_does) {
  const Skeleton body = make_standard_body({.height_m = 1.6, .arms = 1.15});
  const Motion coach = without_rotations(resample(*bundled_motion("swing"), 30)).slice(0, 40);
  RetargetOptions options;
  const auto whole = retarget(coach, body, options);
  ASSERT_TRUE(whole);
  StreamedRetargeter stream(coach.skeleton(), body, options);
  const std::vector<double> sure(static_cast<std::size_t>(coach.joint_count()), 1.0);
  for (int f = 0; f < coach.frame_count(); ++f) {
    const auto frame = stream.push(coach.time(f), coach.positions(f), sure);
    ASSERT_TRUE(frame) << frame.error().message;
    for (int j = 0; j < body.size(); ++j)
      EXPECT_LT(glm::distance(frame->position(0, j), whole->motion.position(f, j)), 1e-9);
  }
  EXPECT_FALSE(stream.push(coach.time(0), coach.positions(0), sure));
}

TEST(StreamedRetargeter, keeps_the_bones_of_a_student_whose_coach_is_being_filmed) {
  const Skeleton body = make_standard_body({.height_m = 1.6, .arms = 1.15});
  const Motion filmed = filmed_swing(5).slice(0, 40);
  RetargetOptions options;
  options.method = RetargetMethod::Network;
  StreamedRetargeter stream(filmed.skeleton(), body, options);
  for (int f = 0; f < filmed.frame_count(); ++f) {
    std::vector<double> confidence;
    for (int j = 0; j < filmed.joint_count(); ++j) confidence.push_back(filmed.confidence(f, j));
    const auto frame = stream.push(filmed.time(f), filmed.positions(f), confidence);
    ASSERT_TRUE(frame) << frame.error().message;
    EXPECT_EQ(frame->time(0), filmed.time(f));
    EXPECT_LT(bone_length_error(*frame), 1e-9);
  }
}

TEST(StreamedRetargeter, is_nearer_to_the_truth_than_smoothed_geometry_though_it_knows_no_future) {
  const Skeleton body = make_standard_body({.height_m = 1.6, .arms = 1.15});
  const auto truth = retarget(resample(*bundled_motion("swing"), 30), body);
  ASSERT_TRUE(truth);
  RetargetOptions network, smoothed;
  network.method = RetargetMethod::Network;
  smoothed.smoothing = InputSmoothing::WhereDoubtful;
  double streamed = 0, whole = 0, geometry = 0;
  const auto add = [&](const Result<RetargetResult>& student, double& sum) {
    ASSERT_TRUE(student) << student.error().message;
    for (int f = 0; f < truth->motion.frame_count(); ++f)
      for (int j = 0; j < body.size(); ++j) {
        const Vec3 off = student->motion.position(f, j) - student->motion.position(f, 0) -
                         (truth->motion.position(f, j) - truth->motion.position(f, 0));
        sum += glm::dot(off, off);
      }
  };
  for (std::uint64_t seed = 11; seed < 14; ++seed) {
    const Motion coach = filmed_swing(seed);
    add(retarget_streamed(coach, body, network), streamed);
    add(retarget(coach, body, network), whole);
    add(retarget(coach, body, smoothed), geometry);
  }
  EXPECT_LT(streamed, 0.6 * geometry) << streamed / geometry;
  EXPECT_LT(streamed, 1.6 * whole) << streamed / whole;
}

// A turn changes where the camera stands, which the correction looks at; a shift changes nothing.
TEST(Network, follows_a_filmed_coachs_world_when_it_is_shifted) {
  const Skeleton body = make_standard_body({.height_m = 1.6, .arms = 1.15});
  const Motion filmed = filmed_swing(7);
  const auto here = retarget(filmed, body, {.method = RetargetMethod::Network});
  const auto there = retarget(transformed(filmed, Quat(1, 0, 0, 0), Vec3(0.4, 0, -0.6)), body,
                              {.method = RetargetMethod::Network});
  ASSERT_TRUE(here && there);
  const Vec3 shift = there->motion.position(0, 0) - here->motion.position(0, 0);
  for (int f = 0; f < filmed.frame_count(); ++f)
    for (int j = 0; j < body.size(); ++j)
      EXPECT_LT(glm::distance(there->motion.position(f, j), here->motion.position(f, j) + shift), 1e-4);
}

TEST(Network, does_not_depend_on_where_a_motion_was_cut) {
  const Skeleton body = make_standard_body({.height_m = 1.6, .arms = 1.15});
  std::mt19937_64 random(4);
  const Motion filmed = with_webcam_noise(random_motion(make_standard_body(), 360, 12), random);
  const auto whole = retarget(filmed, body, {.method = RetargetMethod::Network});
  const auto part = retarget(filmed.slice(40, 320), body, {.method = RetargetMethod::Network});
  ASSERT_TRUE(whole && part);
  // Further from the cuts than any smoothing and the network reach.
  for (int f = 150; f < 210; ++f)
    for (int j = 0; j < body.size(); ++j)
      EXPECT_LT(glm::distance(whole->motion.position(f, j), part->motion.position(f - 40, j)), 1e-4);
}

TEST(Network, is_nearer_to_the_truth_than_geometry_on_filmed_motions) {
  const Skeleton body = make_standard_body({.height_m = 1.6, .arms = 1.15});
  const Motion clean = resample(*bundled_motion("swing"), 30);
  const auto truth = retarget(clean, body);
  ASSERT_TRUE(truth);
  const auto error = [&](const Motion& motion) {
    double sum = 0;
    for (int f = 0; f < motion.frame_count(); ++f)
      for (int j = 0; j < motion.joint_count(); ++j) {
        const Vec3 off = motion.position(f, j) - motion.position(f, 0) -
                         (truth->motion.position(f, j) - truth->motion.position(f, 0));
        sum += glm::dot(off, off);
      }
    return sum;
  };
  double network = 0, rotation = 0;
  for (std::uint64_t seed = 11; seed < 17; ++seed) {
    const Motion coach = filmed_swing(seed);
    const auto ours = retarget(coach, body, {.method = RetargetMethod::Network});
    const auto plain = retarget(
        coach, body, {.method = RetargetMethod::Rotation, .smoothing = InputSmoothing::WhereDoubtful});
    ASSERT_TRUE(ours && plain);
    network += error(ours->motion);
    rotation += error(plain->motion);
  }
  EXPECT_LT(network, 0.75 * rotation) << network / rotation;
}

}  // namespace
}  // namespace posecoach
