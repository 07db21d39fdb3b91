#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/file.h"
#include "core/motion/motion_file.h"
#include "core/motion/openpose_reader.h"

namespace posecoach {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

// 25 joints in a row from (x, y), one pixel apart.
std::string person(double x, double confidence) {
  std::string text = "{\"person_id\":[-1],\"pose_keypoints_2d\":[";
  for (int j = 0; j < 25; ++j)
    text += (j == 0 ? "" : ",") + std::to_string(x + j) + "," + std::to_string(10 * j) + "," +
            std::to_string(confidence);
  return text + "],\"face_keypoints_2d\":[]}";
}
std::string frame(const std::string& people) {
  return "{\"version\":1.3,\n\"people\":[" + people + "]}\n";
}

TEST(OpenPose, joints_become_landmarks_and_the_others_are_not_seen) {
  const auto people = read_openpose_json("a.json", frame(person(100, 0.75))).value();
  ASSERT_EQ(people.size(), 1u);
  EXPECT_EQ(people[0][Landmark::LeftWrist].position_px, Vec2(107, 70));
  EXPECT_EQ(people[0][Landmark::RightHeel].position_px, Vec2(124, 240));
  EXPECT_EQ(people[0][Landmark::Nose].visibility, 0.75);
  EXPECT_EQ(people[0][Landmark::LeftThumb].visibility, 0);
}

TEST(OpenPose, a_folder_is_a_track_that_follows_one_person) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "posecoach_openpose_test";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  EXPECT_EQ(read_openpose_folder(folder).error().code, ErrorCode::Incomplete);
  const auto name = [&](int number) {
    return folder / ("film_00000000000" + std::to_string(number) + "_keypoints.json");
  };
  ASSERT_TRUE(write_file_atomically(name(3), frame(person(500, 0.5) + "," + person(100, 0.9))));
  ASSERT_TRUE(write_file_atomically(name(4), frame("")));
  ASSERT_TRUE(write_file_atomically(name(5), frame(person(495, 0.95) + "," + person(104, 0.4))));
  const ImageTrack track = read_openpose_folder(folder).value();
  ASSERT_EQ(track.frames.size(), 3u);
  EXPECT_EQ(track.frames[0].frame_index, 3u);
  EXPECT_EQ((*track.frames[0].person)[Landmark::Nose].position_px.x, 100);
  EXPECT_FALSE(track.frames[1].person);
  EXPECT_EQ((*track.frames[2].person)[Landmark::Nose].position_px.x, 104);

  EXPECT_EQ(motion_format(folder).value(), MotionFormat::OpenPoseFolder);
  const auto motion = read_motion_file(folder);
  ASSERT_FALSE(motion);
  EXPECT_EQ(motion.error().code, ErrorCode::Unsupported);
  EXPECT_THAT(motion.error().message, HasSubstr("2D joints only"));
}

TEST(OpenPose, every_mistake_is_one_line_that_names_file_and_line) {
  const auto expect_bad = [](const std::string& text, const std::string& what,
                             ErrorCode code = ErrorCode::Malformed) {
    const auto read = read_openpose_json("a.json", text);
    ASSERT_FALSE(read) << what;
    EXPECT_EQ(read.error().code, code);
    EXPECT_THAT(read.error().message, StartsWith("a.json:"));
    EXPECT_THAT(read.error().message, HasSubstr(what));
  };
  expect_bad("", "not valid JSON");
  expect_bad("{}", "no \"people\"");
  expect_bad("{\"people\": 3}", "needs a list");
  expect_bad(frame("{}"), "2: a person without \"pose_keypoints_2d\"");
  expect_bad(frame("{\"pose_keypoints_2d\":[1,2,3]}"), "only BODY_25 is supported", ErrorCode::Unsupported);
  std::string text = person(0, 1);
  text.replace(text.find("0.000000,0,"), 8, "\"zero\"");
  expect_bad(frame(text), "needs 75 numbers");
}

}  // namespace
}  // namespace posecoach
