#include "capture/simulated_student.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "capture/bar_code.h"
#include "capture/open_source.h"
#include "capture/simulated_source.h"

namespace posecoach {
namespace {

std::unique_ptr<SimulatedStudent> make(const std::string& source) {
  const auto options = simulated_student_from_source(source);
  EXPECT_TRUE(options) << source;
  return SimulatedStudent::make(*options).value();
}

// FNV-1a.
std::uint64_t fingerprint(const Image& image) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const std::uint8_t byte : image.rgb) hash = (hash ^ byte) * 0x100000001b3U;
  return hash;
}

TEST(SimulatedStudent, gives_the_same_pixels_every_time) {
  const auto first = make("simulated:swing?size=320x240&fps=10"),
             second = make("simulated:swing?size=320x240&fps=10");
  for (;;) {
    const auto a = first->next({}).value(), b = second->next({}).value();
    ASSERT_EQ(a.has_value(), b.has_value());
    if (!a) break;
    ASSERT_EQ(a->image->rgb, b->image->rgb);
    ASSERT_EQ(a->image->rgb, first->draw(static_cast<int>(a->index)).rgb);
  }
}

TEST(SimulatedStudent, stamps_every_frame_and_tells_its_time) {
  const auto student = make("simulated:putt?size=480x270&fps=25");
  std::uint32_t index = 0;
  for (auto frame = student->next({}).value(); frame; frame = student->next({}).value(), ++index) {
    ASSERT_EQ(frame->index, index);
    ASSERT_EQ(read_bar_code(*frame->image), index);
    ASSERT_NEAR(to_seconds(frame->time), index / 25.0, 1e-9);
  }
  EXPECT_EQ(index, student->info().frame_count);
}

// The figure's colours stand where the truth says its parts are.
TEST(SimulatedStudent, shows_skin_at_the_hands_shirt_at_the_chest_and_shoes_at_the_feet) {
  for (const char* source :
       {"simulated:swing", "simulated:swing?hand=left&body=tall", "simulated:putt?body=short"}) {
    const auto student = make(std::string(source) +
                              (std::string(source).find('?') == std::string::npos ? "?" : "&") + "fps=10");
    const Image image = student->draw(0);
    const auto points = student->landmarks(0);
    const auto colour = [&](const Vec3& world) {
      const Vec2 px = student->camera().project(world).value();
      const std::uint8_t* pixel = image.pixel(static_cast<int>(px.x), static_cast<int>(px.y));
      return std::array<int, 3>{pixel[0], pixel[1], pixel[2]};
    };
    const auto hand = colour(0.5 * (points[Landmark::LeftIndex] + points[Landmark::RightIndex]));
    EXPECT_GT(hand[0], hand[2] + 25) << source;  // skin: red over blue
    const auto chest = colour(0.25 * (points[Landmark::LeftShoulder] + points[Landmark::RightShoulder] +
                                      points[Landmark::LeftHip] + points[Landmark::RightHip]));
    EXPECT_GT(chest[2], chest[0] + 50) << source;
    const auto knee = colour(points[Landmark::LeftKnee]);
    EXPECT_LT(knee[0] + knee[1] + knee[2], 200) << source;
    const auto toe = colour(points[Landmark::LeftFootIndex] - Vec3(0, 0, 0.06));
    EXPECT_GT(toe[0] + toe[1] + toe[2], 450) << source;
  }
}

TEST(SimulatedStudent, whole_body_is_in_the_picture_in_both_views_and_formats) {
  for (const char* size : {"1280x720", "720x1280", "640x640"})
    for (const char* view : {"face-on", "down-the-line"})
      for (const char* body : {"average", "tall", "child"}) {
        const auto student =
            make(std::string("simulated:swing?fps=10&size=") + size + "&view=" + view + "&body=" + body);
        for (int frame = 0; frame < static_cast<int>(*student->info().frame_count); ++frame)
          for (const Vec3& point : student->landmarks(frame)) {
            const Vec2 px = student->camera().project(point).value();
            ASSERT_TRUE(px.x > 0 && px.y > 0 && px.x < student->info().width && px.y < student->info().height)
                << size << " " << view << " " << body;
          }
      }
}

TEST(SimulatedStudent, left_hander_is_filmed_from_behind_his_own_line) {
  const auto left = make("simulated:swing?hand=left&view=down-the-line&fps=10");
  EXPECT_GT(left->camera().position().x, 3);
  EXPECT_LT(make("simulated:swing?view=down-the-line&fps=10")->camera().position().x, -3);
}

TEST(SimulatedSource, reads_all_settings) {
  const auto options = simulated_student_from_source(
      "simulated:swing?fault=early_extension&amount=5&body=tall&view=down-the-line&hand=left&fps=50&size="
      "640x480&fault=sway=3");
  ASSERT_TRUE(options);
  EXPECT_EQ(options->motion, "swing");
  ASSERT_EQ(options->faults.size(), 2U);
  EXPECT_EQ(options->faults[0].fault->name, "early_extension");
  EXPECT_EQ(options->faults[0].amount, 5);
  EXPECT_EQ(options->faults[1].amount, 3);
  EXPECT_EQ(options->hand, Handedness::Left);
  EXPECT_EQ(options->view.view, CameraView::DownTheLine);
  EXPECT_EQ(options->frames_per_second, 50);
  EXPECT_EQ(options->width, 640);
  EXPECT_EQ(options->height, 480);
  EXPECT_NEAR(options->body.leg_length(), 0.491 * 1.96, 0.01);
}

