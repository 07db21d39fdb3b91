#include "core/motion/authored/golf_fault.h"

#include <gtest/gtest.h>

#include <functional>

#include "core/body/standard_body.h"
#include "tests/core/motion/authored/golfer_measures.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

AuthoredMotion with_fault(std::string_view name, double amount) {
  const FaultChoice choice = choose_fault(name, amount).value();
  GolfScript script = bundled_script(choice.fault->motion).value();
  EXPECT_TRUE(apply_fault(script, choice));
  return make_authored_motion(script, make_standard_body({.height_m = 1.80}), 240).value();
}

AuthoredMotion without_fault(std::string_view motion) {
  return make_authored_motion(bundled_script(motion).value(), make_standard_body({.height_m = 1.80}), 240)
      .value();
}

// What a fault is about, measured from the joints; it grows with the fault.
struct Measure {
  std::string_view fault;
  std::function<double(const AuthoredMotion&)> of;
  double share;  // at least this part of the amount shows
};

double between(const AuthoredMotion& a, std::string_view from, std::string_view to) {
  return a.time_of(to) - a.time_of(from);
}

Vec3 hips(const AuthoredMotion& a, std::string_view event) {
  return hips_at(a.motion, frame_at(a, event));
}

double lead_elbow(const AuthoredMotion& a, std::string_view event) {
  return bend_deg(a.motion, frame_at(a, event), LeftShoulder, LeftElbow, LeftWrist);
}

double lean_to_target_deg(const AuthoredMotion& a, std::string_view event) {
  const Vec3 torso = torso_at(a.motion, frame_at(a, event));
  return degrees_from_radians(std::atan2(torso.x, torso.y));
}

double shoulder_tilt_deg(const AuthoredMotion& a, std::string_view event) {
  const int frame = frame_at(a, event);
  const Vec3 line = joint_at(a.motion, frame, LeftShoulder) - joint_at(a.motion, frame, RightShoulder);
  return degrees_from_radians(std::asin(-line.y / glm::length(line)));
}

// Between the shaft and the lead forearm, seen along the target line's normal: how far the club is past the
// hands.
double club_past_hands_deg(const AuthoredMotion& a, std::string_view event) {
  const auto frame = static_cast<std::size_t>(frame_at(a, event));
  const Vec3 shaft = a.club[frame].head - a.club[frame].grip;
  const Vec3 arm = joint_at(a.motion, static_cast<int>(frame), LeftWrist) -
                   joint_at(a.motion, static_cast<int>(frame), LeftElbow);
  return degrees_from_radians(std::atan2(shaft.x, -shaft.y) - std::atan2(arm.x, -arm.y));
}

const std::vector<Measure>& measures() {
  static const std::vector<Measure> kMeasures = {
      {"sway", [](const auto& a) { return -100 * hips(a, "top").x; }, 0.9},
      {"slide", [](const auto& a) { return 100 * hips(a, "impact").x; }, 0.9},
      {"early_extension", [](const auto& a) { return 100 * hips(a, "impact").z; }, 0.9},
      {"loss_of_posture", [](const auto& a) { return -forward_bend_deg(a.motion, frame_at(a, "impact")); },
       0.7},
      {"reverse_spine_angle", [](const auto& a) { return lean_to_target_deg(a, "top"); }, 0.7},
      {"chicken_wing", [](const auto& a) { return lead_elbow(a, "mid_follow_through"); }, 0.8},
      {"bent_lead_arm", [](const auto& a) { return lead_elbow(a, "top"); }, 0.9},
      {"over_the_top", [](const auto& a) { return 100 * hands_at(a.motion, frame_at(a, "mid_downswing")).z; },
       0.3},
      {"quick_transition", [](const auto& a) { return -100 * between(a, "top", "mid_downswing") / 0.15; },
       0.9},
      {"slow_backswing", [](const auto& a) { return 100 * between(a, "takeaway", "top") / 0.795; }, 0.9},
      {"head_lift", [](const auto& a) { return 100 * joint_at(a.motion, frame_at(a, "impact"), HeadTop).y; },
       0.6},
      {"flat_shoulder_turn", [](const auto& a) { return -shoulder_tilt_deg(a, "top"); }, 0.7},
      {"wrist_break", [](const auto& a) { return club_past_hands_deg(a, "end"); }, 0.8},
      {"head_moves_with_putter",
       [](const auto& a) {
         return 100 *
                (joint_at(a.motion, frame_at(a, "end"), Head).x -
                 joint_at(a.motion, frame_at(a, "top"), Head).x) /
                2;
       },
       0.6},
      {"uneven_tempo", [](const auto& a) { return 100 * between(a, "top", "impact") / 0.32; }, 0.9},
  };
  return kMeasures;
}

