#include "core/vision/pose_tracker.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "core/base/assert.h"
#include "core/vision/detector.h"
#include "core/vision/landmark_model.h"
#include "core/vision/landmark_smoother.h"

namespace posecoach {
namespace {

// Steadies the region from frame to frame, whether or not the landmarks are smoothed.
constexpr OneEuroOptions kRegionOptions{0.01, 10, 1};

std::optional<RegionOfInterest> choose_person(const std::vector<RegionOfInterest>& people,
                                              const std::optional<RegionOfInterest>& last) {
  if (people.empty()) return std::nullopt;
  const auto same = std::find_if(people.begin(), people.end(), [&](const RegionOfInterest& person) {
    return last && glm::distance(person.centre_px, last->centre_px) < 0.25 * last->size_px;
  });
  return same == people.end() ? people.front() : *same;
}

}  // namespace

class PoseTracker::Implementation {
 public:
  Implementation(Detector detector, LandmarkModel landmarks, const PoseTrackerOptions& options)
      : options_(options), detector_(std::move(detector)), landmarks_(std::move(landmarks)) {}

  Result<std::optional<SeenPerson>> estimate(const Frame& frame) {
    if (options_.search == Search::InEveryFrame) reset();
    if (!region_) {
      const auto people = detector_.detect(*frame.image);
      if (!people) return tl::unexpected(people.error());
      region_ = choose_person(*people, last_region_);
    }
    if (!is_usable(region_)) return lose();
    const auto answer = landmarks_.estimate(*frame.image, *region_);
    if (!answer) return tl::unexpected(answer.error());
    if (!*answer) return lose();
    return follow(frame.time, **answer);
  }

  Result<std::optional<int>> count_people(const Frame& frame) {
    const auto people = detector_.detect(*frame.image);
    if (!people) return tl::unexpected(people.error());
    return std::optional(static_cast<int>(people->size()));
  }

  const std::optional<SeenPerson>& unsmoothed() const { return unsmoothed_; }

  void reset() {
    lose();
    last_region_.reset();
  }

 private:
  static bool is_usable(const std::optional<RegionOfInterest>& region) {
    return region && region->is_finite() && region->size_px >= 1;
  }

  std::optional<SeenPerson> lose() {
    region_.reset();
    unsmoothed_.reset();
    points_.reset();
    smoother_.reset();
    return std::nullopt;
  }

  SeenPerson follow(MediaTime time, const LandmarkAnswer& answer) {
    const double size_px = person_size_px(answer.hip_centre_px, answer.scale_point_px);
    region_ = region_from_points(points_.smooth(0, time, answer.hip_centre_px, size_px),
                                 points_.smooth(1, time, answer.scale_point_px, size_px));
    last_region_ = region_;
    if (options_.smoothing == Smoothing::Off || options_.search == Search::InEveryFrame) return answer.person;
    unsmoothed_ = answer.person;
    return smoother_.smooth(time, answer.person, size_px);
  }

  PoseTrackerOptions options_;
  Detector detector_;
  LandmarkModel landmarks_;
  PointSmoother points_{2, kRegionOptions};
  LandmarkSmoother smoother_;
  std::optional<SeenPerson> unsmoothed_;         // of the last frame, where it was smoothed
  std::optional<RegionOfInterest> region_;       // where to look next; nothing: search
  std::optional<RegionOfInterest> last_region_;  // where the person was last
};

PoseTracker::PoseTracker(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
PoseTracker::~PoseTracker() = default;

Result<std::unique_ptr<PoseTracker>> PoseTracker::make(const PoseTrackerOptions& options) {
  const auto detector_file = find_model_file(kDetectorFileName, options.models);
  if (!detector_file) return tl::unexpected(detector_file.error());
  const auto landmark_file = find_model_file(landmark_file_name(options.model), options.models);
  if (!landmark_file) return tl::unexpected(landmark_file.error());
  auto detector = Detector::load(*detector_file);
  if (!detector) return tl::unexpected(detector.error());
  auto landmarks = LandmarkModel::load(*landmark_file);
  if (!landmarks) return tl::unexpected(landmarks.error());
  return std::unique_ptr<PoseTracker>(new PoseTracker(
      std::make_unique<Implementation>(std::move(*detector), std::move(*landmarks), options)));
}

Result<PoseObservation> PoseTracker::estimate(const Frame& frame) {
  POSECOACH_ASSERT(frame.image != nullptr && !frame.image->empty());
  auto person = implementation_->estimate(frame);
  if (!person) return tl::unexpected(person.error());
  return PoseObservation{frame.index, frame.time, *person};
}

std::optional<SeenPerson> PoseTracker::unsmoothed() const {
  return implementation_->unsmoothed();
}

Result<std::optional<int>> PoseTracker::count_people(const Frame& frame) {
  return implementation_->count_people(frame);
}

void PoseTracker::reset() {
  implementation_->reset();
}

}  // namespace posecoach
