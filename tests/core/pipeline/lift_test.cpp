#include "core/pipeline/lift.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/body/body_measurement.h"
#include "core/pipeline/analyze.h"
#include "tests/core/pipeline/filmed.h"
#include "tests/core/retarget/motions.h"

namespace posecoach {
namespace {

double median_reprojection_px(const LiftedStudent& student, const PoseTrack& track) {
  std::vector<double> distances;
  for (int f = 0; f < student.motion.frame_count(); ++f) {
    const auto& person = track.frames[static_cast<std::size_t>(f + student.first_frame)].person;
    if (!person) continue;
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
      const auto seen = student.camera.project(
          student.motion.position(f, static_cast<int>(i) + kLandmarkBodyDerivedJoints));
      EXPECT_TRUE(seen);
      if (seen) distances.push_back(glm::distance(*seen, person->image[i].position_px));
    }
  }
  std::nth_element(distances.begin(), distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2),
                   distances.end());
  return distances[distances.size() / 2];
}

double pitch_degrees(const PinholeCamera& camera) {
  return degrees_from_radians(std::asin(-camera.rotation_camera_from_world[1][2]));
}

constexpr Noise kWebcam{2.0, 0.01, 0.03};
const Vec3 kFaceOn{0, 1.2, 3.6};
const Vec3 kDownTheLine{-3.6, 1.2, 0.3};

TEST(Lift, the_students_joints_fall_on_their_picture) {
  for (const Vec3& eye : {kFaceOn, kDownTheLine}) {
    const Filmed filmed = film(test_landmark_body(1), eye, 50, kWebcam);
    const auto student = lift(filmed.track);
    ASSERT_TRUE(student) << student.error().message;
    EXPECT_LT(median_reprojection_px(*student, filmed.track), 0.01);
    EXPECT_LT(student->model_residual_px, 8);
  }
}

TEST(Lift, the_view_is_told_from_the_address) {
  const Skeleton body = test_landmark_body(1);
  EXPECT_EQ(lift(film(body, kFaceOn, 50, kWebcam).track)->view, View::FaceOn);
  EXPECT_EQ(lift(film(body, kDownTheLine, 50, kWebcam).track)->view, View::DownTheLine);
  EXPECT_EQ(lift(film(body, {-2.6, 1.2, 2.6}, 50, kWebcam).track)->view, View::Between);
}

TEST(Lift, a_camera_beside_its_place_is_not_square) {
  const Skeleton body = test_landmark_body(1);
  const auto at = [&](double degrees) {
    const double angle = radians_from_degrees(degrees);
    return *lift(film(body, {-3.6 * std::sin(angle), 1.2, 3.6 * std::cos(angle)}, 50, kWebcam).track);
  };
  for (const double square : {0.0, 90.0})
    for (const double off : {-20.0, 0.0, 20.0}) {
      const LiftedStudent student = at(square + off);
      EXPECT_EQ(student.side().is_square(), off == 0) << square << " and " << off;
      // He faces +Z with the target on his left: a camera on the way to his right is negative before him, and
      // positive towards his front on the target line.
      EXPECT_NEAR(student.aside_deg, -off, 8) << square << " and " << off;
      EXPECT_EQ(student.view, square == 0 ? View::FaceOn : View::DownTheLine);
      const Viewpoint judged =
          student_from_film("film", film(body, kFaceOn, 50, kWebcam).track, student).view;
      EXPECT_EQ(judged == Viewpoint::Between, off != 0);
    }
}

TEST(CameraSide, tells_three_states_and_the_way_back) {
  const auto from = [](double degrees) {
    const double angle = radians_from_degrees(degrees);
    return camera_side({0, 0, 2}, {3 * std::sin(angle), 1, 3 * std::cos(angle)});
  };
  for (const double side : {0.0, 90.0, -90.0})
    for (const double off : {0.0, 8.0, -8.0, 25.0, -25.0}) {
      const CameraSide seen = from(side + off);
      EXPECT_EQ(seen.view, side == 0 ? View::FaceOn : View::DownTheLine) << side << " " << off;
      EXPECT_EQ(seen.is_square(), std::abs(off) < kSquare_deg) << side << " " << off;
      EXPECT_NEAR(seen.aside_deg, side > 0 ? -off : off, 1e-9) << side << " " << off;
      EXPECT_EQ(judged_from(seen) == Viewpoint::Between, !seen.is_square());
    }
  for (const double nowhere : {45.0, -45.0, 180.0}) {
    EXPECT_EQ(from(nowhere).view, View::Between);
    EXPECT_FALSE(from(nowhere).is_square());
  }
}

