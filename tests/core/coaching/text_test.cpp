// What golfers read: every advice has a whole sentence, in the words of golfers.
#include <gtest/gtest.h>

#include <cctype>
#include <set>
#include <string>

#include "core/coaching/text/advice_text.h"
#include "core/coaching/text/fill.h"
#include "core/coaching/text/metric_text.h"
#include "core/coaching/text/picture_text.h"
#include "core/coaching/text/set_up_text.h"

namespace posecoach {
namespace {

void expect_sentence(const std::string& words) {
  ASSERT_FALSE(words.empty());
  EXPECT_TRUE(std::isupper(static_cast<unsigned char>(words.front())) != 0) << words;
  EXPECT_EQ(words.back(), '.') << words;
  EXPECT_EQ(words.find_first_of("{}_"), std::string::npos) << words;
  EXPECT_EQ(words.find("  "), std::string::npos) << words;
  EXPECT_EQ(words.find("left"), std::string::npos) << words;
  EXPECT_EQ(words.find("right,"), std::string::npos) << words;
}

TEST(Texts, every_difference_of_every_part_at_every_moment_has_its_sentence) {
  for (std::size_t k = 0; k < kFeatureCount; ++k)
    for (const char* event : {"address", "toe_up", "mid_backswing", "top", "mid_downswing", "impact",
                              "mid_follow_through", "finish", "end"})
      for (const double sign : {1.0, -1.0})
        for (const Viewpoint view :
             {Viewpoint::AllSides, Viewpoint::FaceOn, Viewpoint::DownTheLine, Viewpoint::Between})
          for (const Vec3& offset : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
            expect_sentence(text::spatial(
                {static_cast<Feature>(k), sign * 0.12, sign * 0.12 * offset, 0.3, 1}, event, "", view));
}

TEST(Texts, what_golfers_have_a_name_for_is_told_by_it) {
  const auto told = [](Feature feature, double amount, const char* event, const char* fault) {
    return text::spatial({feature, amount, Vec3(amount, 0, 0), 0.3, 1}, event, fault, Viewpoint::AllSides);
  };
  EXPECT_EQ(told(Feature::HipsToTarget, -0.1, "top", "sway"),
            "At the top, your hips are 10 cm too far from the target: a sway.");
  EXPECT_EQ(told(Feature::HipsToTarget, -0.1, "finish", ""),
            "At the finish, your hips are 10 cm too far from the target.");
  EXPECT_EQ(told(Feature::LeadArmBend, 24, "top", "bent_lead_arm"),
            "At the top, your lead arm is bent 24° more than the coach's.");
  EXPECT_EQ(told(Feature::HandsPlace, 0.1, "mid_follow_through", "chicken_wing"),
            "After impact, your hands are 10 cm from where the coach's are: your arms fold, a chicken wing.");
}

TEST(Texts, directions_that_the_camera_cannot_see_are_not_named) {
  const PartDifference elbow{Feature::LeadElbowPlace, 0.2, Vec3(0.03, 0.05, 0.19), 0.3, 1};
  EXPECT_NE(text::spatial(elbow, "top", "", Viewpoint::AllSides).find("ball"), std::string::npos);
  const std::string face_on = text::spatial(elbow, "top", "", Viewpoint::FaceOn);
  EXPECT_EQ(face_on, "At the top, your lead elbow is 6 cm too high.");
}

TEST(Texts, timing_says_both_times_and_how_much) {
  TimingAdvice downswing;
  downswing.from = "top";
  downswing.to = "impact";
  downswing.student_s = 0.20;
  downswing.coach_s = 0.30;
  EXPECT_EQ(text::timing(downswing, StrokeKind::FullSwing, 1, true),
            "Your downswing takes 0.20 s, the coach's 0.30 s: 33 % too quick.");
  EXPECT_EQ(text::timing(downswing, StrokeKind::FullSwing, 1, false),
            "Your downswing takes 0.20 s, the coach's 0.30 s: about the same.");
  downswing.student_s = 0.90;
  EXPECT_EQ(text::timing(downswing, StrokeKind::FullSwing, 2, true),
            "At your pace the downswing should take 0.60 s; yours takes 0.90 s: 50 % too slow.");
  for (const StrokeKind kind : {StrokeKind::FullSwing, StrokeKind::Putt})
    for (const auto& [from, to] :
         {std::pair("takeaway", "top"), std::pair("top", "mid_downswing"), std::pair("top", "impact"),
          std::pair("impact", "finish"), std::pair("impact", "end")})
      for (const double student_s : {0.2, 0.4})
        for (const double pace : {1.0, 2.5})
          for (const bool is_clear : {false, true}) {
            TimingAdvice phase = downswing;
            phase.from = from;
            phase.to = to;
            phase.student_s = student_s;
            expect_sentence(text::timing(phase, kind, pace, is_clear));
          }
}

TEST(Texts, blanks_are_filled_wherever_they_stand) {
  EXPECT_EQ(text::filled("{b} before {a}, {a}", {{"a", "1"}, {"b", "2"}}), "2 before 1, 1");
  EXPECT_EQ(text::filled("nothing", {}), "nothing");
}

TEST(Texts, units_stand_behind_numbers_as_people_write_them) {
  EXPECT_EQ("24" + text::unit("deg"), "24°");
  EXPECT_EQ("8" + text::unit("cm"), "8 cm");
  EXPECT_EQ("3" + text::unit(""), "3");
}

TEST(Texts, every_check_of_the_set_up_has_its_own_short_words) {
  constexpr std::size_t kFitsBesideThePicture = 80;
  std::set<std::string> all;
  for (int k = 0; k <= static_cast<int>(text::SetUp::DistanceGood); ++k)
    all.insert(text::set_up(static_cast<text::SetUp>(k)));
  for (const Viewpoint side : {Viewpoint::FaceOn, Viewpoint::DownTheLine})
    for (const double aside_deg : {-30.0, 30.0}) all.insert(text::camera_stands_aside(side, aside_deg));
  EXPECT_EQ(all.size(), static_cast<std::size_t>(text::SetUp::DistanceGood) + 1 + 4);
  for (const std::string& words : all) {
    EXPECT_TRUE(std::isupper(static_cast<unsigned char>(words.front())) != 0) << words;
    EXPECT_NE(words.back(), '.') << words;
    EXPECT_LE(words.size(), kFitsBesideThePicture) << words;
  }
}

TEST(Texts, a_joint_beside_the_pictures_is_told_by_the_way_it_is_off) {
  EXPECT_EQ(text::picture_offset(HumanoidJoint::LeftElbow, 0.01, 0.08),
            "In the pose of the coach's picture, your left elbow is 8 cm too high.");
  EXPECT_EQ(text::picture_offset(HumanoidJoint::Head, -0.07, 0.01),
            "In the pose of the coach's picture, your head is 7 cm too far to the left in the picture.");
  EXPECT_EQ(
      text::picture_offset(HumanoidJoint::RightWrist, 0.06, -0.08),
      "In the pose of the coach's picture, your right wrist is 8 cm too low and 6 cm too far to the right in "
      "the picture.");
}

}  // namespace
}  // namespace posecoach
