#include "core/coaching/film_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/coaching/body_axes.h"
#include "core/coaching/compare.h"
#include "core/coaching/score.h"
#include "core/motion/authored/golf_fault.h"
#include "tests/core/coaching/strokes.h"

namespace posecoach {
namespace {

constexpr double kFaceOn_deg = 0, kLine_deg = -90;

TEST(FilmErrors, motion_capture_has_none) {
  EXPECT_TRUE(UsualFilmError().is_none());
  EXPECT_EQ(UsualFilmError().of("head", 0), 0);
  EXPECT_EQ(UsualFilmError().offset(HumanoidJoint::Head, 0), Vec3(0));
}

TEST(FilmErrors, go_over_from_one_side_to_the_other_without_a_jump) {
  for (const StrokeKind kind : {StrokeKind::FullSwing, StrokeKind::Putt})
    for (const char* part : {"trunk", "hips", "head", "lead_arm", "trail_leg"})
      for (double degrees = -180; degrees < 180; degrees += 0.5) {
        const UsualFilmError here(kind, degrees), beside(kind, degrees + 0.5);
        EXPECT_GT(here.of(part, 3), 0) << part << " " << degrees;
        EXPECT_NEAR(here.of(part, 3), beside.of(part, 3), 0.01) << part << " " << degrees;
        for (const int stage : {0, 3, 5})
          EXPECT_NEAR(glm::distance(here.share() * here.offset(HumanoidJoint::LeftWrist, stage),
                                    beside.share() * beside.offset(HumanoidJoint::LeftWrist, stage)),
                      0, 0.02)
              << degrees;
      }
}

TEST(FilmErrors, from_where_no_offsets_are_known_their_size_is_forgiven) {
  for (const StrokeKind kind : {StrokeKind::FullSwing, StrokeKind::Putt})
    for (const char* part : {"trunk", "head", "lead_arm"}) {
      const UsualFilmError known(kind, kFaceOn_deg), behind(kind, 180);
      EXPECT_EQ(known.share(), 1);
      EXPECT_EQ(behind.share(), 0);
      EXPECT_GT(behind.of(part, 3), 1.5 * known.of(part, 3)) << part;
      EXPECT_EQ(known.shown(0).of(part, 3), behind.of(part, 3)) << part;
      EXPECT_EQ(known.shown(0.8).of(part, 3), known.of(part, 3)) << part;
    }
}

TEST(FilmErrors, cancel_between_two_films_from_one_side) {
  const UsualFilmError one(StrokeKind::FullSwing, kLine_deg);
  EXPECT_EQ(one.between_films(true).offset(HumanoidJoint::Head, 3), Vec3(0));
  EXPECT_LT(one.between_films(true).of("head", 3), one.between_films(false).of("head", 3));
}

// What the pose stage makes of a stroke: every joint beside its place by its usual offset for a camera there.
Motion with_habits(const Motion& motion, double camera_deg) {
  const JointTrack track = JointTrack::from_motion(motion).value();
  const SwingEvents events = find_swing_events(track).value();
  const FilmStages stages(events);
  const UsualFilmError usual(events.kind, camera_deg);
  const BodyAxes axes = body_axes(track, events.time_of("address"), events.time_of("address"));
  const double leg = leg_length(track), last_s = events.events[events.events.size() - 2].time_s;
  return with_positions(motion, [&](int frame, int joint, const Vec3& p) {
    const auto role = motion.skeleton().joint(joint).role;
    if (!role) return p;
    Vec3 offset(0);
    double weights = 0;
    for (int stage = 0; stage < stages.count(); ++stage) {
      const double weight = stages.weight(stage, std::min(track.time(frame), last_s));
      offset += weight * usual.offset(*role, stage);
      weights += weight;
    }
    offset *= leg / weights;
    return p + offset.x * axes.left + offset.y * axes.up + offset.z * axes.front;
  });
}

Motion stroke_with(std::string_view fault, double amount, Handedness hand = Handedness::Right) {
  GolfScript script = bundled_script("swing").value();
  if (amount > 0) {
    EXPECT_TRUE(apply_fault(script, choose_fault(fault, amount).value()));
  }
  return make_stroke(script, {.frames_per_second = 30, .hand = hand}).motion;
}

double score_of_film(const Motion& stroke, double camera_deg) {
  const Motion coach = make_stroke().motion;
  const double angle = radians_from_degrees(camera_deg);
  CompareOptions options;
  options.sight.direction = -Vec3(std::sin(angle), 0, std::cos(angle));
  options.views.student = std::abs(camera_deg) < 45 ? Viewpoint::FaceOn : Viewpoint::DownTheLine;
  return compare(with_habits(stroke, camera_deg), coach, options).value().score.percent;
}

TEST(FilmErrors, of_a_faultless_stroke_cost_nothing_from_any_place_that_is_known) {
  const Motion stroke = stroke_with("", 0);
  for (const double camera_deg : {-105.0, -85.0, -65.0, -18.0, 0.0, 10.0, 20.0})
    EXPECT_GE(score_of_film(stroke, camera_deg), 98) << camera_deg;
}

TEST(FilmErrors, leave_a_fault_its_price_and_twenty_degrees_change_it_by_less_than_three_points) {
  for (const auto& [fault, square_deg] : {std::pair("sway", kFaceOn_deg), std::pair("slide", kFaceOn_deg),
                                          std::pair("early_extension", -85.0)}) {
    const double usual = choose_fault(fault).value().amount;
    double last = 100.1;
    for (const double amount : {0.0, 0.75 * usual, usual, 1.25 * usual, 1.5 * usual}) {
      const double square = score_of_film(stroke_with(fault, amount), square_deg);
      EXPECT_LT(square, last) << fault << " " << amount;
      last = square;
    }
    EXPECT_LT(last, 93) << fault;
    const Motion stroke = stroke_with(fault, usual);
    for (const double turned_deg : {-20.0, -10.0, 10.0, 20.0})
      EXPECT_NEAR(score_of_film(stroke, square_deg + turned_deg), score_of_film(stroke, square_deg), 3)
          << fault << " " << turned_deg;
  }
}

}  // namespace
}  // namespace posecoach
