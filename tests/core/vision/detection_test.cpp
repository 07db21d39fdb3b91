#include "core/vision/detection.h"

#include <gtest/gtest.h>

#include <random>

namespace posecoach {
namespace {

Detection make_box(double score, double x, double y, double width, double height) {
  Detection detection;
  detection.score = score;
  detection.low = {x, y};
  detection.high = {x + width, y + height};
  for (std::size_t k = 0; k < detection.points.size(); ++k)
    detection.points[k] = {x + 0.1 * static_cast<double>(k), y};
  return detection;
}

TEST(Detection, there_are_2254_anchors_and_all_lie_in_the_square) {
  const auto anchors = make_anchors();
  EXPECT_EQ(anchors.size(), kAnchorCount);
  for (const Vec2& anchor : anchors) {
    EXPECT_GT(std::min(anchor.x, anchor.y), 0);
    EXPECT_LT(std::max(anchor.x, anchor.y), 1);
  }
}

TEST(Detection, anchors_run_row_by_row_through_28_14_and_7_cells) {
  const auto anchors = make_anchors();
  EXPECT_EQ(anchors[0], Vec2(0.5 / 28, 0.5 / 28));
  EXPECT_EQ(anchors[1], anchors[0]);
  EXPECT_EQ(anchors[2], Vec2(1.5 / 28, 0.5 / 28));
  EXPECT_EQ(anchors[2 * 28 * 28], Vec2(0.5 / 14, 0.5 / 14));
  EXPECT_EQ(anchors[2 * 28 * 28 + 2 * 14 * 14], Vec2(0.5 / 7, 0.5 / 7));
  EXPECT_EQ(anchors.back(), Vec2(6.5 / 7, 6.5 / 7));
}

TEST(Detection, numbers_are_pixels_relative_to_the_anchor) {
  const std::vector<Vec2> anchors = {{0.25, 0.75}};
  const std::vector<float> box = {22.4F, -22.4F, 44.8F, 89.6F, 0, 112, 1, 2, 3, 4, -56, 0};
  const auto found = decode_detections(box, std::vector<float>{2.0F}, anchors);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].score, 1 / (1 + std::exp(-2.0)), 1e-9);
  EXPECT_NEAR(found[0].low.x, 0.35 - 0.1, 1e-6);
  EXPECT_NEAR(found[0].high.y, 0.65 + 0.2, 1e-6);
  EXPECT_NEAR(found[0].points[0].y, 0.75 + 0.5, 1e-6);
  EXPECT_NEAR(found[0].points[3].x, 0.25 - 0.25, 1e-6);
}

TEST(Detection, only_scores_of_one_half_or_more_count) {
  const std::vector<Vec2> anchors(4, Vec2(0.5, 0.5));
  const std::vector<float> boxes(4 * kBoxNumbers, 1.0F);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(decode_detections(boxes, std::vector<float>{-0.01F, 0.0F, 1000.0F, nan}, anchors).size(), 2U);
}

TEST(Detection, overlap_is_one_with_itself_and_symmetric) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(0, 1);
  for (int i = 0; i < 100; ++i) {
    const Detection a =
        make_box(1, number(random), number(random), number(random) + 0.01, number(random) + 0.01);
    const Detection b =
        make_box(1, number(random), number(random), number(random) + 0.01, number(random) + 0.01);
    EXPECT_NEAR(overlap(a, a), 1, 1e-12);
    EXPECT_DOUBLE_EQ(overlap(a, b), overlap(b, a));
    EXPECT_GE(overlap(a, b), 0);
    EXPECT_LE(overlap(a, b), 1);
  }
}

TEST(Detection, overlapping_answers_become_their_mean_weighted_by_score) {
  const auto merged =
      merge_overlapping({make_box(0.6, 0.12, 0.1, 0.2, 0.2), make_box(0.9, 0.1, 0.1, 0.2, 0.2)});
  ASSERT_EQ(merged.size(), 1U);
  EXPECT_DOUBLE_EQ(merged[0].score, 0.9);
  EXPECT_NEAR(merged[0].low.x, (0.9 * 0.1 + 0.6 * 0.12) / 1.5, 1e-12);
  EXPECT_NEAR(merged[0].points[1].x, (0.9 * 0.2 + 0.6 * 0.22) / 1.5, 1e-12);
}

TEST(Detection, people_apart_stay_apart_best_first) {
  const auto merged =
      merge_overlapping({make_box(0.7, 0.6, 0.1, 0.2, 0.2), make_box(0.95, 0.1, 0.1, 0.2, 0.2),
                         make_box(0.8, 0.61, 0.1, 0.2, 0.2)});
  ASSERT_EQ(merged.size(), 2U);
  EXPECT_DOUBLE_EQ(merged[0].score, 0.95);
  EXPECT_DOUBLE_EQ(merged[1].score, 0.8);
}

TEST(Detection, an_empty_box_still_ends_the_merging) {
  EXPECT_EQ(merge_overlapping({make_box(0.9, 0.1, 0.1, 0, 0), make_box(0.8, 0.1, 0.1, 0, 0)}).size(), 2U);
  EXPECT_TRUE(merge_overlapping({}).empty());
}

}  // namespace
}  // namespace posecoach
