#include "core/coaching/score.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "core/base/median.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

constexpr std::size_t kWorstFrames = 5;
// A joint that the camera does not see at all may be this far from where it is said to be, metres.
constexpr double kHiddenJointError_m = 0.08;
// Of a film's usual errors, the part that their wavering is: they are means and two standard deviations.
constexpr double kUsualErrorSpread = 1.0 / 3;

double percent_from(double error, double half_score = kHalfScore) {
  return 100 / (1 + std::pow(error / half_score, 1.5));
}

}  // namespace

double percent_from_error(double mean_joint_error_m, double leg_length_m) {
  return percent_from(mean_joint_error_m / std::max(leg_length_m, 0.1));
}

double leg_length(const JointTrack& track) {
  std::vector<double> lengths;
  for (int frame = 0; frame < track.frame_count(); ++frame) {
    double sum = 0;
    for (const auto& [hip, knee, ankle] :
         {std::array{LeftHip, LeftKnee, LeftAnkle}, std::array{RightHip, RightKnee, RightAnkle}})
      sum += glm::distance(track.position(frame, hip), track.position(frame, knee)) +
             glm::distance(track.position(frame, knee), track.position(frame, ankle));
    lengths.push_back(0.5 * sum);
  }
  return median(std::move(lengths));
}

namespace {

struct BodyPart {
  const char* name;
  std::vector<HumanoidJoint> joints;  // of a right-hander
};

const std::vector<BodyPart>& body_parts() {
  static const std::vector<BodyPart> parts = {
      {"hips", {LeftHip, RightHip}},
      {"trunk", {Spine, SpineMiddle, Chest, Neck, LeftClavicle, LeftShoulder, RightClavicle, RightShoulder}},
      {"head", {Head, HeadTop}},
      {"lead_arm", {LeftElbow, LeftWrist}},
      {"trail_arm", {RightElbow, RightWrist}},
      {"lead_leg", {LeftKnee, LeftAnkle, LeftToe, LeftToeTip}},
      {"trail_leg", {RightKnee, RightAnkle, RightToe, RightToeTip}}};
  return parts;
}

struct PartError {
  const char* name = "";
  double sum_m = 0, joints = 0;

  double mean_m() const { return sum_m / joints; }
};

std::vector<PartError> part_errors_of(const Alignment& alignment) {
  const std::vector<JointError> errors = joint_errors_of(alignment);
  std::vector<PartError> parts;
  for (const BodyPart& part : body_parts()) {
    PartError sum{part.name};
    for (const HumanoidJoint joint : part.joints)
      for (const JointError& error : errors)
        if (error.joint == to_string(joint)) {
          sum.sum_m += error.mean_m;
          ++sum.joints;
        }
    if (sum.joints > 0) parts.push_back(sum);
  }
  return parts;
}

bool is_of(const BodyPart& part, HumanoidJoint joint) {
  return std::find(part.joints.begin(), part.joints.end(), joint) != part.joints.end();
}

// Of a film: what is beyond `times` the usual errors, about the stages from `first` up to before `last`, when
// every joint is `off` farther away.
struct Doubt {
  double off = 0, times = 1;
};

struct FilmPartError {
  const char* name = "";
  double error = 0, joints = 0;  // leg lengths
};

std::vector<FilmPartError> part_errors_of(const FilmGaps& film, int first, int last,
                                          const Doubt& doubt = {}) {
  std::vector<FilmPartError> parts;
  for (const BodyPart& part : body_parts()) {
    std::vector<std::size_t> joints;
    for (std::size_t k = 0; k < film.joints().size(); ++k)
      if (is_of(part, film.joints()[k])) joints.push_back(k);
    if (joints.empty()) continue;
    double beyond = 0;
    for (int stage = first; stage < last; ++stage) {
      double left = doubt.off;
      for (const std::size_t joint : joints)
        left += film.left(stage, joint) / static_cast<double>(joints.size());
      beyond += std::max(0.0, left - doubt.times * film.usual_error().of(part.name, stage));
    }
    parts.push_back({part.name, beyond / (last - first), static_cast<double>(joints.size())});
  }
  return parts;
}

double percent_of(const FilmGaps& film, int first, int last, const Doubt& doubt = {}) {
  double sum = 0, joints = 0;
  for (const FilmPartError& part : part_errors_of(film, first, last, doubt)) {
    sum += part.joints * part.error;
    joints += part.joints;
  }
  return percent_from(sum / joints, kHalfFilmScore);
}

}  // namespace

