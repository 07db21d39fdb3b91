// The pose stage: finds one person, then follows that person from frame to frame. The detector runs only
// while nobody is followed; when the person is lost, that frame has nobody and the search begins in the next.
// Where several people are found, the one who stands where the lost person was is taken, otherwise the
// clearest.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "core/pipeline/pose_estimator.h"
#include "core/vision/model_file.h"

namespace posecoach {

enum class Search {
  WhenLost,
  InEveryFrame  // each frame by itself: no tracking and no smoothing
};
enum class Smoothing { On, Off };

struct PoseTrackerOptions {
  PoseModel model = PoseModel::Full;
  Search search = Search::WhenLost;
  Smoothing smoothing = Smoothing::On;
  std::optional<std::filesystem::path> models;  // see find_model_file
};

class PoseTracker : public PoseEstimator {
 public:
  // Errors: a missing or damaged model file.
  static Result<std::unique_ptr<PoseTracker>> make(const PoseTrackerOptions& options);

  ~PoseTracker() override;
  Result<PoseObservation> estimate(const Frame& frame) override;
  std::optional<SeenPerson> unsmoothed() const override;
  Result<std::optional<int>> count_people(const Frame& frame) override;
  void reset() override;

 private:
  class Implementation;
  explicit PoseTracker(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace posecoach
