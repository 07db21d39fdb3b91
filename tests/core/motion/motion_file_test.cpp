#include "core/motion/motion_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "bvh_samples.h"
#include "c3d_sample.h"
#include "core/base/file.h"
#include "core/body/body_file.h"
#include "core/body/standard_body.h"
#include "core/motion/pose_file.h"
#include "marker_samples.h"

namespace posecoach {
namespace {

using testing::HasSubstr;

std::filesystem::path scratch(const std::string& name) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "posecoach_motion_file_test";
  std::filesystem::create_directories(folder);
  return folder / name;
}

std::filesystem::path file_with(const std::string& name, std::string_view bytes) {
  const auto path = scratch(name);
  EXPECT_TRUE(write_file_atomically(path, bytes));
  return path;
}

TEST(MotionFile, is_told_by_its_contents_whatever_it_is_called) {
  const Motion person = samples::moving_person(5);
  ASSERT_TRUE(write_motion_file(scratch("a.bvh"), person));
  ASSERT_TRUE(write_motion_file(scratch("a.trc"), person));
  ASSERT_TRUE(write_motion_file(scratch("a.pose.json"), person));
  const std::pair<const char*, MotionFormat> kinds[] = {
      {"a.bvh", MotionFormat::Bvh}, {"a.trc", MotionFormat::Trc}, {"a.pose.json", MotionFormat::PoseMotion}};
  for (const auto& [name, format] : kinds) {
    const auto renamed = file_with("renamed.c3d", read_file(scratch(name)).value());
    EXPECT_EQ(motion_format(renamed).value(), format);
    const auto motion = read_motion_file(renamed);
    ASSERT_TRUE(motion) << motion.error().message;
    EXPECT_EQ(motion->motion.frame_count(), 5);
    const int wrist = motion->motion.skeleton().find(HumanoidJoint::LeftWrist);
    EXPECT_LT(glm::distance(motion->motion.position(4, wrist),
                            person.position(4, person.skeleton().find(HumanoidJoint::LeftWrist))),
              1e-6);
  }
}

TEST(MotionFile, a_c3d_of_joints_is_a_motion) {
  const MarkerTrack track = samples::markers_of(samples::moving_person(10), samples::blazepose_labels());
  const auto path = file_with(
      "a.c3d", samples::c3d_bytes({.units = "m", .labels = track.labels, .positions = track.positions}));
  const auto file = read_motion_file(path);
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_EQ(file->motion.frame_count(), 10);
  EXPECT_FALSE(file->motion.has_rotations());
}

TEST(MotionFile, what_is_none_is_refused_in_one_line_with_its_name) {
  EXPECT_EQ(read_motion_file(scratch("missing.bvh")).error().code, ErrorCode::NotFound);
  const std::tuple<const char*, std::string, ErrorCode> cases[] = {
      {"empty.bvh", "", ErrorCode::Malformed},
      {"film.mp4",
       std::string("\0\0\0\x20"
                   "ftypisom",
                   12),
       ErrorCode::Unsupported},
      {"text.txt", "hello", ErrorCode::Unsupported},
      {"text.bvh", "hello", ErrorCode::Malformed},
      {"text.c3d", "hello", ErrorCode::Malformed},
      {"text.trc", "hello", ErrorCode::Malformed},
      {"text.pose.json", "hello", ErrorCode::Malformed},
      {"other.json", "{\"a\": 1}", ErrorCode::Unsupported},
      {"film.bvh", std::string("\x1A\x45\xDF\xA3 not text \n\n", 16), ErrorCode::Malformed}};
  for (const auto& [name, bytes, code] : cases) {
    const auto read = read_motion_file(file_with(name, bytes));
    ASSERT_FALSE(read) << name;
    EXPECT_EQ(read.error().code, code) << name;
    EXPECT_THAT(read.error().message, HasSubstr(name));
    EXPECT_EQ(read.error().message.find('\n'), std::string::npos);
  }
}

TEST(MotionFile, a_film_s_landmarks_are_no_motion_yet) {
  const auto path = scratch("film.pose.json");
  ASSERT_TRUE(write_pose_track(path, {"a.mp4", 10, 10, {}}));
  EXPECT_EQ(motion_format(path).value(), MotionFormat::PoseTrack);
  EXPECT_EQ(read_motion_file(path).error().code, ErrorCode::Unsupported);
}

TEST(MotionFile, folders_of_pictures_and_long_films_are_none) {
  const auto folder = scratch("pictures");
  std::filesystem::create_directories(folder);
  ASSERT_TRUE(write_file_atomically(folder / "1.png", "x"));
  ASSERT_TRUE(write_file_atomically(folder / "truth.json", "{}"));
  EXPECT_EQ(motion_format(folder).error().code, ErrorCode::Unsupported);
  std::filesystem::resize_file(file_with("long.mp4", "ftyp"), std::uintmax_t{1} << 34);  // a hole, no bytes
  EXPECT_EQ(motion_format(scratch("long.mp4")).error().code, ErrorCode::Unsupported);
  std::filesystem::remove(scratch("long.mp4"));
}

TEST(MotionFile, a_long_json_may_say_at_its_end_what_it_is) {
  std::string text = "{\"frames\": [], \"source\": \"" + std::string(200'000, 'x') +
                     "\", \"joints\": [], \"schema\": \"posecoach.pose/1\"}";
  EXPECT_EQ(motion_format(file_with("sorted.json", text)).value(), MotionFormat::PoseTrack);
}

TEST(SkeletonFile, comes_from_motions_bodies_and_skeletons_alone) {
  const Skeleton body = make_standard_body();
  ASSERT_TRUE(write_body_file(scratch("a.body.json"), body));
  const auto from_body = read_skeleton_file(scratch("a.body.json"));
  ASSERT_TRUE(from_body) << from_body.error().message;
  EXPECT_EQ(from_body->skeleton.size(), body.size());
  EXPECT_EQ(read_motion_file(scratch("a.body.json")).error().code, ErrorCode::Incomplete);
  std::string bvh = samples::body_bvh(samples::kMixamo, 100);
  const auto from_motion = read_skeleton_file(file_with("b.bvh", bvh));
  bvh.replace(bvh.find("Frames: 2"), std::string::npos, "Frames: 0\nFrame Time: 0.033\n");
  const auto from_hierarchy = read_skeleton_file(file_with("c.bvh", bvh));
  ASSERT_TRUE(from_hierarchy);
  EXPECT_TRUE(from_hierarchy->skeleton == from_motion->skeleton);
}

TEST(MotionFile, is_written_by_the_ending_of_its_name) {
  const Motion person = samples::moving_person(3);
  const auto wrong = write_motion_file(scratch("a.fbx"), person);
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().code, ErrorCode::InvalidArgument);
  EXPECT_THAT(wrong.error().message, HasSubstr(".bvh, .trc or .pose.json"));
  ASSERT_TRUE(write_motion_file(scratch("positions.trc"), person));
  const MotionFile trc = read_motion_file(scratch("positions.trc")).value();
  const auto no_rotations = write_motion_file(scratch("b.bvh"), trc.motion);
  ASSERT_FALSE(no_rotations);
  EXPECT_EQ(no_rotations.error().code, ErrorCode::Unsupported);
}

}  // namespace
}  // namespace posecoach
