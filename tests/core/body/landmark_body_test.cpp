#include "core/body/landmark_body.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <random>

#include "core/body/body_file.h"
#include "core/body/body_measurement.h"
#include "core/body/forward_kinematics.h"

namespace posecoach {
namespace {

LandmarkBodyLengths plausible_lengths() {
  LandmarkBodyLengths lengths{};
  lengths.fill(0.08);
  lengths[0] = lengths[1] = lengths[3] = 0;
  lengths[2] = 0.50;
  lengths[4] = 0.20;
  const auto set = [&](Landmark left, double length) {
    lengths[static_cast<std::size_t>(landmark_joint(left))] = length;
    lengths[static_cast<std::size_t>(landmark_joint(mirrored(left)))] = length;
  };
  set(Landmark::LeftShoulder, 0.18);
  set(Landmark::LeftElbow, 0.29);
  set(Landmark::LeftWrist, 0.26);
  set(Landmark::LeftHip, 0.10);
  set(Landmark::LeftKnee, 0.43);
  set(Landmark::LeftAnkle, 0.42);
  set(Landmark::LeftFootIndex, 0.18);
  set(Landmark::LeftHeel, 0.09);
  return lengths;
}

// A person in a random posture as a camera sees him: hip-centred, y down, noise in the picture's plane, more
// in depth, some landmarks hidden and then guessed badly.
WorldKeypoints look_at(const Skeleton& body, std::mt19937& random, double hidden_share) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  Pose pose = rest_pose(body);
  for (Quat& rotation : pose.rotations)
    rotation = glm::normalize(Quat(1, 0.4 * normal(random), 0.4 * normal(random), 0.4 * normal(random)));
  const auto positions = forward_kinematics(body, pose);
  WorldKeypoints seen;
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    Vec3 p = positions[i + kLandmarkBodyDerivedJoints] - positions[0];
    p += Vec3(0.008 * normal(random), 0.008 * normal(random), 0.04 * normal(random));
    const bool hidden = uniform(random) < hidden_share;
    if (hidden) p += Vec3(0.2 * normal(random), 0.2 * normal(random), 0.2 * normal(random));
    seen[i] = {{p.x, -p.y, -p.z}, hidden ? 0.2 : 0.95};
  }
  return seen;
}

TEST(LandmarkBody, stands_on_the_floor_in_t_pose_with_the_lengths_asked_for) {
  const LandmarkBodyLengths lengths = plausible_lengths();
  const Skeleton body = make_landmark_body(lengths);
  double lowest = 1;
  for (const Vec3& p : body.rest_positions()) lowest = std::min(lowest, p.y);
  EXPECT_NEAR(lowest, 0, 1e-12);
  for (int j = 1; j < body.size(); ++j)
    EXPECT_NEAR(body.bone_length(j), lengths[static_cast<std::size_t>(j)], 1e-12) << body.joint(j).name;
  EXPECT_TRUE(is_landmark_body(body));
  EXPECT_GT(body.rest_positions()[static_cast<std::size_t>(landmark_joint(Landmark::LeftWrist))].x, 0.5);
}

TEST(LandmarkBody, derived_joints_are_the_middles_of_their_landmarks) {
  std::array<Vec3, kLandmarkCount> points;
  for (std::size_t i = 0; i < kLandmarkCount; ++i) points[i] = Vec3(double(i), double(i * i), 1);
  const auto joints = landmark_body_positions(points);
  const auto at = [&](Landmark l) { return points[static_cast<std::size_t>(l)]; };
  EXPECT_EQ(joints[0], 0.5 * (at(Landmark::LeftHip) + at(Landmark::RightHip)));
  EXPECT_EQ(joints[2], 0.5 * (at(Landmark::LeftShoulder) + at(Landmark::RightShoulder)));
  EXPECT_EQ(joints[static_cast<std::size_t>(landmark_joint(Landmark::RightKnee))], at(Landmark::RightKnee));
}

