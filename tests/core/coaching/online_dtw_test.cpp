#include "core/coaching/online_dtw.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/coaching/follow_along.h"
#include "core/coaching/swing_events.h"
#include "tests/core/coaching/strokes.h"

namespace posecoach {
namespace {

constexpr int kLookAhead = 6;
constexpr double kRate = 120;

// The stroke from address to its end, as poses over the pelvis; `time_of` says when each pose is taken.
PoseSequence poses_at(const Motion& motion, const std::vector<double>& times_s, double tremble_m = 0) {
  const JointTrack track = JointTrack::from_motion(motion).value().at(times_s);
  std::mt19937 random(5);
  std::normal_distribution<double> normal(0, tremble_m);
  PoseSequence poses(track.frame_count(), static_cast<int>(track.joints().size()));
  for (int f = 0; f < track.frame_count(); ++f)
    for (std::size_t k = 0; k < track.joints().size(); ++k) {
      Vec3 p = track.position(f, track.joints()[k]) - track.position(f, HumanoidJoint::Pelvis);
      if (tremble_m > 0) p += Vec3(normal(random), normal(random), normal(random));
      poses.set(f, static_cast<int>(k), static_cast<float>(p.x), static_cast<float>(p.y),
                static_cast<float>(p.z));
    }
  return poses;
}

PoseSequence one_pose(const PoseSequence& poses, int frame) {
  PoseSequence pose(1, poses.joints());
  const auto f = static_cast<std::size_t>(frame);
  for (int k = 0; k < poses.joints(); ++k) pose.set(0, k, poses.x(k)[f], poses.y(k)[f], poses.z(k)[f]);
  return pose;
}

std::vector<int> follow(OnlineWarp& warp, const PoseSequence& student) {
  std::vector<int> positions;
  for (int f = 0; f < student.frames(); ++f) positions.push_back(warp.step(one_pose(student, f)));
  return positions;
}

struct Stroke {
  Motion motion;
  double begin_s = 0, end_s = 0;
  std::vector<double> regular() const {
    std::vector<double> times;
    for (double t = begin_s; t <= end_s; t += 1 / kRate) times.push_back(t);
    return times;
  }
};

Stroke stroke(std::string_view name) {
  const AuthoredMotion made = make_stroke({.name = name});
  const auto events = find_swing_events(JointTrack::from_motion(made.motion).value()).value();
  return {made.motion, events.events.front().time_s, events.events.back().time_s};
}

// Where the offline path says that the student is, for each of his poses: the middle of what it pairs.
std::vector<double> offline_positions(const PoseSequence& student, const PoseSequence& coach) {
  std::vector<double> sum(static_cast<std::size_t>(student.frames())), count(sum.size());
  for (const auto& [i, j] : warp(student, coach).path) {
    sum[static_cast<std::size_t>(i)] += j;
    count[static_cast<std::size_t>(i)] += 1;
  }
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] /= count[i];
  return sum;
}

TEST(OnlineWarp, ones_own_motion_is_followed_frame_by_frame) {
  for (const std::string_view name : {"swing", "putt"}) {
    const Stroke own = stroke(name);
    const PoseSequence poses = poses_at(own.motion, own.regular());
    OnlineWarp warp(poses, kLookAhead);
    const std::vector<int> positions = follow(warp, poses);
    for (int f = 0; f < poses.frames(); ++f)
      EXPECT_NEAR(positions[static_cast<std::size_t>(f)], f, 1) << name;
  }
}

TEST(OnlineWarp, a_time_warped_motion_gives_the_warp) {
  const Stroke own = stroke("swing");
  const PoseSequence coach = poses_at(own.motion, own.regular());
  const double length = own.end_s - own.begin_s;
  for (const double pace : {0.4, 0.7, 1.6, 2.5}) {
    std::vector<double> times;
    // Slower at first, quicker later, or the other way round: never a mere factor.
    for (int f = 0;; ++f) {
      const double x = f / kRate * pace / length;
      if (x >= 1) break;
      times.push_back(own.begin_s + length * (x + 0.12 * std::sin(2 * kPi * x)));
    }
    const PoseSequence student = poses_at(own.motion, times);
    OnlineWarp warp(coach, kLookAhead);
    const std::vector<int> positions = follow(warp, student);
    double worst = 0, sum = 0;
    for (std::size_t f = 0; f < positions.size(); ++f) {
      const double off_s = std::abs(positions[f] / kRate - (times[f] - own.begin_s));
      worst = std::max(worst, off_s);
      sum += off_s / static_cast<double>(positions.size());
    }
    EXPECT_LT(sum, 0.04) << pace;
    EXPECT_LT(worst, 0.25) << pace;
  }
}

TEST(OnlineWarp, waits_where_the_student_waits) {
  const Stroke own = stroke("swing");
  const PoseSequence coach = poses_at(own.motion, own.regular());
  for (const double part : {0.2, 0.45, 0.8}) {
    OnlineWarp warp(coach, kLookAhead);
    const int at = static_cast<int>(part * coach.frames());
    for (int f = 0; f <= at; ++f) warp.step(one_pose(coach, f));
    const int there = warp.position();
    for (int k = 0; k < 600; ++k) EXPECT_EQ(warp.step(one_pose(coach, at)), there);
    for (int f = at; f < coach.frames(); ++f) warp.step(one_pose(coach, f));
    EXPECT_EQ(warp.position(), coach.frames() - 1) << "and goes on with him";
  }
}

TEST(OnlineWarp, never_goes_back_and_never_jumps_however_the_student_trembles) {
  const Stroke own = stroke("swing");
  const PoseSequence coach = poses_at(own.motion, own.regular());
  const PoseSequence student = poses_at(own.motion, own.regular(), 0.05);
  OnlineWarp warp(coach, kLookAhead);
  int last = 0;
  for (const int position : follow(warp, student)) {
    EXPECT_GE(position, last);
    EXPECT_LE(position, last + kLookAhead);
    last = position;
  }
}

TEST(OnlineWarp, agrees_with_the_offline_path) {
  for (const std::string_view name : {"swing", "putt"}) {
    const Stroke own = stroke(name);
    const PoseSequence coach = poses_at(own.motion, own.regular());
    const double length = own.end_s - own.begin_s;
    std::vector<double> times;
    for (int f = 0; f / kRate * 0.8 < length; ++f) {
      const double x = f / kRate * 0.8 / length;
      times.push_back(own.begin_s + length * (x + 0.08 * std::sin(4 * kPi * x)));
    }
    const PoseSequence student = poses_at(own.motion, times, 0.01);
    OnlineWarp warp(coach, kLookAhead);
    const std::vector<int> online = follow(warp, student);
    const std::vector<double> offline = offline_positions(student, coach);
    std::vector<double> apart_s;
    for (std::size_t f = 0; f < online.size(); ++f)
      apart_s.push_back(std::abs(online[f] - offline[f]) / kRate);
    std::sort(apart_s.begin(), apart_s.end());
    EXPECT_LT(apart_s[apart_s.size() / 2], 0.03) << name;
    EXPECT_LT(apart_s[apart_s.size() * 95 / 100], 0.20) << name;
  }
}

TEST(OnlineWarp, starts_again_after_a_reset) {
  const Stroke own = stroke("putt");
  const PoseSequence coach = poses_at(own.motion, own.regular());
  OnlineWarp warp(coach, kLookAhead);
  const std::vector<int> first = follow(warp, coach);
  warp.reset();
  EXPECT_EQ(warp.position(), 0);
  EXPECT_EQ(follow(warp, coach), first);
}

JointMoment moment_of(const JointTrack& track, double time_s) {
  const JointTrack one = track.at({time_s});
  JointMoment moment;
  for (const HumanoidJoint joint : one.joints()) moment.set(joint, one.position(0, joint), 1);
  return moment;
}

struct Following {
  Stroke own = stroke("swing");
  JointTrack track = JointTrack::from_motion(own.motion).value();
  FollowAlong follow{track, {own.begin_s, own.end_s}};
  double clock_s = 0;
  double coach_s = 0;
  double size = 1;  // as he is measured

