#include "ui/report/overlay_film.h"

#include <gtest/gtest.h>

#include "tests/support/compared_motions.h"
#include "tests/support/offscreen.h"
#include "ui/report/motion_stills.h"

namespace posecoach {
namespace {

constexpr int kWidth = 480, kHeight = 360;

PinholeCamera film_camera() {
  return make_camera_looking_at({0, 1.1, 4}, {0, 0.9, 0}, 0.7, kWidth, kHeight);
}

// A grey film of `count` frames.
NextFrame film_of(int count) {
  return [count, index = 0]() mutable -> Result<std::optional<Frame>> {
    if (index >= count) return std::optional<Frame>();
    auto image = std::make_shared<Image>(Image::black(kWidth, kHeight));
    std::fill(image->rgb.begin(), image->rgb.end(), std::uint8_t{128});
    Frame frame{static_cast<std::size_t>(index), media_time_from_seconds(index / 30.0), std::nullopt, image};
    ++index;
    return std::optional(frame);
  };
}

TEST(OverlayFilm, every_frame_goes_through_in_order_and_size) {
  const ComparedMotions motions = make_compared_motions(20);
  std::vector<std::size_t> seen;
  const auto sink = [&](const Image& image, const Frame& frame) -> Result<void> {
    EXPECT_EQ(image.width, kWidth);
    EXPECT_EQ(image.height, kHeight);
    seen.push_back(frame.index);
    return {};
  };
  const auto stills = draw_overlay_film({motions.analysis, motions.student, 0, motions.coach}, film_camera(),
                                        test_renderer(), film_of(26), sink);
  ASSERT_TRUE(stills);
  ASSERT_EQ(seen.size(), 26U);
  for (std::size_t i = 0; i < seen.size(); ++i) EXPECT_EQ(seen[i], i);
  const std::vector<StillMoment> moments = still_moments(motions.analysis);
  ASSERT_EQ(stills->size(), moments.size());
  for (std::size_t i = 0; i < moments.size(); ++i) {
    EXPECT_EQ((*stills)[i].student_frame, moments[i].student_frame);
    EXPECT_NE((*stills)[i].caption.find("cm away"), std::string::npos);
  }
}

// The skeleton's green where the student's pelvis is, and none where the motion has no frame.
TEST(OverlayFilm, student_is_drawn_where_the_camera_sees_him) {
  const ComparedMotions motions = make_compared_motions(20);
  constexpr int kFirstFrame = 5;
  Analysis analysis = motions.analysis;
  for (auto& [student, coach] : analysis.path) student += kFirstFrame;
  OverlayFilm film({analysis, motions.student, kFirstFrame, motions.coach}, film_camera(), test_renderer());
  const NextFrame next = film_of(10);
  const int knee = motions.student.skeleton().find(HumanoidJoint::LeftKnee);
  for (int i = 0; i < 10; ++i) {
    const Image image = film.draw(**next());
    const Vec2 at =
        film_camera().project(motions.student.position(std::max(0, i - kFirstFrame), knee)).value();
    const std::uint8_t* pixel = image.pixel(static_cast<int>(at.x), static_cast<int>(at.y) + 12);
    EXPECT_EQ(pixel[1] > pixel[0] + 30, i >= kFirstFrame) << i;
  }
}

TEST(OverlayFilm, unseen_student_is_not_drawn) {
  const ComparedMotions motions = make_compared_motions(8);
  std::vector<Vec3> positions;
  for (int i = 0; i < 8; ++i)
    positions.insert(positions.end(), motions.student.positions(i).begin(),
                     motions.student.positions(i).end());
  const Motion unseen =
      Motion::from_positions(motions.student.skeleton(),
                             {motions.student.times().begin(), motions.student.times().end()}, positions,
                             std::vector<double>(positions.size(), 0.0))
          .value();
  OverlayFilm film({motions.analysis, unseen, 0, motions.coach}, film_camera(), test_renderer());
  const Image image = film.draw(**film_of(1)());
  for (int y = 80; y < 260; ++y)  // between score and time line
    for (int x = 100; x < 380; ++x) ASSERT_EQ(image.pixel(x, y)[1], 128) << x << ' ' << y;
}

TEST(OverlayFilm, without_a_sink_the_film_is_read_no_further_than_the_stills_need) {
  const ComparedMotions motions = make_compared_motions(20);
  int read = 0;
  const NextFrame film = film_of(500);
  const NextFrame counted = [&] {
    ++read;
    return film();
  };
  const auto stills = draw_overlay_film({motions.analysis, motions.student, 0, motions.coach}, film_camera(),
                                        test_renderer(), counted, {});
  ASSERT_TRUE(stills);
  EXPECT_GE(stills->size(), 2U);
  EXPECT_LE(read, 20);
}

TEST(OverlayFilm, errors_of_film_and_sink_and_the_users_stop_come_back) {
  const ComparedMotions motions = make_compared_motions(8);
  const Comparison comparison{motions.analysis, motions.student, 0, motions.coach};
  const auto broken_film = []() -> Result<std::optional<Frame>> {
    return fail(ErrorCode::Malformed, "film is torn");
  };
  const auto good_sink = [](const Image&, const Frame&) -> Result<void> { return {}; };
  const auto full_sink = [](const Image&, const Frame&) -> Result<void> {
    return fail(ErrorCode::Unreadable, "disk full");
  };
  auto done = draw_overlay_film(comparison, film_camera(), test_renderer(), broken_film, good_sink);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().message, "film is torn");
  done = draw_overlay_film(comparison, film_camera(), test_renderer(), film_of(5), full_sink);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().message, "disk full");
  done = draw_overlay_film(comparison, film_camera(), test_renderer(), film_of(5), good_sink,
                           [](std::string_view, double) { return false; });
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::Cancelled);
}