TEST(BodyMeasurement, noisy_hidden_and_foreshortened_looks_still_give_the_bone_ratios) {
  const Skeleton body = make_landmark_body(plausible_lengths());
  std::mt19937 random(5);
  std::vector<WorldKeypoints> frames;
  for (int i = 0; i < 200; ++i) frames.push_back(look_at(body, random, 0.2));
  const Result<Skeleton> measured = measure_landmark_body(frames);
  ASSERT_TRUE(measured) << measured.error().message;
  const double torso = measured->bone_length(2) / body.bone_length(2);
  for (const Landmark l : {Landmark::LeftElbow, Landmark::LeftWrist, Landmark::RightKnee, Landmark::LeftAnkle,
                           Landmark::LeftShoulder, Landmark::RightHip}) {
    const int j = landmark_joint(l);
    // 4 %, and half of the noise of a joint for bones that are hardly longer than it.
    EXPECT_NEAR(measured->bone_length(j) / torso, body.bone_length(j), 0.04 * body.bone_length(j) + 0.004)
        << to_string(l);
  }
  EXPECT_EQ(measured->bone_length(landmark_joint(Landmark::LeftKnee)),
            measured->bone_length(landmark_joint(Landmark::RightKnee)));
}

TEST(BodyMeasurement, an_arm_that_is_never_seen_takes_the_other_arms_length) {
  const Skeleton body = make_landmark_body(plausible_lengths());
  std::mt19937 random(6);
  std::vector<WorldKeypoints> frames;
  for (int i = 0; i < 50; ++i) {
    frames.push_back(look_at(body, random, 0));
    for (const Landmark l : {Landmark::LeftElbow, Landmark::LeftWrist}) frames.back()[l] = {{3, 3, 3}, 0.0};
  }
  const Result<Skeleton> measured = measure_landmark_body(frames);
  ASSERT_TRUE(measured);
  const int elbow = landmark_joint(Landmark::LeftElbow);
  EXPECT_NEAR(measured->bone_length(elbow), body.bone_length(elbow), 0.02);
}

TEST(BodyMeasurement, a_limb_that_is_clearly_shorter_on_one_side_stays_so) {
  std::vector<BoneSighting> left, right;
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 0.01);
  for (int i = 0; i < 100; ++i) {
    left.push_back({0.25 + noise(random), 0.24, 1});
    right.push_back({0.40 + noise(random), 0.39, 1});
  }
  const auto pair = measure_bone_pair(left, right);
  ASSERT_TRUE(pair);
  EXPECT_NEAR(pair->left_m, 0.25, 0.01);
  EXPECT_NEAR(pair->right_m, 0.40, 0.01);
}

// Down the line, the arm behind the trunk: where the model places it, it looks short and trustworthy; where
// it spans more, the model hardly trusts itself.
TEST(BodyMeasurement, an_arm_that_is_guessed_behind_the_trunk_is_not_shorter_than_the_other) {
  std::mt19937 random(10);
  std::normal_distribution<double> noise(0, 0.004);
  std::vector<BoneSighting> seen, foreshortened, spans_more;
  for (int i = 0; i < 100; ++i) {
    seen.push_back({0.26 + noise(random), 0.25, 0.9});
    foreshortened.push_back({0.18 + noise(random), 0.09, 0.8});
    spans_more.push_back(i % 3 == 0 ? BoneSighting{0.27, 0.26, 0.005}
                                    : BoneSighting{0.19 + noise(random), 0.185, 0.9});
  }
  for (const auto& guessed : {foreshortened, spans_more}) {
    const auto pair = measure_bone_pair(guessed, seen);
    ASSERT_TRUE(pair);
    EXPECT_EQ(pair->left_m, pair->right_m);
    const auto mirrored = measure_bone_pair(seen, guessed);
    EXPECT_EQ(mirrored->left_m, mirrored->right_m);
  }
}