TEST(SimulatedSource, stands_at_the_ball_before_the_stroke) {
  for (const char* source : {"simulated:swing?fps=20", "simulated:putt?fps=20"}) {
    const auto student = make(source);
    EXPECT_GT(student->authored().time_of("takeaway"), 2) << source;
    const LandmarkArray<Vec3> first = student->landmarks(0), later = student->landmarks(36);
    for (std::size_t i = 0; i < kLandmarkCount; ++i) EXPECT_LT(glm::distance(first[i], later[i]), 1e-9);
  }
}

TEST(SimulatedSource, says_which_setting_is_wrong) {
  for (const char* source :
       {"simulated:", "simulated:chip", "simulated:swing?fault=shank", "simulated:swing?body=nobody",
        "simulated:swing?amount=3", "simulated:swing?view=above", "simulated:swing?hand=both",
        "simulated:swing?fps=0", "simulated:swing?fps=x", "simulated:swing?size=12",
        "simulated:swing?colour=red", "simulated:swing?fault"}) {
    const auto options = simulated_student_from_source(source);
    ASSERT_FALSE(options) << source;
    EXPECT_EQ(options.error().code, ErrorCode::InvalidArgument) << source;
    EXPECT_FALSE(options.error().message.empty());
  }
}

TEST(OpenSource, opens_the_simulated_student_and_says_which_camera_is_not_there) {
  const auto student = open_source("simulated:putt?fps=5&size=320x240");
  ASSERT_TRUE(student);
  EXPECT_EQ((*student)->info().width, 320);
  EXPECT_TRUE((*student)->next({}).value().has_value());
  const auto camera = open_source("camera:/dev/no_such_camera");
  ASSERT_FALSE(camera);
  EXPECT_EQ(camera.error().code, ErrorCode::NotFound);
  EXPECT_NE(camera.error().message.find("/dev/no_such_camera"), std::string::npos);
  const auto wrong = open_source("simulated:putt?fault=sway");
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().code, ErrorCode::InvalidArgument);
}

// One number for a whole picture: whoever gets another one has other pixels than everybody else.
TEST(SimulatedStudent, pixels_are_those_of_every_machine) {
  ConeScene scene;
  for (int i = 0; i < 12; ++i)
    scene.cones.push_back({{0.1 * i - 0.6, 0.2, 0.05 * i},
                           {0.5 - 0.1 * i, 1.6, 0},
                           0.02 + 0.01 * i,
                           0.09,
                           {0.1F * static_cast<float>(i % 7), 0.5F, 0.7F}});
  scene.shadows.push_back({{-0.3, 0, 0}, {0.4, 0, 0.2}, 0.4, 0.5});
  const PinholeCamera camera =
      make_camera_looking_at({0, 0.9, 4.0}, {0, 1.02, 0.1}, 2 * std::atan(0.5 * 2.75 / 3.9), 320, 180);
  EXPECT_EQ(fingerprint(draw_scene(scene, camera, draw_ground_and_sky(camera))), 16398693573307188657U);
}

TEST(CameraPlace, is_written_and_read_with_its_angle) {
  for (const CameraPlace& place :
       {CameraPlace{CameraView::FaceOn, 0}, CameraPlace{CameraView::DownTheLine, 20},
        CameraPlace{CameraView::FaceOn, -12.5}}) {
    const Result<CameraPlace> read = camera_place_from_string(to_string(place));
    ASSERT_TRUE(read) << to_string(place);
    EXPECT_EQ(read->view, place.view);
    EXPECT_EQ(read->turned_deg, place.turned_deg);
  }
  for (const char* wrong :
       {"", "sideways", "face-on20", "face-on+", "face-on+x", "face-on+120", "face-on+nan"})
    EXPECT_EQ(camera_place_from_string(wrong).error().code, ErrorCode::InvalidArgument) << wrong;
}

TEST(CameraPlace, goes_round_the_golfer_towards_the_target_or_the_ball) {
  const auto eye = [](CameraPlace place, Handedness hand) {
    const PinholeCamera camera = make_view_camera(place, hand, 640, 360);
    return camera.position();
  };
  const Vec3 straight = eye({CameraView::FaceOn, 0}, Handedness::Right),
             beside = eye({CameraView::FaceOn, 20}, Handedness::Right);
  EXPECT_GT(beside.x, straight.x + 1);  // a right-hander's target is at +X
  EXPECT_NEAR(glm::distance(beside, Vec3(0, straight.y, 0.1)),
              glm::distance(straight, Vec3(0, straight.y, 0.1)), 1e-9);
  EXPECT_GT(eye({CameraView::DownTheLine, 20}, Handedness::Right).z,
            eye({CameraView::DownTheLine, 0}, Handedness::Right).z + 1);
  for (const CameraView view : {CameraView::FaceOn, CameraView::DownTheLine}) {
    const Vec3 right = eye({view, 20}, Handedness::Right), left = eye({view, 20}, Handedness::Left);
    EXPECT_LT(glm::distance(right, Vec3(-left.x, left.y, left.z)), 1e-9);
  }
}

}  // namespace
}  // namespace posecoach
