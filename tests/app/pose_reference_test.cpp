#include "app/evaluate/pose_reference.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/file.h"

namespace posecoach {
namespace {

namespace fs = std::filesystem;

SeenPerson make_person(double offset_px, double offset_m) {
  SeenPerson person;
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    person.image[i] = {{static_cast<double>(i) + offset_px, 7}, 1};
    person.world[i] = {{0, offset_m, static_cast<double>(i)}, 1};
  }
  return person;
}

TEST(PoseReference, agreement_is_the_median_of_the_frames_mean_distances) {
  PoseTrack track;
  PoseReference reference;
  for (std::size_t i = 0; i < 5; ++i) {
    track.frames.push_back({i, MediaTime(Duration(i)), make_person(static_cast<double>(i), 0.002)});
    reference.frames.push_back({i, make_person(0, 0)});
  }
  const PoseAgreement agreement = compare_poses(track, reference);
  EXPECT_EQ(agreement.frames, 5U);
  EXPECT_EQ(agreement.mismatched, 0U);
  EXPECT_NEAR(agreement.image_median_px, 2, 1e-12);
  EXPECT_NEAR(agreement.image_percentile95_px, 4, 1e-12);
  EXPECT_NEAR(agreement.image_max_px, 4, 1e-12);
  EXPECT_NEAR(agreement.world_median_mm, 2, 1e-9);
}

TEST(PoseReference, a_person_that_only_one_side_sees_is_a_mismatch) {
  PoseTrack track;
  track.frames.push_back({0, MediaTime(), std::nullopt});
  track.frames.push_back({1, MediaTime(Duration(1)), make_person(0, 0)});
  PoseReference reference;
  // Frame 2 is missing from the track.
  for (std::size_t i = 0; i < 3; ++i) reference.frames.push_back({i, make_person(0, 0)});
  reference.frames[1].person.reset();
  const PoseAgreement agreement = compare_poses(track, reference);
  EXPECT_EQ(agreement.frames, 0U);
  EXPECT_EQ(agreement.mismatched, 3U);
}

TEST(PoseReference, a_file_that_is_none_is_named) {
  const fs::path path = fs::path(testing::TempDir()) / "posecoach_reference.json";
  ASSERT_TRUE(write_file_atomically(path, R"({"model": "full"})"));
  const auto read = read_pose_reference(path);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::Malformed);
  EXPECT_THAT(read.error().message, testing::HasSubstr("posecoach_reference.json"));
}

}  // namespace
}  // namespace posecoach
