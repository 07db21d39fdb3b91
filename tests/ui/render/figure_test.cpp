#include "ui/render/figure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/body/standard_body.h"

namespace posecoach {
namespace {

const Skeleton kBody = make_standard_body();

std::vector<Vec3> rest() {
  return {kBody.rest_positions().begin(), kBody.rest_positions().end()};
}

int count_bones(const Figure& figure, const Vec3& from, const Vec3& to) {
  int count = 0;
  for (const Capsule& capsule : figure.capsules)
    if (glm::length(capsule.from - from) < 1e-12 && glm::length(capsule.to - to) < 1e-12) ++count;
  return count;
}

TEST(Figure, every_bone_below_the_head_is_drawn_once) {
  const std::vector<Vec3> positions = rest();
  const Figure figure = make_figure({kBody, positions}, student_style(Palette::RedGreen));
  for (int joint = 1; joint < kBody.size(); ++joint) {
    if (kBody.joint(joint).role == HumanoidJoint::HeadTop) continue;  // the head's egg stands for it
    const Vec3& from = positions[static_cast<std::size_t>(kBody.joint(joint).parent)];
    EXPECT_EQ(count_bones(figure, from, positions[static_cast<std::size_t>(joint)]), 1)
        << kBody.joint(joint).name;
  }
}

TEST(Figure, head_reaches_to_the_top_of_the_head) {
  const Figure figure = make_figure({kBody, rest()}, student_style(Palette::RedGreen));
  double top = 0;
  for (const Capsule& capsule : figure.capsules)
    top = std::max({top, capsule.from.y + capsule.from_radius_m, capsule.to.y + capsule.to_radius_m});
  EXPECT_NEAR(top, kBody.rest_positions()[static_cast<std::size_t>(kBody.find(HumanoidJoint::HeadTop))].y,
              1e-9);
}

TEST(Figure, joint_without_confidence_is_left_out_with_its_bones) {
  const std::vector<Vec3> positions = rest();
  std::vector<double> confidence(positions.size(), 1.0);
  const int elbow = kBody.find(HumanoidJoint::LeftElbow);
  confidence[static_cast<std::size_t>(elbow)] = 0.1;
  const Figure figure = make_figure({kBody, positions, confidence}, student_style(Palette::RedGreen));
  for (const Capsule& capsule : figure.capsules)
    for (const Vec3& end : {capsule.from, capsule.to})
      EXPECT_GT(glm::length(end - positions[static_cast<std::size_t>(elbow)]), 1e-9);
  EXPECT_GT(figure.capsules.size(), 20U);
}

TEST(Figure, joints_that_are_no_numbers_leave_only_finite_capsules) {
  for (int broken = 0; broken < kBody.size(); ++broken) {
    std::vector<Vec3> positions = rest();
    positions[static_cast<std::size_t>(broken)].y = std::numeric_limits<double>::quiet_NaN();
    const Figure figure = make_figure({kBody, positions}, coach_style(Palette::RedGreen));
    EXPECT_FALSE(figure.capsules.empty());
    for (const Capsule& capsule : figure.capsules) {
      EXPECT_TRUE(is_finite(capsule.from) && is_finite(capsule.to)) << kBody.joint(broken).name;
      EXPECT_GT(capsule.from_radius_m, 0);
      EXPECT_GT(capsule.to_radius_m, 0);
    }
  }
}

TEST(Figure, all_joints_in_one_point_are_no_harm) {
  const std::vector<Vec3> positions(static_cast<std::size_t>(kBody.size()), Vec3(1, 2, 3));
  const Figure figure = make_figure({kBody, positions}, student_style(Palette::RedGreen));
  for (const Capsule& capsule : figure.capsules)
    EXPECT_TRUE(is_finite(capsule.from) && is_finite(capsule.to));
}

TEST(Figure, thickness_follows_the_size_of_the_body) {
  const Skeleton child = kBody.scaled(0.5);
  const Figure large = make_figure({kBody, kBody.rest_positions()}, student_style(Palette::RedGreen));
  const Figure small = make_figure({child, child.rest_positions()}, student_style(Palette::RedGreen));
  ASSERT_EQ(large.capsules.size(), small.capsules.size());
  for (std::size_t i = 0; i < large.capsules.size(); ++i)
    EXPECT_NEAR(small.capsules[i].from_radius_m, 0.5 * large.capsules[i].from_radius_m, 1e-9);
}

double brightness(const Colour& c) {
  return 0.2126 * std::pow(static_cast<double>(c.red), 2.2) +
         0.7152 * std::pow(static_cast<double>(c.green), 2.2) +
         0.0722 * std::pow(static_cast<double>(c.blue), 2.2);
}

TEST(Figure, colour_blind_palette_tells_apart_by_brightness_and_bands) {
  const FigureStyle student = student_style(Palette::ColourBlindSafe),
                    coach = coach_style(Palette::ColourBlindSafe);
  EXPECT_NE(student.surface, coach.surface);
  EXPECT_GT(brightness(coach.bone) / brightness(student.bone), 1.5);
}

}  // namespace
}  // namespace posecoach
