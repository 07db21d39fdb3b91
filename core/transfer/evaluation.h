// How well transfers meet exact truth: the tables of Zheng et al. (2021).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/transfer/clip_pool.h"
#include "core/transfer/pose_similarity.h"
#include "core/transfer/transferer.h"

namespace posecoach {

// Metres to the units that the paper's network is trained in: people of every size fit into (-1, 1).
inline constexpr double kPaperUnitsPerMetre = 0.8;

struct TransferScore {
  TransferError error;   // means over the samples
  LinkCount violations;  // of all links along four directions, of the result against the pose
  long samples = 0;
  long touch_samples = 0;      // those in which the posing hands touch
  double touch_error = 0;      // and there: change of the wrists' distance, in statures, mean
  double touch_error_p95 = 0;  // and 95th percentile
};

// Results come in and means go out. `units_per_metre` brings the errors to the table's units.
class TransferScorer {
 public:
  explicit TransferScorer(double units_per_metre) : units_per_metre_(units_per_metre) {}
  // Without a result (the method refused) the sample counts with an OKS of 0.
  void add(const TransferSample& sample, const Pose2d* result);
  TransferScore score() const;

 private:
  double units_per_metre_;
  TransferScore sums_;
  std::vector<double> touch_errors_;
};

// The paper's "one global scale": every pose of the samples, centred, within (-1, 1).
double units_per_metre(std::span<const TransferSample> samples);

// The samples' pictures are in metres.
TransferScore score(Transferer& transferer, std::span<const TransferSample> samples,
                    double units_per_metre = kPaperUnitsPerMetre);
// Of the oracle `bones3d`, which the samples bring with them.
TransferScore score_oracle(std::span<const TransferSample> samples,
                           double units_per_metre = kPaperUnitsPerMetre);

// A transfer of a whole clip, section 4.3.3.
struct ScoreOverTime {
  double squared_error = 0;  // mean squared distance of joints, the table's units
  double jitter = 0;         // mean second difference of the joints' paths, the truth's being 1
};
ScoreOverTime score_over_time(Transferer& transferer, std::span<const TransferSample> clip,
                              double units_per_metre);

}  // namespace posecoach