TEST(Lift, gravity_floor_and_place_are_found_for_level_and_tilted_cameras) {
  for (const double eye_height : {0.7, 1.2, 2.0}) {
    for (const Vec3& eye : {Vec3(0, eye_height, 3.6), Vec3(-3.6, eye_height, 0.3)}) {
      const Filmed filmed = film(test_landmark_body(1), eye, 50, kWebcam);
      const auto student = lift(filmed.track);
      ASSERT_TRUE(student);
      EXPECT_NEAR(pitch_degrees(student->camera), pitch_degrees(filmed.camera), 5) << eye_height;
      const int heel = landmark_joint(Landmark::LeftHeel);
      EXPECT_NEAR(student->motion.position(0, heel).y, filmed.truth.position(0, heel).y, 0.05);
      const Vec3 hips = student->motion.position(0, 0);
      EXPECT_LT(std::hypot(hips.x, hips.z), 0.35);
      EXPECT_NEAR(hips.y, filmed.truth.position(0, 0).y, 0.12);
    }
  }
}

TEST(Lift, bones_keep_about_their_lengths_in_the_world) {
  const Filmed filmed = film(test_landmark_body(1), kFaceOn, 50, kWebcam);
  const auto student = lift(filmed.track);
  ASSERT_TRUE(student);
  for (const Landmark l :
       {Landmark::LeftKnee, Landmark::RightAnkle, Landmark::LeftElbow, Landmark::RightWrist}) {
    const int j = landmark_joint(l);
    EXPECT_NEAR(student->body.bone_length(j) / filmed.truth.skeleton().bone_length(j), 1, 0.06)
        << to_string(l);
  }
}

TEST(Lift, a_given_height_makes_the_world_larger_not_the_picture) {
  const Filmed filmed = film(test_landmark_body(1), kFaceOn, 50, {});
  const auto small = lift(filmed.track, {1.5, {}}), tall = lift(filmed.track, {1.95, {}});
  ASSERT_TRUE(small && tall);
  EXPECT_NEAR(stature(tall->body), 1.95, 1e-9);
  EXPECT_NEAR(tall->camera.position().z / small->camera.position().z, 1.95 / 1.5, 0.01);
  EXPECT_LT(median_reprojection_px(*tall, filmed.track), 0.01);
}

TEST(Lift, frames_without_a_person_are_cut_at_the_ends_and_bridged_without_confidence_inside) {
  Filmed filmed = film(test_landmark_body(1), kFaceOn, 50, {});
  auto& frames = filmed.track.frames;
  for (const std::size_t f :
       {std::size_t{0}, std::size_t{1}, std::size_t{10}, std::size_t{11}, frames.size() - 1})
    frames[f].person.reset();
  const auto student = lift(filmed.track);
  ASSERT_TRUE(student);
  EXPECT_EQ(student->first_frame, 2);
  EXPECT_EQ(student->motion.frame_count(), static_cast<int>(frames.size()) - 3);
  EXPECT_EQ(student->motion.time(0), frames[2].time);
  EXPECT_EQ(student->motion.confidence(8, 0), 0);
  EXPECT_GT(student->motion.confidence(7, 0), 0.9);
  const Vec3 between = student->motion.position(8, 20);
  const Vec3 expected = glm::mix(student->motion.position(7, 20), student->motion.position(10, 20), 1.0 / 3);
  EXPECT_LT(glm::distance(between, expected), 1e-6);
}

TEST(Lift, nobody_is_no_person_and_two_frames_are_too_few) {
  Filmed filmed = film(test_landmark_body(1), kFaceOn, 50, {});
  PoseTrack few = filmed.track;
  few.frames.resize(2);
  EXPECT_EQ(lift(few).error().code, ErrorCode::Incomplete);
  PoseTrack three = filmed.track;
  three.frames.resize(3);
  EXPECT_TRUE(lift(three));
  for (PoseObservation& frame : filmed.track.frames) frame.person.reset();
  EXPECT_EQ(lift(filmed.track).error().code, ErrorCode::NoPerson);
  filmed.track.frames.clear();
  EXPECT_EQ(lift(filmed.track).error().code, ErrorCode::NoPerson);
}

TEST(Lift, the_focal_length_of_a_close_camera_is_found_roughly) {
  // Close enough for perspective to show; far cameras keep the usual focal length.
  const Filmed wide = film(test_landmark_body(1), {0, 1.2, 2.0}, 75, {1.0, 0.005, 0.005}, 720, 1280);
  const auto student = lift(wide.track);
  ASSERT_TRUE(student);
  EXPECT_NEAR(std::log(student->camera.focal_px / wide.camera.focal_px), 0, 0.25);
}

}  // namespace
}  // namespace posecoach
