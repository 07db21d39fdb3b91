#include "core/transfer/evaluation.h"

#include <algorithm>

namespace posecoach {
namespace {

double wrist_distance(const Pose2d& pose) {
  return glm::length(pose[Joint2d::LeftWrist] - pose[Joint2d::RightWrist]);
}

}  // namespace

void TransferScorer::add(const TransferSample& sample, const Pose2d* result) {
  static const std::vector<Vec2> directions = projection_directions(4);
  ++sums_.samples;
  if (result == nullptr) return;
  const TransferError error =
      transfer_error(scaled(*result, units_per_metre_), scaled(sample.truth, units_per_metre_));
  sums_.error.mse_lengths += error.mse_lengths;
  sums_.error.mse_angles += error.mse_angles;
  sums_.error.mse_joints += error.mse_joints;
  sums_.error.oks_percent += error.oks_percent;
  sums_.violations += violations(sample.source.front(), *result, links(Links::All), directions);
  if (!sample.hands_touch) return;
  touch_errors_.push_back(std::abs(wrist_distance(*result) / sample.stature_m -
                                   wrist_distance(sample.source.front()) / sample.source_stature_m));
}

TransferScore TransferScorer::score() const {
  TransferScore mean = sums_;
  if (mean.samples == 0) return mean;
  const double count = double(mean.samples);
  mean.error.mse_lengths /= count;
  mean.error.mse_angles /= count;
  mean.error.mse_joints /= count;
  mean.error.oks_percent /= count;
  mean.touch_samples = static_cast<long>(touch_errors_.size());
  if (touch_errors_.empty()) return mean;
  std::vector<double> sorted = touch_errors_;
  std::sort(sorted.begin(), sorted.end());
  for (const double error : sorted) mean.touch_error += error / double(sorted.size());
  mean.touch_error_p95 = sorted[static_cast<std::size_t>(0.95 * double(sorted.size() - 1))];
  return mean;
}

double units_per_metre(std::span<const TransferSample> samples) {
  double largest = 0;
  const auto look_at = [&](const Pose2d& pose) {
    const Vec2 half = 0.5 * bounding_box(pose).size();
    largest = std::max({largest, half.x, half.y});
  };
  for (const TransferSample& sample : samples) {
    look_at(sample.truth);
    for (const Pose2d& pose : sample.source) look_at(pose);
    for (const Pose2d& pose : sample.identity) look_at(pose);
  }
  return largest > 0 ? 1 / largest : 1;
}

TransferScore score(Transferer& transferer, std::span<const TransferSample> samples, double units_per_metre) {
  TransferScorer scorer(units_per_metre);
  for (const TransferSample& sample : samples) {
    if (!transferer.set_people(sample.source, sample.identity)) {
      scorer.add(sample, nullptr);
      continue;
    }
    const Pose2d result = transferer.transfer(sample.source.front()).pose;
    scorer.add(sample, &result);
  }
  return scorer.score();
}

TransferScore score_oracle(std::span<const TransferSample> samples, double units_per_metre) {
  TransferScorer scorer(units_per_metre);
  for (const TransferSample& sample : samples) scorer.add(sample, &sample.oracle);
  return scorer.score();
}

ScoreOverTime score_over_time(Transferer& transferer, std::span<const TransferSample> clip,
                              double units_per_metre) {
  ScoreOverTime result;
  if (clip.empty() || !transferer.set_people(clip.front().source, clip.front().identity)) return result;
  std::vector<Pose2d> made, truth;
  for (const TransferSample& sample : clip) {
    made.push_back(centred(scaled(transferer.transfer(sample.source.front()).pose, units_per_metre)));
    truth.push_back(centred(scaled(sample.truth, units_per_metre)));
    for (std::size_t i = 0; i < kJoint2dCount; ++i) {
      const Vec2 off = made.back().positions[i] - truth.back().positions[i];
      result.squared_error += glm::dot(off, off) / double(kJoint2dCount) / double(clip.size());
    }
  }
  // The box's centre jumps with single limbs, so paths are looked at from the mid-hip.
  const auto shake = [](const std::vector<Pose2d>& poses) {
    const auto at = [&](std::size_t t, std::size_t i) {
      return poses[t].positions[i] - poses[t][Joint2d::MidHip];
    };
    double sum = 0;
    for (std::size_t t = 2; t < poses.size(); ++t)
      for (std::size_t i = 0; i < kJoint2dCount; ++i)
        sum += glm::length(at(t, i) - 2.0 * at(t - 1, i) + at(t - 2, i));
    return sum;
  };
  const double of_truth = shake(truth);
  result.jitter = of_truth > 0 ? shake(made) / of_truth : 0;
  return result;
}

}  // namespace posecoach
