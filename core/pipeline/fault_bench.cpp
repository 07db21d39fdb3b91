#include "core/pipeline/fault_bench.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "core/base/assert.h"
#include "core/coaching/part_differences.h"
#include "core/motion/bundled_motion.h"

namespace posecoach {
namespace {

constexpr double kTruthRate = 240;
constexpr double kAmountTolerance = 0.25;

// A stroke as right-hander, finely sampled: what the body really did.
struct Truth {
  JointTrack track;
  AuthoredMotion stroke;
};

Result<Truth> truth_of(BenchCase one) {
  one.hand = Handedness::Right;
  one.frames_per_second = kTruthRate;
  Result<AuthoredMotion> stroke = make_stroke_of(one);
  if (!stroke) return tl::unexpected(stroke.error());
  Result<JointTrack> track = JointTrack::from_motion(stroke->motion);
  if (!track) return tl::unexpected(track.error());
  return Truth{*std::move(track), *std::move(stroke)};
}

double phase_ratio(const Truth& faulty, const Truth& faultless, const Advice& advice) {
  const char* from = advice.measure == "backswing"        ? "takeaway"
                     : advice.measure == "follow-through" ? "impact"
                                                          : "top";
  const auto duration = [&](const Truth& truth) {
    return truth.stroke.time_of(advice.event) - truth.stroke.time_of(from);
  };
  return duration(faulty) / duration(faultless);
}

// What the told measure is between this body's faulty and faultless stroke, at the same event.
double true_amount(const Truth& faulty, const Truth& faultless, const Advice& advice, const BenchCase& one) {
  if (advice.kind == AdviceKind::Timing) return phase_ratio(faulty, faultless, advice) - 1;
  const bool is_after_impact =
      advice.event == "mid_follow_through" || advice.event == "finish" || advice.event == "end";
  const double takeaway = faultless.stroke.time_of("takeaway");
  const BodyAxes axes = body_axes(faultless.track, std::max(0.0, takeaway - 0.2), takeaway);
  const auto differences =
      part_differences(moment_of(faulty.track, faulty.stroke.time_of(advice.event)),
                       moment_of(faultless.track, faultless.stroke.time_of(advice.event)), axes,
                       {is_after_impact ? Anchor::LeadFoot : Anchor::BothFeet,
                        one.motion == "putt" ? HeadOver::Feet : HeadOver::Shoulders,
                        one.eye == BenchEye::TrueJoints ? ArmAxes::Chest : ArmAxes::World});
  for (const PartDifference& difference : differences)
    if (to_string(difference.feature) == advice.measure) return difference.amount;
  POSECOACH_ASSERT(!"advice of no known measure");
  return 0;
}

}  // namespace

bool BenchAnswer::is_amount_right() const {
  return rank > 0 && std::abs(amount_told - amount_true) <= kAmountTolerance * std::abs(amount_true);
}

Result<StudentInput> see_true_joints(const BenchCase& one) {
  const Result<AuthoredMotion> stroke = make_stroke_of(one);
  if (!stroke) return tl::unexpected(stroke.error());
  return student_from_motion(name_of(one), stroke->motion);
}

Result<BenchAnswer> judge(const BenchCase& one, const StudentInput& student, const Motion& coach) {
  BenchAnswer answer{one, {}, 0, {}, 0, 0, 0};
  const Result<AnalyzedPair> pair = analyze(student, {"bundled:" + one.motion, coach});
  if (!pair) {
    answer.refusal = pair.error().message;
    return answer;
  }
  answer.percent = pair->analysis.score.percent;
  for (const Advice& advice : pair->analysis.advice)
    if (advice.kind != AdviceKind::None) answer.advice.push_back(advice);
  if (!one.fault) return answer;
  for (std::size_t k = 0; k < answer.advice.size() && answer.rank == 0; ++k)
    if (answer.advice[k].fault == one.fault->name) answer.rank = static_cast<int>(k) + 1;
  if (answer.rank == 0) return answer;
  BenchCase faultless = one;
  faultless.fault = nullptr;
  const Result<Truth> faulty_truth = truth_of(one), faultless_truth = truth_of(faultless);
  if (!faulty_truth) return tl::unexpected(faulty_truth.error());
  if (!faultless_truth) return tl::unexpected(faultless_truth.error());
  const Advice& told = answer.advice[static_cast<std::size_t>(answer.rank - 1)];
  answer.amount_told = told.amount;
  answer.amount_true = true_amount(*faulty_truth, *faultless_truth, told, one);
  return answer;
}

std::vector<BenchRow> tally(const std::vector<BenchAnswer>& answers) {
  std::vector<BenchRow> rows;
  for (const BenchAnswer& answer : answers) {
    const BenchCase& asked = answer.asked;
    const std::string fault = asked.fault ? std::string(asked.fault->name) : std::string();
    auto row = std::find_if(rows.begin(), rows.end(), [&](const BenchRow& r) {
      return r.eye == asked.eye && r.motion == asked.motion && r.fault == fault;
    });
    if (row == rows.end()) {
      rows.push_back({asked.eye, asked.motion, fault, 0, 0, 0, 0, 0, 0, 0, 100});
      row = rows.end() - 1;
    }
    ++row->cases;
    if (!answer.refusal.empty()) {
      ++row->refused;
      continue;
    }
    row->percent_mean += answer.percent;
    row->percent_least = std::min(row->percent_least, answer.percent);
    if (!asked.fault) {
      row->false_alarms += answer.advice.empty() ? 0 : 1;
      continue;
    }
    row->first += answer.rank == 1 ? 1 : 0;
    row->top_three += answer.rank > 0 ? 1 : 0;
    row->amount_right += answer.is_amount_right() ? 1 : 0;
  }
  for (BenchRow& row : rows)
    if (row.cases > row.refused) row.percent_mean /= row.cases - row.refused;
  std::stable_sort(rows.begin(), rows.end(), [](const BenchRow& a, const BenchRow& b) {
    return std::tuple(a.eye, a.motion != "swing") < std::tuple(b.eye, b.motion != "swing");
  });
  return rows;
}

Result<std::vector<BenchAnswer>> run_fault_bench(const std::vector<BenchCase>& cases,
                                                 const BenchEyeFunction& see, const Progress& progress) {
  std::map<std::string, Motion> coaches;
  for (const char* motion : {"swing", "putt"}) {
    Result<Motion> coach = bundled_motion(motion);
    if (!coach) return tl::unexpected(coach.error());
    coaches.emplace(motion, *std::move(coach));
  }
  std::vector<BenchAnswer> answers;
  for (const BenchCase& one : cases) {
    if (!report(progress, "judging " + name_of(one),
                static_cast<double>(answers.size()) / static_cast<double>(cases.size())))
      return fail(ErrorCode::Cancelled, "interrupted");
    const Result<StudentInput> student = see(one);
    if (!student) {
      const ErrorCode code = student.error().code;
      if (code != ErrorCode::NoPerson && code != ErrorCode::Incomplete)
        return tl::unexpected(student.error());
      answers.push_back({one, student.error().message, 0, {}, 0, 0, 0});
      continue;
    }
    Result<BenchAnswer> answer = judge(one, *student, coaches.at(one.motion));
    if (!answer) return tl::unexpected(answer.error());
    answers.push_back(*std::move(answer));
  }
  return answers;
}

}  // namespace posecoach