  // `seconds` at 30 fps, the body at a time of the stroke.
  void play(double seconds, const std::function<double(double)>& stroke_time) {
    for (double t = 0; t < seconds; t += 1 / 30.0) {
      clock_s += 1 / 30.0;
      JointMoment moment = moment_of(track, stroke_time(t));
      for (Vec3& position : moment.positions) position *= size;
      coach_s = follow.step(media_time_from_seconds(clock_s), moment, 0, {});
    }
  }
  void stand(double seconds) {
    play(seconds, [&](double) { return own.begin_s; });
  }
};

TEST(FollowAlong, waits_at_address_and_goes_at_the_students_pace) {
  Following f;
  f.stand(1.5);
  EXPECT_NEAR(f.coach_s, f.own.begin_s, 0.02);
  const double length = f.own.end_s - f.own.begin_s;
  f.play(length / 0.5, [&](double t) { return f.own.begin_s + 0.5 * t; });
  EXPECT_NEAR(f.coach_s, f.own.end_s, 0.15);
}

TEST(FollowAlong, starts_over_when_the_student_is_back_at_address) {
  Following f;
  f.stand(1);
  f.play(f.own.end_s - f.own.begin_s, [&](double t) { return f.own.begin_s + t; });
  EXPECT_GT(f.coach_s, f.own.end_s - 0.3);
  f.stand(1.5);
  EXPECT_NEAR(f.coach_s, f.own.begin_s, 0.02);
}

TEST(FollowAlong, starts_over_though_the_student_stands_briefly_and_is_measured_anew) {
  Following f;
  f.stand(1);
  const double length = f.own.end_s - f.own.begin_s;
  f.play(length, [&](double t) { return f.own.begin_s + t; });
  f.play(1, [&](double) { return f.own.end_s; });
  f.size = 1.05;
  f.stand(0.6);
  EXPECT_NEAR(f.coach_s, f.own.begin_s, 0.02);
  f.play(0.5 * length, [&](double t) { return f.own.begin_s + t; });
  EXPECT_NEAR(f.coach_s, f.own.begin_s + 0.5 * length, 0.15);
}

TEST(FollowAlong, a_pause_at_the_top_is_no_new_beginning) {
  Following f;
  f.stand(1);
  const double half = 0.4 * (f.own.end_s - f.own.begin_s);
  f.play(half, [&](double t) { return f.own.begin_s + t; });
  const double before = f.coach_s;
  f.play(4, [&](double) { return f.own.begin_s + half; });
  EXPECT_NEAR(f.coach_s, before, 0.1);
  f.play(half, [&](double t) { return f.own.begin_s + half + t; });
  EXPECT_NEAR(f.coach_s, f.own.begin_s + 2 * half, 0.1);
}

// A putt as a camera behind the golfer shows it: his hands tremble where they are, all joints do, and of the
// shoulder line's turn there is a part.
struct PuttFromBehind {
  Stroke own = stroke("putt");
  JointTrack track = JointTrack::from_motion(own.motion).value();
  FollowAlong follow{track, {own.begin_s, own.end_s}};
  double shown = 0.4;
  double clock_s = 0, coach_s = 0;
  std::vector<double> off_s;
  std::mt19937 random{9};
  std::normal_distribution<double> tremble{0, 0.0008};

