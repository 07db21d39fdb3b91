#include "core/motion/pose_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <random>

#include "core/base/file.h"
#include "core/body/standard_body.h"

namespace posecoach {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

PoseTrack sample_track() {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  PoseTrack track{"swing \"one\".mp4", 640, 360, {}};
  for (std::size_t f = 0; f < 4; ++f) {
    PoseObservation observation{
        f + 10, media_time_from_seconds(0.04 * static_cast<double>(f) + 0.0123456789), {}};
    if (f != 2) {
      SeenPerson person;
      for (std::size_t l = 0; l < kLandmarkCount; ++l) {
        person.image[l] = {{640 * unit(random), 360 * unit(random)}, unit(random)};
        person.world[l] = {{unit(random) - 0.5, unit(random) - 0.5, unit(random) - 0.5}, unit(random)};
      }
      observation.person = person;
    }
    track.frames.push_back(observation);
  }
  return track;
}

std::string written(const PoseTrack& track) {
  const auto path = std::filesystem::path(testing::TempDir()) / "posecoach_pose_file_test.pose.json";
  EXPECT_TRUE(write_pose_track(path, track));
  return read_file(path).value();
}

std::string track_with(const std::string& old_part, const std::string& new_part) {
  std::string text = written(sample_track());
  const std::size_t at = text.find(old_part);
  EXPECT_NE(at, std::string::npos) << old_part;
  return text.replace(at, old_part.size(), new_part);
}

void expect_malformed(const std::string& text, const std::string& start, const std::string& what) {
  const auto content = read_pose_json("a.pose.json", text);
  ASSERT_FALSE(content) << what;
  EXPECT_EQ(content.error().code, ErrorCode::Malformed);
  EXPECT_THAT(content.error().message, StartsWith("a.pose.json:" + start));
  EXPECT_THAT(content.error().message, HasSubstr(what));
  EXPECT_EQ(content.error().message.find('\n'), std::string::npos);
}

TEST(PoseFile, what_was_seen_in_a_film_reads_back) {
  const PoseTrack track = sample_track();
  const PoseTrack again = std::get<PoseTrack>(read_pose_json("a", written(track)).value());
  EXPECT_EQ(again.source, track.source);
  EXPECT_EQ(again.width, 640);
  EXPECT_EQ(again.height, 360);
  ASSERT_EQ(again.frames.size(), track.frames.size());
  for (std::size_t f = 0; f < track.frames.size(); ++f) {
    EXPECT_EQ(again.frames[f].frame_index, track.frames[f].frame_index);
    EXPECT_EQ(again.frames[f].time, track.frames[f].time);
    ASSERT_EQ(again.frames[f].person.has_value(), track.frames[f].person.has_value());
    if (!again.frames[f].person) continue;
    for (std::size_t l = 0; l < kLandmarkCount; ++l) {
      const auto& [a, b] = std::pair(again.frames[f].person->image[l], track.frames[f].person->image[l]);
      EXPECT_LT(glm::distance(a.position_px, b.position_px), 1e-4);
      EXPECT_NEAR(a.visibility, b.visibility, 1e-5);
      EXPECT_LT(glm::distance(again.frames[f].person->world[l].position_m,
                              track.frames[f].person->world[l].position_m),
                1e-6);
    }
  }
}

TEST(PoseFile, the_order_of_fields_does_not_matter) {
  std::string text = written(sample_track());
  const std::size_t begin = text.find(" \"joints\""), end = text.find(" \"frames\"");
  std::string joints = text.substr(begin, end - begin);
  text.erase(begin, end - begin);
  joints = joints.substr(0, joints.find_last_of(']') + 1);
  text.insert(text.find_last_of('}'), "," + joints);
  EXPECT_TRUE(read_pose_json("a", text)) << read_pose_json("a", text).error().message;
}

TEST(PoseFile, a_motion_with_rotations_reads_back_the_same) {
  const Skeleton body = make_standard_body();
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  std::vector<MediaTime> times;
  std::vector<Vec3> roots;
  std::vector<Quat> rotations;
  for (int f = 0; f < 6; ++f) {
    times.push_back(MediaTime(Duration(33'333'333 * f + 5)));
    roots.emplace_back(normal(random), normal(random), normal(random));
    for (int j = 0; j < body.size(); ++j)
      rotations.push_back(
          glm::normalize(Quat(normal(random), normal(random), normal(random), normal(random))));
  }
  const Motion motion = Motion::from_rotations(body, times, roots, rotations).value();
  const Motion again =
      std::get<Motion>(read_pose_json("a", pose_json_from_motion(motion, "bundled:swing")).value());
  ASSERT_TRUE(again.has_rotations());
  for (int f = 0; f < 6; ++f) {
    EXPECT_EQ(again.time(f), motion.time(f));
    for (int j = 0; j < body.size(); ++j)
      EXPECT_LT(glm::distance(again.position(f, j), motion.position(f, j)), 1e-9);
  }
  for (int j = 0; j < body.size(); ++j) {
    EXPECT_EQ(again.skeleton().joint(j).name, body.joint(j).name);
    EXPECT_EQ(again.skeleton().joint(j).role, body.joint(j).role);
    EXPECT_EQ(again.skeleton().joint(j).parent, body.joint(j).parent);
  }
}

TEST(PoseFile, a_motion_of_positions_keeps_stretching_bones_and_confidence) {
  const Skeleton two = Skeleton::make({{"root", kNoJoint, {}, {}}, {"tip", 0, {0, 1, 0}, {}}}).value();
  const Motion motion =
      Motion::from_positions(two, {MediaTime(Duration(0)), MediaTime(Duration(5))},
                             {{1, 2, 3}, {1, 4, 3}, {0, 0, 0}, {0, 0, 3}}, {1, 0.5, 0.25, 0})
          .value();
  const Motion again = std::get<Motion>(read_pose_json("a", pose_json_from_motion(motion, "")).value());
  EXPECT_FALSE(again.has_rotations());
  EXPECT_LT(glm::distance(again.position(0, 1), {1, 4, 3}), 1e-12);
  EXPECT_LT(glm::distance(again.position(1, 1), {0, 0, 3}), 1e-12);
  EXPECT_EQ(again.confidence(0, 1), 0.5);
  EXPECT_EQ(again.confidence(1, 0), 0.25);
}

TEST(PoseFile, every_mistake_is_one_line_that_names_file_and_line) {
  expect_malformed("", "1:", "not valid JSON");
  expect_malformed("{}", "", "no \"schema\"");
  expect_malformed(track_with("pose/1", "pose/2"), "1:", "the schema is not");
  expect_malformed(track_with("640", "\"wide\""), "3:", "\"width\" needs a number of pixels");
  expect_malformed(track_with("\"frames\"", "\"pictures\""), "", "no \"frames\"");
  expect_malformed(track_with("\"nose\", ", ""), "", "needs the 33 landmarks' names, and has 32");
  expect_malformed(track_with("\"nose\"", "\"chin\""), "", "number 0 should be nose");
  expect_malformed(track_with("\"time_s\"", "\"time\""), "7:", "\"time_s\" needs a number");
  expect_malformed(track_with("\"index\": 11, \"time_s\": 0.05", "\"index\": 11, \"time_s\": 0.00"),
                   "8:", "does not increase");
  expect_malformed(track_with("\"found\": true", "\"found\": 1"), "7:", "\"found\" needs true or false");
  expect_malformed(track_with("\"image\": [[", "\"image\": [[1,2,3],["), "7:", "does not have 33 joints");
  expect_malformed(track_with("\"image\": [[", "\"image\": [[1,2],["), "7:", "\"image\"[0] needs 3 numbers");
  const std::string text = written(sample_track());
  expect_malformed(text.substr(0, text.size() / 2), "", "not valid JSON");
}

TEST(PoseFile, a_motion_s_frames_must_fit_its_skeleton) {
  const Skeleton two = Skeleton::make({{"root", kNoJoint, {}, {}}, {"tip", 0, {0, 1, 0}, {}}}).value();
  const Motion motion = Motion::from_positions(two, {MediaTime(Duration(0))}, {{}, {0, 1, 0}}).value();
  std::string text = pose_json_from_motion(motion, "");
  text.replace(text.find("[[0,0,0,1],"), 11, "[");
  expect_malformed(text, "", "the frame does not have the skeleton's 2 joints");
  text = pose_json_from_motion(motion, "");
  text.replace(text.find("\"parent\": \"root\""), 16, "\"parent\": \"tail\"");
  expect_malformed(text, "", "the parent of \"tip\" does not come before it");
}

}  // namespace
}  // namespace posecoach
