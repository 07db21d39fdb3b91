#include "core/coaching/swing_events.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/coaching/strokes.h"

namespace posecoach {
namespace {

constexpr double kFrame_s = 1.0 / 30;

SwingEvents events_of(const Motion& motion) {
  const auto track = JointTrack::from_motion(motion);
  EXPECT_TRUE(track.has_value());
  const auto events = find_swing_events(*track);
  EXPECT_TRUE(events.has_value()) << (events ? "" : events.error().message);
  return events.value();
}

void expect_true_events(const AuthoredMotion& stroke, double tolerance_s = kFrame_s) {
  const SwingEvents found = events_of(stroke.motion);
  for (const SwingEvent& event : found.events)
    EXPECT_NEAR(event.time_s, stroke.time_of(event.name), tolerance_s) << event.name;
  EXPECT_NEAR(found.takeaway_s, stroke.time_of("takeaway"), tolerance_s);
  for (std::size_t k = 1; k < found.events.size(); ++k)
    EXPECT_LT(found.events[k - 1].time_s, found.events[k].time_s) << found.events[k].name;
}

std::vector<std::string> names_of(const SwingEvents& events) {
  std::vector<std::string> names;
  for (const SwingEvent& event : events.events) names.push_back(event.name);
  return names;
}

TEST(SwingEvents, of_a_full_swing_are_the_eight_in_order) {
  const SwingEvents found = events_of(make_stroke().motion);
  EXPECT_EQ(found.kind, StrokeKind::FullSwing);
  EXPECT_EQ(names_of(found),
            (std::vector<std::string>{"address", "toe_up", "mid_backswing", "top", "mid_downswing", "impact",
                                      "mid_follow_through", "finish"}));
}

TEST(SwingEvents, of_a_putt_are_address_top_impact_and_end) {
  const SwingEvents found = events_of(make_stroke({.name = "putt"}).motion);
  EXPECT_EQ(found.kind, StrokeKind::Putt);
  EXPECT_EQ(names_of(found), (std::vector<std::string>{"address", "top", "impact", "end"}));
}

TEST(SwingEvents, lie_within_a_film_frame_of_the_truth_on_any_body_hand_and_frame_rate) {
  for (const double fps : {30.0, 60.0, 120.0, 240.0})
    for (const double height : {1.5, 1.75, 2.0})
      for (const Handedness hand : {Handedness::Right, Handedness::Left})
        for (const char* name : {"swing", "putt"}) {
          SCOPED_TRACE(std::string(name) + " " + std::to_string(height) + " m, " + std::to_string(fps) +
                       " fps");
          const AuthoredMotion stroke = make_stroke({name, fps, {.height_m = height}, hand});
          expect_true_events(stroke);
          EXPECT_EQ(events_of(stroke.motion).hand, hand);
        }
}

TEST(SwingEvents, lie_within_a_film_frame_on_limbs_a_quarter_longer_or_shorter) {
  const std::vector<BodyProportions> bodies = {
      {.height_m = 1.75, .arms = 1.25},
      {.height_m = 1.75, .arms = 0.80},
      {.height_m = 1.80, .torso = 0.85, .thighs = 1.25, .shins = 1.25},
      {.height_m = 1.70, .torso = 1.15, .thighs = 0.75, .shins = 0.75},
      {.height_m = 1.80, .shoulders = 1.25, .hips = 1.25},
      {.height_m = 1.80, .shoulders = 0.75, .hips = 0.75}};
  for (const double fps : {30.0, 120.0})
    for (std::size_t body = 0; body < bodies.size(); ++body)
      for (const char* name : {"swing", "putt"}) {
        SCOPED_TRACE(std::string(name) + " on body " + std::to_string(body) + ", " + std::to_string(fps) +
                     " fps");
        expect_true_events(make_stroke({name, fps, bodies[body], Handedness::Right}));
      }
}

TEST(SwingEvents, do_not_care_which_way_the_golfer_faces) {
  const Motion swing = make_stroke().motion;
  const SwingEvents straight = events_of(swing), turned = events_of(turned_by(swing, 2.1));
  EXPECT_EQ(turned.hand, straight.hand);
  for (std::size_t k = 0; k < straight.events.size(); ++k)
    EXPECT_NEAR(turned.events[k].time_s, straight.events[k].time_s, 1e-6);
}

// Seconds of waggle before and of a long finish after, at 30 fps.
Motion with_waggle_and_long_finish(const Motion& swing, double waggle_s, double finish_s) {
  std::vector<MediaTime> times;
  std::vector<Vec3> positions;
  const int left = swing.skeleton().find(HumanoidJoint::LeftWrist),
            right = swing.skeleton().find(HumanoidJoint::RightWrist);
  const auto add = [&](double time_s, int frame, double sway_m) {
    times.push_back(media_time_from_seconds(time_s));
    for (int joint = 0; joint < swing.joint_count(); ++joint)
      positions.push_back(swing.position(frame, joint) +
                          Vec3(joint == left || joint == right ? sway_m : 0, 0, 0));
  };
  const double step = 1.0 / 30;
  for (double t = 0; t < waggle_s; t += step)
    add(t, 0, 0.06 * std::sin(2 * kPi * t / 0.8) * std::sin(kPi * t / waggle_s));
  const double begin = to_seconds(times.back() - MediaTime{}) + step;
  for (int frame = 0; frame < swing.frame_count(); ++frame)
    add(begin + to_seconds(swing.time(frame)), frame, 0);
  const double end = to_seconds(times.back() - MediaTime{});
  for (double t = step; t < finish_s; t += step) add(end + t, swing.frame_count() - 1, 0);
  return Motion::from_positions(swing.skeleton(), std::move(times), std::move(positions)).value();
}

TEST(SwingEvents, are_not_fooled_by_seconds_of_waggle_and_a_long_finish) {
  const AuthoredMotion stroke = make_stroke({.frames_per_second = 30});
  const Motion film = with_waggle_and_long_finish(stroke.motion, 4.0, 3.0);
  const double shift = to_seconds(film.duration()) - to_seconds(stroke.motion.duration()) - 3.0;
  const SwingEvents found = events_of(film);
  for (const SwingEvent& event : found.events)
    EXPECT_NEAR(event.time_s, stroke.time_of(event.name) + shift, 2 * kFrame_s) << event.name;
}

TEST(SwingEvents, hold_when_the_joints_tremble_as_a_webcams_do) {
  const AuthoredMotion stroke = make_stroke({.frames_per_second = 30});
  const SwingEvents found = events_of(trembling(stroke.motion, 0.003, 0.9));
  for (const char* name : {"top", "impact", "mid_downswing", "finish"})
    EXPECT_NEAR(found.time_of(name), stroke.time_of(name), 1.5 * kFrame_s) << name;
}

// As films from in front show some golfers: shortly before the top the hands seem to drop below the
// shoulders.
TEST(SwingEvents, of_a_backswing_are_not_fooled_by_arms_that_seem_to_dip_before_the_top) {
  const AuthoredMotion stroke = make_stroke();
  const Skeleton& body = stroke.motion.skeleton();
  const int left = body.find(HumanoidJoint::LeftWrist), right = body.find(HumanoidJoint::RightWrist);
  const double dip_s = 0.5 * (stroke.time_of("mid_backswing") + stroke.time_of("top"));
  const Motion seen = with_positions(stroke.motion, [&](int frame, int joint, const Vec3& p) {
    const double off_s = std::abs(to_seconds(stroke.motion.time(frame)) - dip_s);
    const bool is_dipping = (joint == left || joint == right) && off_s < 0.06;
    return is_dipping ? p - Vec3(0, 0.3 * (1 - off_s / 0.06), 0) : p;
  });
  EXPECT_NEAR(events_of(seen).time_of("mid_backswing"), stroke.time_of("mid_backswing"), kFrame_s);
}

// A camera on the target line sees nothing of the hands' way: here it is anything, in every frame.
TEST(SwingEvents, of_a_putt_down_the_line_are_told_by_the_shoulders_alone) {
  for (const double fps : {30.0, 60.0})
    for (const double length : {0.5, 1.0, 1.5})
      for (const double height : {1.5, 1.8, 2.0})
        for (const Handedness hand : {Handedness::Right, Handedness::Left}) {
          SCOPED_TRACE(std::to_string(height) + " m, " + std::to_string(length) + " long, " +
                       std::to_string(fps) + " fps");
          GolfScript script = bundled_script("putt").value();
          script.lengthen(length);
          const AuthoredMotion stroke = make_stroke(script, {"putt", fps, {.height_m = height}, hand});
          std::mt19937 random(3);
          std::normal_distribution<double> normal;
          const Motion seen = with_positions(stroke.motion, [&](int, int, const Vec3& p) {
            return p + Vec3(0.02 * normal(random), 0.0001 * normal(random), 0.0001 * normal(random));
          });
          const auto track = JointTrack::from_motion(seen);
          const auto found = find_swing_events(*track, {{}, {Vec3(1, 0, 0)}});
          ASSERT_TRUE(found) << found.error().message;
          EXPECT_EQ(found->kind, StrokeKind::Putt);
          EXPECT_EQ(found->hand, hand);
          for (const SwingEvent& event : found->events)
            EXPECT_NEAR(event.time_s, stroke.time_of(event.name), kFrame_s) << event.name;
          EXPECT_NEAR(found->takeaway_s, stroke.time_of("takeaway"), kFrame_s);
        }
}

TEST(SwingEvents, of_a_putt_lost_in_the_tremble_are_refused_with_what_to_do) {
  GolfScript script = bundled_script("putt").value();
  script.lengthen(0.15);
  const Motion seen = trembling(make_stroke(script, {"putt", 30}).motion, 0.004);
  const JointTrack track = JointTrack::from_motion(seen).value();
  const auto from_behind = find_swing_events(track, {{}, {Vec3(1, 0, 0)}});
  ASSERT_FALSE(from_behind);
  EXPECT_NE(from_behind.error().message.find("film putts face-on"), std::string::npos)
      << from_behind.error().message;
}

TEST(SwingEvents, are_refused_with_a_reason_when_nobody_swings) {
  const Motion swing = make_stroke().motion;
  const Motion still =
      with_positions(swing, [&](int, int joint, const Vec3&) { return swing.position(0, joint); });
  const auto found = find_swing_events(JointTrack::from_motion(still).value());
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::Incomplete);
  EXPECT_NE(found.error().message.find("no stroke"), std::string::npos) << found.error().message;
}

TEST(SwingEvents, are_refused_when_the_film_starts_in_the_backswing_or_ends_before_impact) {
  const AuthoredMotion stroke = make_stroke();
  const auto frame_at = [&](const char* event) { return static_cast<int>(stroke.time_of(event) * 120); };
  const Motion late = stroke.motion.slice(frame_at("mid_backswing"), stroke.motion.frame_count());
  const auto of_late = find_swing_events(JointTrack::from_motion(late).value());
  ASSERT_FALSE(of_late);
  EXPECT_NE(of_late.error().message.find("start is not seen"), std::string::npos) << of_late.error().message;
  const Motion early = stroke.motion.slice(0, frame_at("mid_downswing"));
  const auto of_early = find_swing_events(JointTrack::from_motion(early).value());
  ASSERT_FALSE(of_early);
  EXPECT_NE(of_early.error().message.find("no stroke"), std::string::npos) << of_early.error().message;
}

TEST(SwingEvents, need_the_joints_of_a_golfer) {
  const Skeleton point = Skeleton::make({{"pelvis", kNoJoint, {}, HumanoidJoint::Pelvis}}).value();
  const Motion motion = Motion::from_positions(point, {MediaTime{}}, {{}}).value();
  const auto track = JointTrack::from_motion(motion);
  ASSERT_FALSE(track);
  EXPECT_NE(track.error().message.find("left_wrist"), std::string::npos);
}

}  // namespace
}  // namespace posecoach
