#include "core/coaching/moved_events.h"

#include <gtest/gtest.h>

#include <random>

#include "core/coaching/analysis_json.h"
#include "core/coaching/compare.h"
#include "tests/core/coaching/strokes.h"

namespace posecoach {
namespace {

struct FoundStroke {
  JointTrack track;
  SwingEvents swing;
};

FoundStroke found_stroke(std::string_view name = "swing", double frames_per_second = 60) {
  const Motion motion = make_stroke({.name = name, .frames_per_second = frames_per_second}).motion;
  JointTrack track = JointTrack::from_motion(motion).value();
  SwingEvents swing = find_swing_events(track).value();
  return {std::move(track), std::move(swing)};
}

int frame_of(const SwingEvents& swing, std::string_view name) {
  for (const SwingEvent& event : swing.events)
    if (event.name == name) return event.frame;
  return -1;
}

TEST(MovedEvents, a_moved_event_is_where_it_was_put_and_the_others_stay) {
  const FoundStroke found = found_stroke();
  const int top = frame_of(found.swing, "top") + 2;
  const auto moved = with_moved(found.swing, {{"top", top}}, found.track);
  ASSERT_TRUE(moved.has_value());
  for (std::size_t k = 0; k < moved->events.size(); ++k) {
    const SwingEvent &before = found.swing.events[k], &after = moved->events[k];
    EXPECT_EQ(after.frame, after.name == "top" ? top : before.frame);
    EXPECT_EQ(after.time_s, after.name == "top" ? found.track.time(top) : before.time_s);
  }
}

TEST(MovedEvents, nothing_moved_changes_nothing) {
  const FoundStroke found = found_stroke("putt");
  const auto moved = with_moved(found.swing, {{"no such event", 3}}, found.track);
  ASSERT_TRUE(moved.has_value());
  EXPECT_EQ(moved->takeaway_s, found.swing.takeaway_s);
  for (std::size_t k = 0; k < moved->events.size(); ++k)
    EXPECT_EQ(moved->events[k].time_s, found.swing.events[k].time_s);
}

TEST(MovedEvents, what_was_found_gives_way_and_stays_in_order) {
  const FoundStroke found = found_stroke();
  std::mt19937 random(7);
  std::uniform_int_distribution<int> anywhere(-5, found.track.frame_count() + 5);
  std::uniform_int_distribution<std::size_t> any_event(0, found.swing.events.size() - 1);
  int kept = 0;
  for (int round = 0; round < 400; ++round) {
    const MovedEvent wish{found.swing.events[any_event(random)].name, anywhere(random)};
    const auto moved = with_moved(found.swing, {wish}, found.track);
    if (!moved) continue;
    ++kept;
    EXPECT_EQ(frame_of(*moved, wish.name), std::clamp(wish.frame, 0, found.track.frame_count() - 1));
    for (std::size_t k = 1; k < moved->events.size(); ++k) {
      EXPECT_GT(moved->events[k].frame, moved->events[k - 1].frame);
      EXPECT_GT(moved->events[k].time_s, moved->events[k - 1].time_s);
    }
    EXPECT_GE(moved->takeaway_s, moved->events[0].time_s);
    EXPECT_LE(moved->takeaway_s, moved->events[1].time_s);
  }
  EXPECT_GT(kept, 300);  // most places leave room for the others
}

TEST(MovedEvents, events_that_do_not_follow_each_other_are_refused) {
  const FoundStroke found = found_stroke();
  EXPECT_FALSE(with_moved(found.swing, {{"top", 40}, {"impact", 30}}, found.track));
  EXPECT_FALSE(with_moved(found.swing, {{"toe_up", 0}}, found.track));  // no frame is left for the address
}

double metric(const Analysis& analysis, std::string_view name) {
  for (const Metric& one : analysis.metrics)
    if (one.name == name && one.available) return one.value;
  ADD_FAILURE() << "no metric " << name;
  return 0;
}

TEST(MovedEvents, tempo_and_timing_are_told_from_them) {
  const Motion coach = make_stroke({.frames_per_second = 60}).motion;
  const Analysis found = compare(coach, coach).value();
  int top = 0;
  for (const SwingEvent& event : found.student_events)
    if (event.name == "top") top = event.frame;
  CompareOptions options;
  options.moved_events = {{"top", top + 4}};
  const Analysis moved = compare(coach, coach, options).value();
  EXPECT_GT(metric(moved, "tempo_ratio"), metric(found, "tempo_ratio") * 1.1);
  for (const SwingEvent& event : moved.student_events)
    if (event.name == "top") {
      EXPECT_EQ(event.frame, top + 4);
    }
  EXPECT_NE(to_json(moved).find("moved by hand"), std::string::npos);
  options.moved_events = {{"top", top}, {"impact", top - 3}};
  const Analysis refused = compare(coach, coach, options).value();
  EXPECT_EQ(metric(refused, "tempo_ratio"), metric(found, "tempo_ratio"));
}

TEST(MovedEvents, a_left_handers_are_those_of_his_mirror_image) {
  const Motion right = make_stroke({.frames_per_second = 60}).motion,
               left = make_stroke({.frames_per_second = 60, .hand = Handedness::Left}).motion;
  CompareOptions options;
  options.moved_events = {{"top", 50}};
  const Analysis a = compare(right, right, options).value(), b = compare(left, right, options).value();
  EXPECT_NEAR(metric(a, "tempo_ratio"), metric(b, "tempo_ratio"), 1e-9);
}

}  // namespace
}  // namespace posecoach
