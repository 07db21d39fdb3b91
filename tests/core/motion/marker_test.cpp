#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "core/motion/marker_sets.h"
#include "core/motion/marker_track.h"
#include "core/motion/trc.h"
#include "marker_samples.h"

namespace posecoach {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using enum HumanoidJoint;

const Vec3& at(const Motion& motion, int frame, HumanoidJoint role) {
  return motion.position(frame, motion.skeleton().find(role));
}

class JointLabels : public testing::TestWithParam<std::vector<samples::LabelledJoint>> {};

TEST_P(JointLabels, make_the_body_that_wore_them) {
  const Motion person = samples::moving_person(60);
  const Motion motion = motion_from_markers("a", samples::markers_of(person, GetParam())).value();
  for (const auto& [label, role] : GetParam()) {
    ASSERT_TRUE(motion.skeleton().has(role)) << label;
    for (int f = 0; f < 60; ++f) EXPECT_LT(glm::distance(at(motion, f, role), at(person, f, role)), 1e-12);
  }
  const Vec3 hips = (at(person, 7, LeftHip) + at(person, 7, RightHip)) / 2.0;
  if (GetParam().front().label == "left_shoulder") {
    EXPECT_LT(glm::distance(at(motion, 7, Pelvis), hips), 1e-12);
  }
  EXPECT_NEAR(motion.skeleton().leg_length(), person.skeleton().leg_length(), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(All, JointLabels,
                         testing::Values(samples::blazepose_labels(), samples::openpose_labels()));

TEST(Markers, any_unit_and_any_axis_up_makes_the_same_body) {
  const Motion person = samples::moving_person(30);
  const Motion expected =
      motion_from_markers("a", samples::markers_of(person, samples::blazepose_labels())).value();
  MarkerTrack track = samples::markers_of(person, samples::blazepose_labels());
  for (Vec3& p : track.positions) p = Vec3(p.x, -p.z, p.y) * 1000.0;  // millimetres, +Z up
  for (const double said : {0.0, 0.001, 1.0}) {                       // nothing, the truth, nonsense
    track.metres_per_unit = said;
    const Motion motion = motion_from_markers("a", track).value();
    for (int f = 0; f < 30; ++f)
      for (int j = 0; j < motion.joint_count(); ++j)
        EXPECT_LT(glm::distance(motion.position(f, j), expected.position(f, j)), 1e-9);
  }
}

TEST(Markers, what_is_not_seen_has_confidence_zero_and_a_sensible_place) {
  const Motion person = samples::moving_person(80);
  MarkerTrack track = samples::markers_of(person, samples::openpose_labels());
  const std::size_t elbow = 2;
  for (std::size_t f = 20; f < 50; ++f) {
    track.seen[track.at(f, elbow)] = 0;
    track.positions[track.at(f, elbow)] = Vec3(0);
  }
  const Motion motion = motion_from_markers("a", track).value();
  const int joint = motion.skeleton().find(RightElbow);
  EXPECT_EQ(motion.confidence(19, joint), 1);
  EXPECT_EQ(motion.confidence(20, joint), 0);
  for (int f = 20; f < 50; ++f) {
    const double straight = (f - 19) / 31.0;
    const Vec3 line = at(person, 19, RightElbow) * (1 - straight) + at(person, 50, RightElbow) * straight;
    EXPECT_LT(glm::distance(motion.position(f, joint), at(person, f, RightElbow)),
              0.05 + 0.5 * glm::distance(line, at(person, f, RightElbow)));
  }
}

TEST(Markers, a_hidden_marker_on_a_rigid_part_is_found_exactly) {
  const Motion person = samples::moving_person(60);
  // Pelvis, hips: rigid, with a fourth point on it.
  MarkerTrack track = samples::markers_of(
      person, {{"a", Pelvis}, {"b", LeftHip}, {"c", RightHip}, {"d", Spine}, {"e", LeftKnee}});
  std::vector<Vec3> truth;
  for (std::size_t f = 10; f < 60; ++f) {
    truth.push_back(track.positions[track.at(f, 3)]);
    track.seen[track.at(f, 3)] = 0;
    track.positions[track.at(f, 3)] = Vec3(0);
  }
  fill_gaps(track, {3});
  for (std::size_t f = 10; f < 60; ++f)
    EXPECT_LT(glm::distance(track.positions[track.at(f, 3)], truth[f - 10]), 1e-9);
  EXPECT_EQ(track.seen[track.at(30, 3)], 0);
}

TEST(Markers, plug_in_gait_hips_lie_inside_the_pelvis_by_the_formula) {
  const std::vector<std::string> labels = {"Sub:LASI", "Sub:RASI", "Sub:LPSI", "Sub:RPSI", "Sub:LSHO",
                                           "Sub:RSHO", "Sub:LELB", "Sub:RELB", "Sub:LWRA", "Sub:LWRB",
                                           "Sub:RWRA", "Sub:RWRB", "Sub:LKNE", "Sub:RKNE", "Sub:LANK",
                                           "Sub:RANK", "Sub:LTOE", "Sub:RTOE", "Sub:C7",   "Sub:CLAV"};
  const std::vector<Vec3> places = {
      {0.12, 1, 0.1},     {-0.12, 1, 0.1},     {0.05, 1, -0.08},   {-0.05, 1, -0.08}, {0.2, 1.45, 0},
      {-0.2, 1.45, 0},    {0.25, 1.15, 0},     {-0.25, 1.15, 0},   {0.25, 0.9, 0.03}, {0.25, 0.9, -0.03},
      {-0.25, 0.9, 0.03}, {-0.25, 0.9, -0.03}, {0.1, 0.5, 0},      {-0.1, 0.5, 0},    {0.1, 0.1, 0},
      {-0.1, 0.1, 0},     {0.1, 0.02, 0.15},   {-0.1, 0.02, 0.15}, {0, 1.5, -0.06},   {0, 1.42, 0.08}};
  MarkerTrack track{labels, {MediaTime{}}, places, std::vector<char>(labels.size(), 1), 1};
  const Motion motion = motion_from_markers("a.c3d", track).value();
  EXPECT_LT(glm::distance(at(motion, 0, LeftHip), {0.36 * 0.24, 1 - 0.30 * 0.24, 0.1 - 0.19 * 0.24}), 1e-9);
  EXPECT_LT(glm::distance(at(motion, 0, RightHip), {-0.36 * 0.24, 1 - 0.30 * 0.24, 0.1 - 0.19 * 0.24}), 1e-9);
  EXPECT_LT(glm::distance(at(motion, 0, LeftWrist), {0.25, 0.9, 0}), 1e-12);
  EXPECT_LT(glm::distance(at(motion, 0, Neck), {0, 1.46, 0.01}), 1e-12);
}

TEST(Markers, labels_that_make_no_body_are_listed) {
  const MarkerTrack track{{"club_1", "ball"}, {MediaTime{}}, {{1, 1, 1}, {2, 2, 2}}, {1, 1}, 1};
  const auto motion = motion_from_markers("a.c3d", track);
  ASSERT_FALSE(motion);
  EXPECT_EQ(motion.error().code, ErrorCode::Incomplete);
  EXPECT_THAT(motion.error().message, HasSubstr("a.c3d: the markers do not make a body"));
  EXPECT_THAT(motion.error().message, HasSubstr("club_1, ball"));
}

TEST(Markers, of_many_labels_that_make_no_body_the_first_ones_are_listed_and_the_others_counted) {
  std::vector<std::string> labels;
  for (int m = 0; m < 60; ++m) labels.push_back("marker" + std::to_string(m));
  const MarkerTrack track{labels, {MediaTime{}}, std::vector<Vec3>(60), std::vector<char>(60, 1), 1};
  const auto motion = motion_from_markers("a.c3d", track);
  ASSERT_FALSE(motion);
  EXPECT_THAT(motion.error().message, HasSubstr("marker0, marker1"));
  EXPECT_THAT(motion.error().message, HasSubstr("marker7 and 52 more"));
  EXPECT_LT(motion.error().message.size(), 200U);
}

TEST(Trc, a_motion_reads_back_with_names_times_and_gaps) {
  const Motion person = samples::moving_person(20);
  std::vector<Vec3> positions;
  std::vector<double> confidence;
  for (int f = 0; f < 20; ++f)
    for (int j = 0; j < person.joint_count(); ++j) {
      positions.push_back(person.position(f, j));
      confidence.push_back(f == 3 && person.skeleton().joint(j).role == LeftToe ? 0 : 1);
    }
  const Motion motion =
      Motion::from_positions(person.skeleton(), {person.times().begin(), person.times().end()}, positions,
                             confidence)
          .value();
  const auto track = read_trc("a.trc", trc_from_motion("a.trc", motion));
  ASSERT_TRUE(track) << track.error().message;
  EXPECT_EQ(track->labels.size(), 25u);
  EXPECT_EQ(track->metres_per_unit, 1);
  const Motion again = motion_from_markers("a.trc", *track).value();
  EXPECT_EQ(again.time(19), motion.time(19));
  for (int f = 0; f < 20; ++f)
    for (int j = 0; j < motion.joint_count(); ++j) {
      const HumanoidJoint role = motion.skeleton().joint(j).role.value();
      ASSERT_TRUE(again.skeleton().has(role)) << to_string(role);
      const int other = again.skeleton().find(role);
      EXPECT_EQ(again.confidence(f, other), motion.confidence(f, j));
      if (motion.confidence(f, j) > 0) {
        EXPECT_LT(glm::distance(again.position(f, other), motion.position(f, j)), 1e-6);
      }
    }
}

constexpr std::string_view kTrc =
    "PathFileType\t4\t(X/Y/Z)\ta.trc\n"
    "DataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\tOrigDataRate\tOrigDataStartFrame\tOrigNumFrames\n"
    "50\t50\t2\t2\tmm\t50\t1\t2\n"
    "Frame#\tTime\tone\t\t\ttwo\t\t\n"
    "\t\tX1\tY1\tZ1\tX2\tY2\tZ2\n"
    "\n"
    "1\t0.00\t1\t2\t3\t4\t5\t6\n"
    "2\t0.02\t\t\t\t4\t5\t7\n";

std::string with(std::string_view old_part, std::string_view new_part) {
  std::string text(kTrc);
  const std::size_t where = text.find(old_part);
  EXPECT_NE(where, std::string::npos) << old_part;
  return text.replace(where, old_part.size(), new_part);
}

TEST(Trc, an_empty_cell_is_a_hidden_marker_not_zero) {
  const MarkerTrack track = read_trc("a.trc", kTrc).value();
  EXPECT_EQ(track.labels, (std::vector<std::string>{"one", "two"}));
  EXPECT_EQ(track.metres_per_unit, 0.001);
  EXPECT_EQ(track.seen, (std::vector<char>{1, 1, 0, 1}));
  EXPECT_EQ(track.positions[3], Vec3(4, 5, 7));
}

TEST(Trc, carriage_returns_and_rows_cut_short_are_fine) {
  std::string text;
  for (const char c : with("4\t5\t7", "")) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(read_trc("a.trc", text)->seen, (std::vector<char>{1, 1, 0, 0}));
}

TEST(Trc, every_mistake_is_one_line_that_names_file_and_line) {
  const auto expect_bad = [](const std::string& text, const std::string& start, const std::string& what) {
    const auto read = read_trc("a.trc", text);
    ASSERT_FALSE(read) << what;
    EXPECT_EQ(read.error().code, ErrorCode::Malformed);
    EXPECT_THAT(read.error().message, StartsWith("a.trc:" + start));
    EXPECT_THAT(read.error().message, HasSubstr(what));
  };
  expect_bad("", "0: ", "not a TRC file");
  expect_bad("hello\n", "1: ", "not a TRC file");
  expect_bad(with("\t2\t2\tmm", "\t2\ttwo\tmm"), "3: ", "NumMarkers needs a count, found \"two\"");
  expect_bad(with("\t2\t2\tmm", "\t2\t3\tmm"), "4: ", "there are 2 marker names, NumMarkers is 3");
  expect_bad(with("\t2\t2\tmm", "\t9\t2\tmm"), "8: ", "with 2 of 9 frames");
  expect_bad(with("\t3\t4", "\tx\t4"), "7: ", "\"x\" in cell 5 is not a usable number");
  expect_bad(with("\t3\t4", "\t\t4"), "7: ", "\"one\" has only some of its coordinates");
  expect_bad(with("0.02", "0.00"), "8: ", "time does not increase");
  expect_bad(with("0.02", "soon"), "8: ", "no time in seconds");
  expect_bad(with("\t5\t7", "\t5\t7\t8"), "8: ", "more than 8 cells");
}

}  // namespace
}  // namespace posecoach
