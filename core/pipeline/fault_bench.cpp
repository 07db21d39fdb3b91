#include "core/pipeline/fault_bench.h"

#include <algorithm>
#include <cmath>
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

std::vector<std::pair<std::string, double>> events_late(const Analysis& analysis,
                                                        const AuthoredMotion& truth) {
  std::vector<std::pair<std::string, double>> late;
  if (analysis.student_events.empty()) return late;
  late.emplace_back("takeaway", analysis.student_takeaway_s - truth.time_of("takeaway"));
  for (const SwingEvent& event : analysis.student_events)
    late.emplace_back(event.name, event.time_s - truth.time_of(event.name));
  return late;
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
  const Result<AnalyzedPair> pair = analyze(student, {"the coach of " + name_of(one), coach});
  if (!pair) {
    answer.refusal = pair.error().message;
    return answer;
  }
  answer.percent = pair->analysis.score.percent;
  answer.plus_minus = pair->analysis.score.plus_minus;
  answer.metrics = pair->analysis.metrics;
  const Result<AuthoredMotion> stroke = make_stroke_of(one);
  if (!stroke) return tl::unexpected(stroke.error());
  answer.events_late = events_late(pair->analysis, *stroke);
  answer.stage_gaps = pair->analysis.stage_gaps;
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

namespace {

bool is_same_but_for_rate(const BenchCase& a, const BenchCase& b) {
  return a.motion == b.motion && a.fault == b.fault && a.amount == b.amount && a.body.name == b.body.name &&
         a.hand == b.hand && a.eye == b.eye && a.camera_turned_deg == b.camera_turned_deg;
}

bool is_same_first(const BenchAnswer& a, const BenchAnswer& b) {
  if (a.advice.empty() || b.advice.empty()) return a.advice.empty() && b.advice.empty();
  const Advice& one = a.advice.front();
  const Advice& other = b.advice.front();
  return one.fault.empty() ? one.measure == other.measure && one.event == other.event
                           : one.fault == other.fault;
}

bool is_within(double a, double a_off, double b, double b_off) {
  return std::abs(a - b) <= a_off + b_off;
}

void compare_rates(const BenchAnswer& slow, const BenchAnswer& quick, BenchAgreement& row) {
  ++row.pairs;
  row.same_first += is_same_first(slow, quick) ? 1 : 0;
  row.scores_within += is_within(slow.percent, slow.plus_minus, quick.percent, quick.plus_minus) ? 1 : 0;
  for (const Metric& metric : slow.metrics) {
    const auto same = std::find_if(quick.metrics.begin(), quick.metrics.end(),
                                   [&](const Metric& other) { return other.name == metric.name; });
    if (!metric.available || same == quick.metrics.end() || !same->available) continue;
    ++row.metrics;
    row.metrics_within += is_within(metric.value, metric.plus_minus, same->value, same->plus_minus) ? 1 : 0;
  }
}

}  // namespace

std::vector<BenchAgreement> agreement_of_frame_rates(const std::vector<BenchAnswer>& answers) {
  std::vector<BenchAgreement> rows;
  for (const BenchAnswer& slow : answers)
    for (const BenchAnswer& quick : answers) {
      if (!slow.refusal.empty() || !quick.refusal.empty() || !is_same_but_for_rate(slow.asked, quick.asked) ||
          slow.asked.frames_per_second >= quick.asked.frames_per_second)
        continue;
      const bool is_slowest = std::none_of(answers.begin(), answers.end(), [&](const BenchAnswer& other) {
        return is_same_but_for_rate(other.asked, slow.asked) &&
               other.asked.frames_per_second < slow.asked.frames_per_second;
      });
      if (!is_slowest) continue;
      auto row = std::find_if(rows.begin(), rows.end(), [&](const BenchAgreement& r) {
        return r.eye == slow.asked.eye && r.motion == slow.asked.motion;
      });
      if (row == rows.end()) row = rows.insert(rows.end(), {slow.asked.eye, slow.asked.motion});
      compare_rates(slow, quick, *row);
    }
  return rows;
}

Result<Motion> bundled_coach(const BenchCase& one) {
  return bundled_motion(one.motion);
}

Result<std::vector<BenchAnswer>> run_fault_bench(const std::vector<BenchCase>& cases,
                                                 const BenchEyeFunction& see,
                                                 const BenchCoachFunction& coach_of,
                                                 const Progress& progress) {
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
    const Result<Motion> coach = coach_of(one);
    if (!coach) return tl::unexpected(coach.error());
    Result<BenchAnswer> answer = judge(one, *student, *coach);
    if (!answer) return tl::unexpected(answer.error());
    answers.push_back(*std::move(answer));
  }
  return answers;
}

}  // namespace posecoach
