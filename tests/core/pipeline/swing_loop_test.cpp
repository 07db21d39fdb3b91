#include <gtest/gtest.h>

#include <algorithm>

#include "core/motion/bundled_motion.h"
#include "core/pipeline/coach_pipeline.h"
#include "core/pipeline/swing_memory.h"
#include "tests/support/filmed_golfer.h"

namespace posecoach {
namespace {

using enum GolferPart::Kind;

// Small pictures: they are compressed, one by one.
constexpr double kSmall = 0.25;
constexpr PoseNoise kNoise{kSmall * kFilteredNoise.image_px, kFilteredNoise.world_m, kFilteredNoise.depth_m};

struct Session {
  std::shared_ptr<const GolferFilm> film;
  InlineWork work;
  CoachPipeline pipeline;
  std::vector<CoachSnapshot> snapshots;

  Session(const GolferScript& script, const PinholeCamera& camera)
      : film(std::make_shared<const GolferFilm>(film_golfer(script, scaled(camera, kSmall), kNoise))),
        pipeline(std::make_unique<KnowingEstimator>(film), work) {
    pipeline.set_coach(bundled_motion(script.stroke).value(), "bundled:" + script.stroke);
  }

  void play() {
    for (std::size_t i = 0; i < film->count(); ++i)
      snapshots.push_back(pipeline.step(film->frame(i)).value());
  }
  // Each swing that was shown, once.
  std::vector<std::shared_ptr<const AnalyzedSwing>> swings() const {
    std::vector<std::shared_ptr<const AnalyzedSwing>> all;
    for (const CoachSnapshot& s : snapshots)
      if (s.swing && (all.empty() || all.back() != s.swing)) all.push_back(s.swing);
    return all;
  }
  // The states in the order in which they were shown.
  std::vector<LoopState> states() const {
    std::vector<LoopState> all;
    for (const CoachSnapshot& s : snapshots)
      if (all.empty() || all.back() != s.loop) all.push_back(s.loop);
    return all;
  }
};

TEST(SwingLoop, a_swing_goes_through_the_states_and_back_to_live_by_itself) {
  Session session({.parts = {{Walk, 2}, {Stand, 3}, {Stroke}, {Walk, 15}}}, face_on_camera());
  session.pipeline.arm();
  session.play();
  using enum LoopState;
  EXPECT_EQ(session.states(), (std::vector{Armed, Ready, Swinging, Analyzing, Replay, Armed}));
  ASSERT_EQ(session.swings().size(), 1U);
  EXPECT_TRUE(session.snapshots.back().swing_message.empty());
}

TEST(SwingLoop, the_swing_holds_its_pre_roll_its_pictures_and_its_analysis) {
  Session session({.parts = {{Walk, 2}, {Stand, 4}, {Stroke}, {Stand, 2}}}, face_on_camera());
  session.pipeline.arm();
  session.play();
  ASSERT_EQ(session.swings().size(), 1U) << session.snapshots.back().swing_message;
  const AnalyzedSwing& swing = *session.swings()[0];
  EXPECT_GE(swing.pair.analysis.student_takeaway_s, 1.5);
  EXPECT_EQ(swing.track.frames.front().time, MediaTime{});
  ASSERT_EQ(swing.pictures->count(), swing.track.frames.size());
  for (std::size_t k = 0; k < swing.pictures->count(); k += 20) {
    const auto picture = swing.pictures->picture(k);
    ASSERT_TRUE(picture);
    EXPECT_EQ((*picture)->width, 320);
    EXPECT_EQ(swing.pictures->time(k), swing.track.frames[k].time);
  }
  EXPECT_EQ(swing.pair.analysis.student_events.back().name, "finish");
  EXPECT_GT(swing.pair.analysis.score.percent, 80) << "the coach's own motion";
  EXPECT_FALSE(swing.pair.analysis.advice.empty());
}

TEST(SwingLoop, the_answer_comes_soon_after_the_finish) {
  for (const std::string stroke : {"swing", "putt"}) {
    Session session({.stroke = stroke, .parts = {{Stand, 3}, {Stroke}, {Stand, 3}}}, face_on_camera());
    session.pipeline.arm();
    session.play();
    ASSERT_EQ(session.swings().size(), 1U) << stroke << ": " << session.snapshots.back().swing_message;
    const auto answered = std::find_if(session.snapshots.begin(), session.snapshots.end(),
                                       [](const CoachSnapshot& s) { return s.swing != nullptr; });
    EXPECT_LT(to_seconds(answered->frame->time), session.film->stroke_end_s[0] + 1.0);
    // The finish itself is in it, and what is told comes within a second of it.
    const std::vector<SwingEvent>& events = answered->swing->pair.analysis.student_events;
    ASSERT_FALSE(events.empty()) << stroke;
    const double last_s = to_seconds(answered->swing->track.frames.back().time);
    EXPECT_LT(events.back().time_s, last_s);
    EXPECT_LT(last_s - events.back().time_s, 1.0) << stroke;
  }
}

TEST(SwingLoop, who_waits_for_a_putt_before_a_camera_behind_him_is_told_where_to_put_it) {
  const auto message = [](const std::string& stroke, bool is_face_on, bool is_armed) {
    Session session({.stroke = stroke, .parts = {{Walk, 2}, {Stand, 4}}},
                    is_face_on ? face_on_camera() : down_the_line_camera(false));
    if (is_armed) session.pipeline.arm();
    session.play();
    return session.snapshots.back().swing_message;
  };
  EXPECT_EQ(message("putt", false, true).rfind("Film putts face-on", 0), 0U);
  EXPECT_EQ(message("putt", false, false), "") << "the set-up checks tell it";
  EXPECT_EQ(message("putt", true, true), "");
  EXPECT_EQ(message("swing", false, true), "");
}

TEST(SwingLoop, a_long_putt_down_the_line_is_found_and_divided) {
  Session session({.stroke = "putt", .parts = {{Stand, 3}, {Stroke}, {Stand, 3}}, .length = 1.5},
                  down_the_line_camera(false));
  session.pipeline.arm();
  session.play();
  ASSERT_EQ(session.swings().size(), 1U) << session.snapshots.back().swing_message;
  const Analysis& analysis = session.swings()[0]->pair.analysis;
  ASSERT_EQ(analysis.student_events.size(), 4U);
  const AuthoredMotion putt = bundled_authored_motion("putt").value();
  // From the first frame of the swing's own film.
  const double told = analysis.student_events[2].time_s - analysis.student_events[1].time_s;
  EXPECT_NEAR(told, putt.time_of("impact") - putt.time_of("top"), 2.0 / 30);
}

TEST(SwingLoop, a_swing_in_slow_motion_is_kept_to_its_finish) {
  for (const bool is_face_on : {true, false}) {
    Session session({.parts = {{Stand, 3}, {Stroke}, {Stand, 3}}, .slower = 3},
                    is_face_on ? face_on_camera() : down_the_line_camera(false));
    session.pipeline.arm();
    session.play();
    ASSERT_EQ(session.swings().size(), 1U) << session.snapshots.back().swing_message;
    const Analysis& analysis = session.swings()[0]->pair.analysis;
    ASSERT_FALSE(analysis.student_events.empty());
    EXPECT_EQ(analysis.student_events.back().name, "finish") << is_face_on;
    EXPECT_GT(analysis.score.percent, 75) << is_face_on;
  }
}

TEST(SwingLoop, as_many_swings_are_shown_as_were_made) {
  for (const bool is_face_on : {true, false}) {
    const PinholeCamera camera = is_face_on ? face_on_camera() : down_the_line_camera(false);
    Session session({.parts = {{Stand, 3},
                               {Stroke},
                               {Walk, 3},
                               {Stand, 1},
                               {Waggle, 2},
                               {Stand, 2},
                               {Stroke},
                               {Stand, 4},
                               {Stroke},
                               {Walk, 2}}},
                    camera);
    session.pipeline.arm();
    session.play();
    EXPECT_EQ(session.swings().size(), 3U) << is_face_on;
  }
}

TEST(SwingLoop, nothing_is_kept_while_it_is_off) {
  Session session({.parts = {{Stand, 3}, {Stroke}, {Stand, 1}}}, face_on_camera());
  session.play();
  EXPECT_EQ(session.states(), std::vector{LoopState::Off});
  EXPECT_TRUE(session.swings().empty());
}

TEST(SwingLoop, who_arms_it_in_the_middle_of_a_swing_is_answered_after_the_next_one) {
  Session session({.parts = {{Walk, 2}, {Stand, 3}, {Stroke}, {Walk, 3}, {Stand, 3}, {Stroke}, {Walk, 4}}},
                  face_on_camera());
  bool is_armed = false;
  for (std::size_t i = 0; i < session.film->count(); ++i) {
    const Frame frame = session.film->frame(i);
    if (!is_armed && frame.time > MediaTime(std::chrono::milliseconds(5600))) {
      session.pipeline.arm();
      is_armed = true;
    }
    session.snapshots.push_back(session.pipeline.step(frame).value());
  }
  using enum LoopState;
  EXPECT_EQ(session.states(), (std::vector{Off, Armed, Ready, Swinging, Analyzing, Replay}));
  ASSERT_EQ(session.swings().size(), 1U);
  const Analysis& analysis = session.swings()[0]->pair.analysis;
  EXPECT_GE(analysis.student_takeaway_s, 1.5);
  EXPECT_FALSE(analysis.student_events.empty());
}

TEST(SwingLoop, a_demonstration_that_plays_again_is_answered_as_if_there_had_been_none_before) {
  // Who has finished stands at his ball a moment later; no golfer does.
  Session session({.parts = {{Stand, 3}, {Stroke}, {Finish, 2}, {Stand, 1.2}, {Stroke}, {Finish, 3}}},
                  face_on_camera());
  session.pipeline.arm();
  const double again_s = session.film->stroke_begin_s[1] - 1.2;
  for (std::size_t i = 0; i < session.film->count(); ++i) {
    const Frame frame = session.film->frame(i);
    if (i > 0 && to_seconds(session.film->times[i - 1]) < again_s && to_seconds(frame.time) >= again_s)
      session.pipeline.start_take();
    session.snapshots.push_back(session.pipeline.step(frame).value());
  }
  ASSERT_EQ(session.swings().size(), 2U);
  for (const auto& swing : session.swings()) {
    EXPECT_EQ(swing->pair.analysis.student_events.size(), 8U);
    EXPECT_GT(swing->pair.analysis.score.percent, 95) << "the coach's own motion";
    EXPECT_LT(swing->pair.analysis.student_takeaway_s, 2.6);
  }
}

TEST(SwingLoop, a_replay_is_dismissed_at_once) {
  Session session({.parts = {{Stand, 3}, {Stroke}, {Walk, 6}}}, face_on_camera());
  session.pipeline.arm();
  bool is_dismissed = false;
  for (std::size_t i = 0; i < session.film->count(); ++i) {
    const CoachSnapshot snapshot = session.pipeline.step(session.film->frame(i)).value();
    if (is_dismissed) {
      EXPECT_NE(snapshot.loop, LoopState::Replay);
    }
    if (snapshot.loop == LoopState::Replay) {
      session.pipeline.dismiss_replay();
      is_dismissed = true;
    }
  }
  EXPECT_TRUE(is_dismissed);
}

TEST(SwingLoop, a_putt_before_a_coach_who_swings_says_what_to_change) {
  Session session({.stroke = "putt", .parts = {{Stand, 3}, {Stroke}, {Stand, 2}}}, face_on_camera());
  session.pipeline.set_coach(bundled_motion("swing").value(), "bundled:swing");
  session.pipeline.arm();
  session.play();
  EXPECT_TRUE(session.swings().empty());
  EXPECT_NE(session.snapshots.back().swing_message.find("choose a coach's motion of the same kind"),
            std::string::npos)
      << session.snapshots.back().swing_message;
}

TEST(SwingLoop, a_left_handers_first_swing_turns_the_ghost_round) {
  Session session({.is_left_handed = true, .parts = {{Stand, 3}, {Stroke}, {Walk, 3}, {Stand, 3}}},
                  face_on_camera());
  session.pipeline.arm();
  session.play();
  ASSERT_EQ(session.swings().size(), 1U) << session.snapshots.back().swing_message;
  EXPECT_EQ(session.swings()[0]->pair.analysis.student.hand, Handedness::Left);
  const CoachSnapshot& last = session.snapshots.back();
  ASSERT_TRUE(last.ghost);
  // The lower hand on the club is the trail hand: the left one now.
  const Skeleton& body = *last.ghost->body.skeleton;
  const auto height = [&](HumanoidJoint joint) {
    return last.ghost->body.positions[static_cast<std::size_t>(body.find(joint))].y;
  };
  EXPECT_LT(height(HumanoidJoint::LeftWrist), height(HumanoidJoint::RightWrist));
}

TEST(SwingLoop, the_ghost_goes_through_the_swing_with_the_golfer) {
  for (const bool is_face_on : {true, false}) {
    Session session({.parts = {{Stand, 4.5}, {Stroke}, {Stand, 0.2}}},
                    is_face_on ? face_on_camera() : down_the_line_camera(false));
    session.play();
    // Student and coach make the same motion: where the film is, the ghost should be.
    const double begin = session.film->stroke_begin_s[0];
    std::vector<double> off_s;
    for (const CoachSnapshot& s : session.snapshots) {
      const double t = to_seconds(s.frame->time) - begin;
      if (t < 0.9 || t > 2.4) continue;
      ASSERT_TRUE(s.ghost);
      off_s.push_back(std::abs(s.ghost->coach_frame / 120.0 - t));
    }
    const CoachSnapshot& finish = *(session.snapshots.end() - 20);
    for (const HumanoidJoint joint :
         {HumanoidJoint::LeftWrist, HumanoidJoint::RightHip, HumanoidJoint::LeftKnee})
      EXPECT_GT(finish.ghost->closeness[static_cast<std::size_t>(joint)], 0.6) << to_string(joint);
    std::sort(off_s.begin(), off_s.end());
    EXPECT_LT(off_s[off_s.size() / 2], 0.06) << is_face_on;
    EXPECT_LT(off_s[off_s.size() * 9 / 10], 0.1) << is_face_on;
  }
}

TEST(SwingLoop, the_ghost_goes_through_a_putt_with_the_golfer) {
  for (const bool is_left_handed : {false, true}) {
    Session session(
        {.stroke = "putt", .is_left_handed = is_left_handed, .parts = {{Stand, 4.5}, {Stroke}, {Stand, 0.2}}},
        face_on_camera());
    session.pipeline.set_person({.hand = is_left_handed ? Handedness::Left : Handedness::Right});
    session.play();
    const AuthoredMotion putt = bundled_authored_motion("putt").value();
    std::vector<double> off_s;
    for (const CoachSnapshot& s : session.snapshots) {
      const double t = to_seconds(s.frame->time) - session.film->stroke_begin_s[0];
      if (t < putt.time_of("takeaway") || t > putt.time_of("end")) continue;
      ASSERT_TRUE(s.ghost);
      off_s.push_back(std::abs(s.ghost->coach_frame / 120.0 - t));
    }
    std::sort(off_s.begin(), off_s.end());
    EXPECT_LT(off_s[off_s.size() / 2], 0.1) << is_left_handed;
    EXPECT_LT(off_s[off_s.size() * 9 / 10], 0.3) << is_left_handed;
  }
}

TEST(SwingLoop, a_left_hander_is_coached_as_one_all_the_way) {
  for (const bool is_face_on : {true, false}) {
    Session session({.is_left_handed = true, .parts = {{Walk, 2}, {Stand, 4}, {Stroke}, {Walk, 3}}},
                    is_face_on ? face_on_camera() : down_the_line_camera(true));
    session.pipeline.set_person({.hand = Handedness::Left});
    session.pipeline.arm();
    session.play();
    ASSERT_EQ(session.swings().size(), 1U) << is_face_on << session.snapshots.back().swing_message;
    const Analysis& analysis = session.swings()[0]->pair.analysis;
    EXPECT_EQ(analysis.student.hand, Handedness::Left);
    EXPECT_GT(analysis.score.percent, 80) << is_face_on;
    // The ghost plays from the left before the first swing already, and stands as the golfer does.
    const auto before = std::find_if(session.snapshots.begin(), session.snapshots.end(),
                                     [](const CoachSnapshot& s) { return s.loop == LoopState::Swinging; });
    ASSERT_TRUE(before != session.snapshots.end() && before->ghost);
    const Skeleton& body = *before->ghost->body.skeleton;
    const auto height = [&](HumanoidJoint joint) {
      return before->ghost->body.positions[static_cast<std::size_t>(body.find(joint))].y;
    };
    EXPECT_LT(height(HumanoidJoint::LeftWrist), height(HumanoidJoint::RightWrist)) << is_face_on;
  }
}

TEST(SwingMemory, forgets_the_oldest_and_stays_within_its_bounds) {
  InlineWork work;
  SwingMemory memory(work, {.seconds = 1, .most_bytes = 1'000'000});
  const auto picture = std::make_shared<const Image>(Image::black(64, 36));
  for (std::size_t i = 0; i < 300; ++i) {
    const MediaTime time = media_time_from_seconds(static_cast<double>(i) / 30);
    memory.add({i, time, {}, picture}, {i, time, {}});
    EXPECT_LE(memory.seconds_held(), 1.0);
  }
  EXPECT_GT(memory.seconds_held(), 0.9);
  EXPECT_LT(memory.bytes_held(), 31 * 2000U) << "compressed";
  const SwingMemory::Cut cut =
      memory.cut(media_time_from_seconds(9.5), media_time_from_seconds(9.8), "camera");
  EXPECT_EQ(cut.track.frames.size(), 10U);
  EXPECT_EQ(cut.track.frames.front().time, MediaTime{});
  EXPECT_EQ(cut.pictures->count(), 10U);
}

TEST(SwingMemory, a_picture_not_yet_compressed_is_there_all_the_same) {
  const auto picture = std::make_shared<const Image>(Image::black(64, 36));
  StoredPicture stored(picture);
  EXPECT_EQ(*stored.picture(), picture);
  stored.compress();
  const auto decoded = stored.picture();
  ASSERT_TRUE(decoded);
  EXPECT_EQ((*decoded)->width, 64);
  EXPECT_LT(stored.bytes(), picture->rgb.size());
}

}  // namespace
}  // namespace posecoach