TEST(StillMoments, advice_comes_with_its_joint_and_moments_are_apart) {
  ComparedMotions motions = make_compared_motions(200);
  for (int i = 0; i < 20; ++i) motions.analysis.worst_frames.push_back({150 + i, 150 + i, 0.1});
  const std::vector<StillMoment> moments = still_moments(motions.analysis);
  EXPECT_LE(moments.size(), 5U);
  bool has_elbow = false;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    if (moments[i].joint == HumanoidJoint::LeftElbow) has_elbow = true;
    if (i > 0) {
      EXPECT_GE(moments[i].student_frame - moments[i - 1].student_frame, 11);
    }
  }
  EXPECT_TRUE(has_elbow);
  EXPECT_TRUE(still_moments(Analysis{}).empty());
}

TEST(JointApart, what_one_camera_only_guesses_does_not_count) {
  const ComparedMotions motions = make_compared_motions(8);
  const Skeleton& body = motions.student.skeleton();
  std::vector<Vec3> coach(motions.student.positions(0).begin(), motions.student.positions(0).end());
  coach[static_cast<std::size_t>(body.find(HumanoidJoint::LeftWrist))] += Vec3(0, 0, 0.5);
  coach[static_cast<std::size_t>(body.find(HumanoidJoint::RightKnee))] += Vec3(0.1, 0, 0);
  const BodyState his{body, motions.student.positions(0)}, coachs{body, coach};
  const auto seen = joint_apart(his, coachs, std::nullopt, Vec3(0, 0, 1));
  ASSERT_TRUE(seen);
  EXPECT_EQ(seen->joint, HumanoidJoint::RightKnee);
  EXPECT_NEAR(seen->distance_m, 0.1, 1e-9);
  EXPECT_EQ(joint_apart(his, coachs, std::nullopt, Vec3(0))->joint, HumanoidJoint::LeftWrist);
}

TEST(Crop, lies_within_the_picture_and_around_the_points) {
  for (const auto& [width, height] : {std::pair(354, 492), std::pair(1280, 720), std::pair(50, 2000)}) {
    const std::vector<Vec2> points = {
        {0.3 * width, 0.2 * height}, {0.45 * width, 0.7 * height}, {-20, 0.5 * height}};
    const PixelCrop crop = crop_around(points, width, height);
    EXPECT_GE(crop.left, 0);
    EXPECT_GE(crop.top, 0);
    EXPECT_GT(crop.width, 0);
    EXPECT_LE(crop.left + crop.width, width);
    EXPECT_LE(crop.top + crop.height, height);
  }
  EXPECT_EQ(crop_around({}, 30, 20).width, 30);
}

TEST(MotionStills, one_picture_for_each_worst_moment_with_both_bodies_in_it) {
  const ComparedMotions motions = make_compared_motions();
  const auto stills =
      draw_motion_stills({motions.analysis, motions.student, 0, motions.coach}, test_renderer());
  ASSERT_GE(stills.size(), 2U);
  for (const ReportPicture& still : stills) {
    int green = 0, red = 0;
    for (int y = 0; y < still.image.height; ++y)
      for (int x = 0; x < still.image.width; ++x) {
        const std::uint8_t* p = still.image.pixel(x, y);
        if (p[1] > p[0] + 40) ++green;
        if (p[0] > p[1] + 40) ++red;
      }
    EXPECT_GT(green, 1000);
    EXPECT_GT(red, 300);
  }
}

}  // namespace
}  // namespace posecoach
