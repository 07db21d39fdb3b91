// The pose stage with its real networks: against another program's answers, and against the simulated
// student, of whom everything is known. Skipped where the networks or the data are not installed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "app/evaluate/pose_reference.h"
#include "capture/simulated_student.h"
#include "capture/video_file.h"
#include "core/pipeline/track_poses.h"
#include "core/vision/detector.h"
#include "tests/support/shared_data.h"

namespace posecoach {
namespace {

bool has_models() {
  return find_model_file(kDetectorFileName, std::nullopt).has_value();
}

#define SKIP_WITHOUT_MODELS() \
  if (!has_models()) GTEST_SKIP() << "the pose models are not installed; run scripts/setup"

// The first pictures of a film.
class Beginning : public FrameSource {
 public:
  Beginning(std::unique_ptr<FrameSource> film, std::size_t count) : film_(std::move(film)), left_(count) {}
  const FrameSourceInfo& info() const override { return film_->info(); }
  Result<std::optional<Frame>> next(std::stop_token stop) override {
    if (left_ == 0) return std::nullopt;
    --left_;
    return film_->next(stop);
  }

 private:
  std::unique_ptr<FrameSource> film_;
  std::size_t left_;
};

class Agreement : public testing::TestWithParam<const char*> {};

TEST_P(Agreement, with_the_reference_within_a_tenth_of_a_pixel) {
  SKIP_WITHOUT_MODELS();
  const auto data = shared_data("data");
  if (!data) GTEST_SKIP() << "the reference data are not here";
  auto reference = read_pose_reference(*data / "reference" / (std::string(GetParam()) + ".json")).value();
  const std::size_t frames = reference.options.model == PoseModel::Heavy ? 24 : 45;
  std::erase_if(reference.frames,
                [&](const PoseReferenceFrame& frame) { return frame.frame_index >= frames; });
  ASSERT_GE(reference.frames.size(), 8U);
  Beginning film(open_video_file(*data / "video" / "swing_down_the_line.mp4").value(), frames);
  auto tracker = PoseTracker::make(reference.options).value();
  const PoseAgreement agreement = compare_poses(track_poses(film, *tracker).value(), reference);
  EXPECT_EQ(agreement.frames, reference.frames.size());
  EXPECT_EQ(agreement.mismatched, 0U);
  EXPECT_LE(agreement.image_median_px, 0.1);
  EXPECT_LE(agreement.image_percentile95_px, 1.0);
  EXPECT_LE(agreement.world_median_mm, 1.0);
}

INSTANTIATE_TEST_SUITE_P(All, Agreement,
                         testing::Values("detector_every_frame_lite", "detector_every_frame_full",
                                         "detector_every_frame_heavy", "tracking_no_smoothing_full",
                                         "tracking_smoothing_lite", "tracking_smoothing_full",
                                         "tracking_smoothing_heavy"),
                         [](const testing::TestParamInfo<const char*>& reference) {
                           return std::string(reference.param);
                         });

constexpr int kWidth = 640;
constexpr int kHeight = 480;

std::unique_ptr<SimulatedStudent> make_student() {
  SimulatedStudentOptions options;
  options.frames_per_second = 30;
  options.width = kWidth;
  options.height = kHeight;
  return SimulatedStudent::make(options).value();
}

std::unique_ptr<PoseTracker> make_tracker(Smoothing smoothing = Smoothing::On) {
  PoseTrackerOptions options;
  options.model = PoseModel::Lite;
  options.smoothing = smoothing;
  return PoseTracker::make(options).value();
}

Frame make_frame(std::size_t index, Image image) {
  Frame frame;
  frame.index = index;
  frame.time = media_time_from_seconds(static_cast<double>(index) / 30);
  frame.image = std::make_shared<const Image>(std::move(image));
  return frame;
}

Image make_meadow() {
  Image image = Image::black(kWidth, kHeight);
  for (std::size_t i = 0; i < image.rgb.size(); ++i) image.rgb[i] = i % 3 == 1 ? 120 : 60;
  return image;
}

constexpr int kNarrow = 300;

// The middle columns of two pictures: close together, so that the detector sees both people well.
Image side_by_side(const Image& left, const Image& right) {
  Image image = Image::black(2 * kNarrow, left.height);
  for (int y = 0; y < image.height; ++y) {
    std::copy_n(left.pixel((left.width - kNarrow) / 2, y), 3 * kNarrow, image.pixel(0, y));
    std::copy_n(right.pixel((right.width - kNarrow) / 2, y), 3 * kNarrow, image.pixel(kNarrow, y));
  }
  return image;
}

double mean_x(const SeenPerson& person) {
  double sum = 0;
  for (const ImageKeypoint& point : person.image) sum += point.position_px.x;
  return sum / kLandmarkCount;
}

TEST(PoseTracking, the_simulated_students_joints_are_found_where_they_are) {
  SKIP_WITHOUT_MODELS();
  const auto student = make_student();
  const auto tracker = make_tracker(Smoothing::Off);
  std::vector<double> distances_px;
  for (int i = 0; i < 20; ++i) {
    const auto seen = tracker->estimate(make_frame(static_cast<std::size_t>(i), student->draw(i))).value();
    ASSERT_TRUE(seen.person) << i;
    const auto truth = student->landmarks(i);
    for (const Landmark landmark :
         {Landmark::LeftShoulder, Landmark::RightShoulder, Landmark::LeftHip, Landmark::RightHip,
          Landmark::LeftKnee, Landmark::RightKnee, Landmark::LeftAnkle, Landmark::RightAnkle}) {
      const auto shown = student->camera().project(truth[landmark]);
      distances_px.push_back(glm::distance(*shown, seen.person->image[landmark].position_px));
    }
  }
  std::nth_element(distances_px.begin(), distances_px.begin() + 80, distances_px.end());
  EXPECT_LT(distances_px[80], 8);
}

TEST(PoseTracking, what_was_smoothed_is_there_unsmoothed_as_well) {
  SKIP_WITHOUT_MODELS();
  const auto student = make_student();
  const auto smooth = make_tracker(Smoothing::On), raw = make_tracker(Smoothing::Off);
  double apart_px = 0;
  for (int i = 40; i < 46; ++i) {
    const Frame frame = make_frame(static_cast<std::size_t>(i), student->draw(i));
    const auto smoothed = smooth->estimate(frame)->person, seen = raw->estimate(frame)->person;
    const auto unsmoothed = smooth->unsmoothed();
    ASSERT_TRUE(smoothed && seen && unsmoothed);
    EXPECT_FALSE(raw->unsmoothed());
    for (std::size_t k = 0; k < kLandmarkCount; ++k) {
      EXPECT_EQ(unsmoothed->image[k].position_px, seen->image[k].position_px);
      apart_px =
          std::max(apart_px, glm::distance(smoothed->image[k].position_px, seen->image[k].position_px));
    }
  }
  EXPECT_GT(apart_px, 0.5) << "nothing was smoothed";
  ASSERT_FALSE(smooth->estimate(make_frame(60, make_meadow()))->person);
  EXPECT_FALSE(smooth->unsmoothed());
}

TEST(PoseTracking, an_empty_meadow_holds_nobody) {
  SKIP_WITHOUT_MODELS();
  const auto tracker = make_tracker();
  for (std::size_t i = 0; i < 3; ++i) EXPECT_FALSE(tracker->estimate(make_frame(i, make_meadow()))->person);
}

TEST(PoseTracking, who_leaves_is_lost_and_who_comes_back_is_found_without_memory) {
  SKIP_WITHOUT_MODELS();
  const auto student = make_student();
  const auto tracker = make_tracker();
  std::size_t index = 0;
  const auto see = [&](Image image) {
    return tracker->estimate(make_frame(index++, std::move(image)))->person;
  };
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(see(make_meadow()));  // the film begins without anybody
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(see(student->draw(i)));
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(see(make_meadow()));
  const auto again = see(student->draw(8));
  ASSERT_TRUE(again);
  // The filters were emptied: the first answer is that of a tracker that saw nothing before.
  const auto fresh = make_tracker()->estimate(make_frame(0, student->draw(8)))->person;
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    EXPECT_EQ(again->image[i].position_px, fresh->image[i].position_px);
    EXPECT_EQ(again->world[i].position_m, fresh->world[i].position_m);
    EXPECT_EQ(again->image[i].visibility, fresh->image[i].visibility);
  }
}

TEST(PoseTracking, of_two_people_the_followed_one_is_kept) {
  SKIP_WITHOUT_MODELS();
  const auto student = make_student();
  for (const bool follows_left : {true, false}) {
    const auto tracker = make_tracker();
    for (std::size_t i = 0; i < 12; ++i) {
      const Image person = student->draw(static_cast<int>(i));
      // The other one joins in the fifth picture.
      const Image other = i < 4 ? make_meadow() : student->draw(static_cast<int>(2 * i));
      const auto seen = tracker->estimate(
          make_frame(i, follows_left ? side_by_side(person, other) : side_by_side(other, person)));
      ASSERT_TRUE(seen->person) << i;
      EXPECT_EQ(mean_x(*seen->person) < kNarrow, follows_left) << i;
    }
  }
}

TEST(PoseTracking, after_a_moment_out_of_sight_the_same_one_of_two_people_is_taken_again) {
  SKIP_WITHOUT_MODELS();
  const auto student = make_student();
  auto detector = Detector::load(find_model_file(kDetectorFileName, std::nullopt).value()).value();
  ASSERT_EQ(detector.detect(side_by_side(student->draw(9), student->draw(9)))->size(), 2U);
  for (const bool follows_left : {true, false}) {
    const auto tracker = make_tracker();
    for (std::size_t i = 0; i < 14; ++i) {
      const Image person = student->draw(static_cast<int>(i));
      const Image alone = i < 4 ? make_meadow() : person;
      Image image = follows_left ? side_by_side(person, alone) : side_by_side(alone, person);
      if (i == 8) image = side_by_side(make_meadow(), make_meadow());
      const auto seen = tracker->estimate(make_frame(i, std::move(image)));
      EXPECT_EQ(seen->person.has_value(), i != 8) << i;
      EXPECT_TRUE(!seen->person || (mean_x(*seen->person) < kNarrow) == follows_left) << i;
    }
  }
}

TEST(PoseTracking, pictures_smaller_than_a_person_are_no_trouble) {
  SKIP_WITHOUT_MODELS();
  const auto tracker = make_tracker();
  std::size_t index = 0;
  for (const auto& [width, height] : {std::pair{1, 1}, {2, 500}, {500, 2}, {16, 16}})
    EXPECT_TRUE(tracker->estimate(make_frame(index++, Image::black(width, height))));
}

}  // namespace
}  // namespace posecoach