TEST(BodyMeasurement, looks_that_squash_the_bone_towards_the_camera_do_not_shorten_it) {
  std::vector<BoneSighting> sightings;
  std::mt19937 random(9);
  std::uniform_real_distribution<double> out_of_picture(0, kPi / 2);
  for (int i = 0; i < 300; ++i) {
    const double angle = out_of_picture(random), across = 0.30 * std::cos(angle),
                 depth = 0.30 * std::sin(angle);
    sightings.push_back({std::hypot(across, 0.4 * depth), across, 0.9});
  }
  EXPECT_NEAR(measure_bone(sightings)->length_m, 0.30, 0.012);
}

TEST(BodyMeasurement, a_side_that_is_seen_badly_takes_the_length_of_the_other) {
  const std::vector<BoneSighting> hidden(100, {0.18, 0.16, 0.1}), seen(100, {0.30, 0.28, 0.9});
  const auto pair = measure_bone_pair(hidden, seen);
  ASSERT_TRUE(pair);
  EXPECT_EQ(pair->left_m, 0.30);
  EXPECT_EQ(pair->right_m, 0.30);
}

TEST(BodyMeasurement, a_given_height_scales_the_whole_body) {
  const Skeleton body = make_landmark_body(plausible_lengths());
  std::mt19937 random(8);
  const std::vector<WorldKeypoints> frames = {look_at(body, random, 0), look_at(body, random, 0)};
  const auto tall = measure_landmark_body(frames, {1.90}), small = measure_landmark_body(frames, {1.50});
  ASSERT_TRUE(tall && small);
  EXPECT_NEAR(stature(*tall), 1.90, 1e-9);
  EXPECT_NEAR(tall->bone_length(2) / small->bone_length(2), 1.90 / 1.50, 1e-9);
  EXPECT_EQ(measure_landmark_body(frames, {17.0}).error().code, ErrorCode::InvalidArgument);
  EXPECT_EQ(measure_landmark_body({}).error().code, ErrorCode::Incomplete);
}

TEST(BodyFile, a_body_comes_back_as_it_was_written) {
  const Skeleton body = make_landmark_body(plausible_lengths());
  const Result<Skeleton> back = body_from_json(body_to_json(body), "body.json");
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(*back, body);
}

TEST(BodyFile, what_is_no_body_file_is_malformed_and_named) {
  for (const char* text :
       {"", "{", "[]", "{\"schema\": \"posecoach.pose/1\"}", "{\"schema\": \"posecoach.body/1\"}",
        R"({"schema": "posecoach.body/1", "joints": [{"name": "a", "parent": "b", "offset_m": [0,0,0]}]})",
        R"({"schema": "posecoach.body/1", "joints": [{"name": "a", "parent": null, "offset_m": [0,0]}]})"}) {
    const Result<Skeleton> read = body_from_json(text, "odd.body.json");
    ASSERT_FALSE(read) << text;
    EXPECT_EQ(read.error().code, ErrorCode::Malformed);
    EXPECT_EQ(read.error().message.find("odd.body.json:1: "), 0u) << read.error().message;
  }
}

TEST(BodyFile, the_joint_that_does_not_fit_is_found_by_its_line) {
  const char* text =
      "{\"schema\": \"posecoach.body/1\", \"joints\": [\n"
      "{\"name\": \"a\", \"parent\": null, \"offset_m\": [0, 1, 0]},\n"
      "{\"name\": \"b\", \"parent\": \"a\", \"offset_m\": [0, 1, 0]},\n"
      "{\"name\": \"b\", \"parent\": \"a\", \"offset_m\": [0, 2, 0]},\n"
      "{\"name\": \"c\", \"parent\": \"a\", \"offset_m\": [0, 2, 0]}]}";
  EXPECT_EQ(body_from_json(text, "two.body.json").error().message,
            "two.body.json:4: two joints are called b");
}

}  // namespace
}  // namespace posecoach