Score score_of(const Alignment& alignment, const std::optional<FilmGaps>& film) {
  Score score;
  const double pairs = static_cast<double>(alignment.path_error_m.size());
  const double sum = std::accumulate(alignment.path_error_m.begin(), alignment.path_error_m.end(), 0.0);
  score.joints_compared = static_cast<int>(alignment.joints.size());
  score.mean_joint_error_m = sum / pairs;
  score.raw = sum * score.joints_compared;
  const double leg = std::max(leg_length(alignment.student), 0.1);
  const auto percent = [&](double off_m, double times) {
    return film ? percent_of(*film, 0, film->stages(), {off_m / leg, times})
                : percent_from(std::max(0.0, score.mean_joint_error_m + off_m) / leg);
  };
  score.percent = percent(0, 1);
  // Doubt widens the score; it never moves it.
  double doubt = 0;
  for (const auto& [i, j] : alignment.steps)
    for (const HumanoidJoint joint : alignment.joints) doubt += 1 - alignment.student.confidence(i, joint);
  doubt *= kHiddenJointError_m / static_cast<double>(alignment.steps.size() * alignment.joints.size());
  score.plus_minus = 0.5 * (percent(-doubt, 1 + kUsualErrorSpread) - percent(doubt, 1 - kUsualErrorSpread));
  return score;
}

std::vector<PartScore> group_scores_of(const Alignment& alignment, const std::optional<FilmGaps>& film) {
  const double leg = leg_length(alignment.student);
  const std::vector<FilmPartError> beyond =
      film ? part_errors_of(*film, 0, film->stages()) : std::vector<FilmPartError>();
  std::vector<PartScore> scores;
  for (const PartError& part : part_errors_of(alignment))
    scores.push_back({part.name, part.mean_m(),
                      film ? percent_from(beyond[scores.size()].error, kHalfFilmScore)
                           : percent_from_error(part.mean_m(), leg)});
  return scores;
}

std::vector<PartScore> phase_scores_of(const Alignment& alignment, const SwingEvents& student,
                                       const std::optional<FilmGaps>& film) {
  const double leg = leg_length(alignment.student);
  const double top = student.time_of("top"), impact = student.time_of("impact");
  std::array<double, 3> sums{}, counts{};
  for (std::size_t k = 0; k < alignment.steps.size(); ++k) {
    const double time = alignment.student.time(alignment.steps[k].first);
    const std::size_t phase = time < top ? 0 : time < impact ? 1 : 2;
    sums[phase] += alignment.step_error_m[k];
    ++counts[phase];
  }
  const FilmStages::Phases begins = film ? film->phases() : FilmStages::Phases{};
  std::vector<PartScore> scores;
  for (std::size_t phase = 0; phase < 3; ++phase) {
    constexpr std::array kNames = {"backswing", "downswing", "follow_through"};
    const double mean_m = counts[phase] > 0 ? sums[phase] / counts[phase] : 0;
    scores.push_back(
        {kNames[phase], mean_m,
         film ? percent_of(*film, begins[phase], begins[phase + 1]) : percent_from_error(mean_m, leg)});
  }
  return scores;
}

std::vector<JointError> joint_errors_of(const Alignment& alignment) {
  std::vector<JointError> errors;
  for (const HumanoidJoint joint : alignment.joints) {
    JointError error;
    error.joint = to_string(joint);
    double sum = 0, total = 0;
    for (const auto& [i, j] : alignment.steps) {
      const Vec3 student = alignment.student.position(i, joint) - alignment.student.position(i, Pelvis);
      const Vec3 coach = alignment.coach.position(j, joint) - alignment.coach.position(j, Pelvis);
      const double distance = glm::length(alignment.sight.seen(student - coach));
      const double weight = 0.05 + alignment.student.confidence(i, joint);
      sum += weight * distance;
      total += weight;
      error.max_m = std::max(error.max_m, distance);
    }
    error.mean_m = sum / total;
    errors.push_back(std::move(error));
  }
  std::stable_sort(errors.begin(), errors.end(),
                   [](const auto& a, const auto& b) { return a.mean_m > b.mean_m; });
  return errors;
}

std::vector<FramePair> worst_frames_of(const Alignment& alignment, const JointTrack& student,
                                       double apart_s) {
  std::vector<std::size_t> order(alignment.path.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return alignment.path_error_m[a] > alignment.path_error_m[b];
  });
  std::vector<FramePair> worst;
  for (const std::size_t k : order) {
    const auto& [i, j] = alignment.path[k];
    const bool is_apart = std::all_of(worst.begin(), worst.end(), [&](const FramePair& pair) {
      return std::abs(student.time(i) - student.time(pair.student_frame)) >= apart_s;
    });
    if (is_apart && alignment.path_error_m[k] > 0) worst.push_back({i, j, alignment.path_error_m[k]});
    if (worst.size() == kWorstFrames) break;
  }
  return worst;
}

}  // namespace posecoach