TEST(GolfFault, every_fault_has_a_measure_here) {
  ASSERT_EQ(measures().size(), golf_faults().size());
  for (const GolfFault& fault : golf_faults())
    EXPECT_TRUE(std::any_of(measures().begin(), measures().end(), [&](const Measure& m) {
      return m.fault == fault.name;
    })) << fault.name;
}

TEST(GolfFault, grows_with_its_amount_and_shows_about_as_much_as_it_says) {
  for (const Measure& measure : measures()) {
    const FaultChoice usual = choose_fault(measure.fault).value();
    double before = measure.of(without_fault(usual.fault->motion));
    const double none = before;
    for (const double part : {0.25, 0.5, 0.75, 1.0}) {
      const double now = measure.of(with_fault(measure.fault, part * usual.amount));
      EXPECT_GT(now, before) << measure.fault << " at " << part;
      before = now;
    }
    EXPECT_GT(before - none, measure.share * usual.amount) << measure.fault;
    EXPECT_LT(before - none, 1.7 * usual.amount) << measure.fault;
  }
}

TEST(GolfFault, of_no_amount_changes_nothing) {
  for (const GolfFault& fault : golf_faults()) {
    const AuthoredMotion faulty = with_fault(fault.name, 0), sound = without_fault(fault.motion);
    ASSERT_EQ(faulty.motion.frame_count(), sound.motion.frame_count()) << fault.name;
    for (int frame = 0; frame < sound.motion.frame_count(); frame += 5)
      for (int joint = 0; joint < sound.motion.joint_count(); ++joint)
        ASSERT_LT(glm::distance(faulty.motion.position(frame, joint), sound.motion.position(frame, joint)),
                  1e-12)
            << fault.name;
  }
}

TEST(GolfFault, leaves_address_and_finish_alone) {
  for (const GolfFault& fault : golf_faults()) {
    if (fault.unit == "%" || fault.motion == "putt") continue;
    const AuthoredMotion faulty = with_fault(fault.name, fault.default_amount),
                         sound = without_fault(fault.motion);
    for (const int frame : {0, sound.motion.frame_count() - 1})
      for (int joint = 0; joint < sound.motion.joint_count(); ++joint)
        ASSERT_LT(glm::distance(faulty.motion.position(frame, joint), sound.motion.position(frame, joint)),
                  1e-9)
            << fault.name << " " << frame;
  }
}

TEST(GolfFault, the_largest_still_holds_the_club_and_stands) {
  for (const GolfFault& fault : golf_faults())
    EXPECT_LT(with_fault(fault.name, fault.largest_amount).deficit_m, 0.002) << fault.name;
}

TEST(GolfFault, is_chosen_by_name_with_or_without_amount) {
  EXPECT_EQ(fault_from_string("sway").value().amount, 10);
  EXPECT_EQ(fault_from_string("sway=8.5").value().amount, 8.5);
  for (const char* wrong : {"swayy", "", "sway=", "sway=x", "sway=8cm", "sway=-1", "sway=1000", "sway=nan"}) {
    const auto none = fault_from_string(wrong);
    ASSERT_FALSE(none) << wrong;
    EXPECT_EQ(none.error().code, ErrorCode::InvalidArgument);
  }
  EXPECT_NE(fault_from_string("swayy").error().message.find("early_extension"), std::string::npos);
  EXPECT_NE(golf_fault_table().find("early_extension"), std::string::npos);
}

TEST(GolfFault, of_the_other_motion_is_refused) {
  GolfScript putt = bundled_script("putt").value();
  EXPECT_FALSE(apply_fault(putt, choose_fault("sway").value()));
}

}  // namespace
}  // namespace posecoach
