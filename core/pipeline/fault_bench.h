// How well coaching names known faults: authored strokes with one fault, or none, on many bodies, through the
// true joints or through a camera, judged as any student's, and compared with what was put in.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/body/standard_body.h"
#include "core/motion/authored/authored_motion.h"
#include "core/motion/authored/golf_fault.h"
#include "core/pipeline/analyze.h"

namespace posecoach {

// By which way a stroke reaches the coach.
enum class BenchEye { TrueJoints, FaceOn, DownTheLine };
std::string_view to_string(BenchEye eye);  // "joints", "face-on", "down-the-line"

struct BenchBody {
  std::string name;
  BodyProportions proportions;
};
// The named bodies, and the extremes: 1.50 to 2.00 m, limbs a quarter longer or shorter.
std::vector<BenchBody> bench_bodies();

struct BenchCase {
  std::string motion;                // "swing" or "putt"
  const GolfFault* fault = nullptr;  // none: a faultless stroke
  double amount = 0;
  BenchBody body;
  Handedness hand = Handedness::Right;
  double frames_per_second = 30;
  BenchEye eye = BenchEye::TrueJoints;
  double camera_turned_deg = 0;  // how far the camera stands beside its place
};
// "swing-sway_10-tall-right-30fps-face-on", "...-face-on+20": fit for a file's name.
std::string name_of(const BenchCase& one);

// The stroke of a case. Errors: those of make_authored_motion.
Result<AuthoredMotion> make_stroke_of(const BenchCase& one);

struct BenchPlan {
  std::vector<BenchEye> eyes = {BenchEye::TrueJoints};
  std::vector<double> frame_rates = {30};
  std::vector<double> parts = {0.75, 1, 1.5};  // of each fault's usual amount, at most its largest
  std::vector<std::string> bodies = {};        // empty: all bench bodies
  std::vector<std::string> faults = {};        // empty: all; faultless strokes come always
  std::vector<double> camera_turns_deg = {0};  // of films
};
// Every fault in every part on every body, hands in turn; and every faultless stroke with both hands. Errors:
// InvalidArgument (a body or fault of no such name).
Result<std::vector<BenchCase>> make_bench_cases(const BenchPlan& plan);

struct BenchAnswer {
  BenchCase asked;
  std::string refusal;  // why there is no analysis; empty where there is one
  double percent = 0;   // score
  std::vector<Advice> advice;
  int rank = 0;  // of the advice that names the fault: 1 is first; 0 nowhere
  // Of the measure that this advice tells, as told and as it truly is.
  double amount_told = 0, amount_true = 0;
  double plus_minus = 0;  // of the score
  std::vector<Metric> metrics = {};
  // In the order of time, takeaway first; seconds after the truth. Empty where the stroke was not divided.
  std::vector<std::pair<std::string, double>> events_late = {};
  StageGaps stage_gaps = {};

  bool is_amount_right() const;  // within a quarter
};

// `student` is what an eye saw of the case.
Result<BenchAnswer> judge(const BenchCase& one, const StudentInput& student, const Motion& coach);

// One line of the table.
struct BenchRow {
  BenchEye eye = BenchEye::TrueJoints;
  std::string motion, fault;  // fault empty: faultless strokes
  int cases = 0, refused = 0;
  int first = 0, top_three = 0;  // of faults
  int amount_right = 0;          // of those among the first three
  int false_alarms = 0;          // of faultless strokes: any advice at all
  double percent_mean = 0, percent_least = 100;
};
std::vector<BenchRow> tally(const std::vector<BenchAnswer>& answers);

// Whether the same stroke, seen at several frame rates, is told the same.
struct BenchAgreement {
  BenchEye eye = BenchEye::TrueJoints;
  std::string motion;
  int pairs = 0;           // of two frame rates: the slowest and each other
  int same_first = 0;      // the first advice names the same fault or measure, or neither has any
  int scores_within = 0;   // no farther apart than both plus-minuses
  int metrics = 0;         // that both can tell
  int metrics_within = 0;  // no farther apart than both plus-minuses
};
std::vector<BenchAgreement> agreement_of_frame_rates(const std::vector<BenchAnswer>& answers);

// `see` is the eye; `coach_of` the coach of a case. Errors: those of both, and Cancelled; a stroke that
// cannot be analysed is an answer.
using BenchEyeFunction = std::function<Result<StudentInput>(const BenchCase&)>;
using BenchCoachFunction = std::function<Result<Motion>(const BenchCase&)>;
Result<std::vector<BenchAnswer>> run_fault_bench(const std::vector<BenchCase>& cases,
                                                 const BenchEyeFunction& see,
                                                 const BenchCoachFunction& coach_of,
                                                 const Progress& progress = {});

// The bundled stroke on its own body.
Result<Motion> bundled_coach(const BenchCase& one);

// The eye of motion capture.
Result<StudentInput> see_true_joints(const BenchCase& one);

}  // namespace posecoach
