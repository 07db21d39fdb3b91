#include "core/coaching/address_advice.h"

#include <gtest/gtest.h>

#include "core/coaching/body_axes.h"
#include "tests/core/coaching/strokes.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

JointTrack address_of(const Motion& motion) {
  return JointTrack::from_motion(motion).value().averaged(0, 0.1);
}

// The stroke with one joint after the other moved, in the world's axes (ball at +Z, target at +X).
Motion moved(const std::function<Vec3(HumanoidJoint, const Vec3&)>& map) {
  const Motion stroke = make_stroke().motion;
  return with_positions(stroke, [&](int, int joint, const Vec3& p) {
    const auto role = stroke.skeleton().joint(joint).role;
    return role ? map(*role, p) : p;
  });
}

TEST(AddressAdvice, is_empty_for_the_coachs_own_posture) {
  const JointTrack coach = address_of(make_stroke().motion);
  for (const Viewpoint view :
       {Viewpoint::AllSides, Viewpoint::FaceOn, Viewpoint::DownTheLine, Viewpoint::Between})
    EXPECT_TRUE(address_advice(coach, coach, view).empty());
}

TEST(AddressAdvice, a_narrow_stance_is_told_from_the_front_and_not_down_the_line) {
  const JointTrack coach = address_of(make_stroke().motion);
  const JointTrack narrow = address_of(moved([](HumanoidJoint joint, const Vec3& p) {
    if (joint == LeftAnkle) return p - Vec3(0.05, 0, 0);
    return joint == RightAnkle ? p + Vec3(0.05, 0, 0) : p;
  }));
  const auto advice = address_advice(narrow, coach, Viewpoint::FaceOn);
  ASSERT_FALSE(advice.empty());
  EXPECT_EQ(advice[0], "Widen your stance by 10 cm.");
  EXPECT_TRUE(address_advice(narrow, coach, Viewpoint::DownTheLine).empty());
}

TEST(AddressAdvice, an_upright_spine_is_told_down_the_line_and_not_from_the_front) {
  const JointTrack coach = address_of(make_stroke().motion);
  const double pelvis_y = coach.position(0, Pelvis).y;
  const double upright = radians_from_degrees(-14);
  const JointTrack student = address_of(moved([&](HumanoidJoint joint, const Vec3& p) {
    // Wrists stay on the club.
    if (p.y < pelvis_y + 0.02 || joint == LeftWrist || joint == RightWrist) return p;
    const Vec3 pivot = coach.position(0, Pelvis), over = p - pivot;
    return pivot + Vec3(over.x, std::cos(upright) * over.y - std::sin(upright) * over.z,
                        std::sin(upright) * over.y + std::cos(upright) * over.z);
  }));
  const auto advice = address_advice(student, coach, Viewpoint::DownTheLine);
  ASSERT_FALSE(advice.empty());
  EXPECT_NE(advice[0].find("Bend forward 1"), std::string::npos) << advice[0];
  for (const std::string& line : address_advice(student, coach, Viewpoint::FaceOn))
    EXPECT_EQ(line.find("Bend forward"), std::string::npos) << line;
}

TEST(AddressAdvice, keeps_to_the_two_that_matter_most) {
  const JointTrack coach = address_of(make_stroke().motion);
  const JointTrack student = address_of(moved([&](HumanoidJoint joint, const Vec3& p) {
    if (joint == LeftAnkle) return p + Vec3(0.2, 0, 0);
    if (joint == LeftWrist || joint == RightWrist) return p + Vec3(0, 0, 0.3);
    if (joint == LeftKnee || joint == RightKnee) return p + Vec3(0, 0, 0.15);
    return joint == LeftShoulder || joint == RightShoulder ? p + Vec3(0.1, 0, 0.1) : p;
  }));
  EXPECT_EQ(address_advice(student, coach, Viewpoint::AllSides).size(), 2U);
}

}  // namespace
}  // namespace posecoach