  void step(double stroke_s, double aside_m = 0) {
    clock_s += 1 / 30.0;
    JointMoment moment = moment_of(track, stroke_s);
    const JointMoment rest = moment_of(track, own.begin_s);
    for (const HumanoidJoint joint : {HumanoidJoint::LeftShoulder, HumanoidJoint::RightShoulder}) {
      Vec3& place = moment.positions[static_cast<std::size_t>(joint)];
      place = glm::mix(rest.at(joint), place, shown);
    }
    for (const HumanoidJoint joint : {HumanoidJoint::LeftWrist, HumanoidJoint::RightWrist})
      moment.positions[static_cast<std::size_t>(joint)] = rest.at(joint);
    for (Vec3& place : moment.positions)
      place += Vec3(tremble(random), tremble(random), tremble(random) + aside_m);
    coach_s = follow.step(media_time_from_seconds(clock_s), moment, 0, {Vec3(1, 0, 0)});
    off_s.push_back(std::abs(coach_s - stroke_s));
  }
  void stand(double seconds, double stroke_s) {
    for (double t = 0; t < seconds; t += 1 / 30.0) step(stroke_s);
  }
  // From one time of the stroke to another, `pace` times as fast as the coach.
  void play(double from_s, double to_s, double pace = 1) {
    for (double t = 0; t < (to_s - from_s) / pace; t += 1 / 30.0) step(from_s + pace * t);
  }
  double median_off_s() {
    std::nth_element(off_s.begin(), off_s.begin() + static_cast<std::ptrdiff_t>(off_s.size() / 2),
                     off_s.end());
    return off_s[off_s.size() / 2];
  }
};

TEST(FollowAlong, goes_with_a_putt_from_behind_however_much_of_it_is_shown) {
  for (const double shown : {0.35, 1.0})
    for (const double pace : {0.75, 1.0, 1.25}) {
      PuttFromBehind f;
      f.shown = shown;
      f.stand(3, f.own.begin_s);
      EXPECT_NEAR(f.coach_s, f.own.begin_s, 0.02) << shown << " " << pace;
      f.off_s.clear();
      f.play(f.own.begin_s, f.own.end_s, pace);
      EXPECT_LT(f.median_off_s(), 0.2) << shown << " " << pace;
      EXPECT_NEAR(f.coach_s, f.own.end_s, 0.3) << shown << " " << pace;
    }
}

TEST(FollowAlong, waits_at_the_top_of_a_putt_from_behind_and_holds_its_end) {
  PuttFromBehind f;
  const double top_s = 1.34;
  f.stand(2, f.own.begin_s);
  f.play(f.own.begin_s, top_s);
  f.stand(3, top_s);
  EXPECT_NEAR(f.coach_s, top_s, 0.25);
  f.play(top_s, f.own.end_s);
  f.stand(4, f.own.end_s);
  EXPECT_NEAR(f.coach_s, f.own.end_s, 0.3);
}

TEST(FollowAlong, starts_over_with_who_steps_up_to_another_putt_from_behind) {
  PuttFromBehind f;
  f.stand(2, f.own.begin_s);
  f.play(f.own.begin_s, f.own.end_s);
  f.stand(1, f.own.end_s);
  for (int i = 1; i <= 45; ++i) f.step(f.own.end_s, i / 60.0);
  for (int i = 45; i > 0; --i) f.step(f.own.begin_s, i / 60.0);
  f.stand(2, f.own.begin_s);
  EXPECT_NEAR(f.coach_s, f.own.begin_s, 0.02);
  f.off_s.clear();
  f.play(f.own.begin_s, f.own.end_s);
  EXPECT_LT(f.median_off_s(), 0.2);
}

TEST(FollowAlong, starts_over_when_the_shoulders_are_back_at_address) {
  PuttFromBehind f;
  f.stand(2, f.own.begin_s);
  f.play(f.own.begin_s, f.own.end_s);
  f.stand(2, f.own.begin_s);
  EXPECT_NEAR(f.coach_s, f.own.begin_s, 0.02);
}

}  // namespace
}  // namespace posecoach
