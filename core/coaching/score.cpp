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
// How much the usual error of films differs from film to film, as a part of itself.
constexpr double kUsualErrorSpread = 0.12;

double left_of(double error, double usual_error) {
  return std::sqrt(std::max(0.0, error * error - usual_error * usual_error));
}

double percent_from(double error) {
  return 100 / (1 + std::pow(error / kHalfScore, 1.5));
}

}  // namespace

double percent_from_error(double mean_joint_error_m, double leg_length_m, double usual_error) {
  return percent_from(left_of(mean_joint_error_m / std::max(leg_length_m, 0.1), usual_error));
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

// Of a film: what is left of every part's error, `off_m` more or less of it, when `times` its usual one is
// taken off; the mean over the joints, leg lengths.
double left_of(const std::vector<PartError>& parts, const UsualFilmError& usual_error, double leg_m,
               double off_m, double times) {
  double sum = 0, joints = 0;
  for (const PartError& part : parts) {
    sum += part.joints *
           left_of(std::max(0.0, part.mean_m() + off_m) / leg_m, times * usual_error.of(part.name));
    joints += part.joints;
  }
  return sum / joints;
}

}  // namespace

Score score_of(const Alignment& alignment, const UsualFilmError& usual_error) {
  Score score;
  const double pairs = static_cast<double>(alignment.path_error_m.size());
  const double sum = std::accumulate(alignment.path_error_m.begin(), alignment.path_error_m.end(), 0.0);
  score.joints_compared = static_cast<int>(alignment.joints.size());
  score.mean_joint_error_m = sum / pairs;
  score.raw = sum * score.joints_compared;
  const double leg = std::max(leg_length(alignment.student), 0.1);
  const std::vector<PartError> parts = part_errors_of(alignment);
  const auto percent = [&](double off_m, double times) {
    return usual_error.is_none() ? percent_from(std::max(0.0, score.mean_joint_error_m + off_m) / leg)
                                 : percent_from(left_of(parts, usual_error, leg, off_m, times));
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

namespace {

PartScore part_score(std::string name, double sum, double count, double leg_length_m,
                     const UsualFilmError& usual_error) {
  const double mean = count > 0 ? sum / count : 0;
  const double percent = percent_from_error(mean, leg_length_m, usual_error.of(name));
  return {std::move(name), mean, percent};
}

}  // namespace

std::vector<PartScore> group_scores_of(const Alignment& alignment, const UsualFilmError& usual_error) {
  const double leg = leg_length(alignment.student);
  std::vector<PartScore> scores;
  for (const PartError& part : part_errors_of(alignment))
    scores.push_back(part_score(part.name, part.sum_m, part.joints, leg, usual_error));
  return scores;
}

std::vector<PartScore> phase_scores_of(const Alignment& alignment, const SwingEvents& student,
                                       const UsualFilmError& usual_error) {
  const double leg = leg_length(alignment.student);
  const double top = student.time_of("top"), impact = student.time_of("impact");
  std::array<double, 3> sums{}, counts{};
  for (std::size_t k = 0; k < alignment.steps.size(); ++k) {
    const double time = alignment.student.time(alignment.steps[k].first);
    const std::size_t phase = time < top ? 0 : time < impact ? 1 : 2;
    sums[phase] += alignment.step_error_m[k];
    ++counts[phase];
  }
  const auto score = [&](const char* name, std::size_t phase) {
    return part_score(name, sums[phase], counts[phase], leg, usual_error);
  };
  return {score("backswing", 0), score("downswing", 1), score("follow_through", 2)};
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
