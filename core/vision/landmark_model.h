// The landmark network: 33 joints of the person in a region of the picture.
#pragma once

#include <filesystem>
#include <optional>

#include "core/body/landmarks.h"
#include "core/image/frame.h"
#include "core/vision/network.h"
#include "core/vision/region_of_interest.h"

namespace posecoach {

// Nothing is smoothed yet.
struct LandmarkAnswer {
  SeenPerson person;
  Vec2 hip_centre_px;  // the two points that fix the next frame's region
  Vec2 scale_point_px;
};

class LandmarkModel {
 public:
  // Errors: the file's, and Unsupported when it is another network.
  static Result<LandmarkModel> load(const std::filesystem::path& file);

  // Nothing when the network does not think that a person is there (probability of one half or less).
  Result<std::optional<LandmarkAnswer>> estimate(const Image& image, const RegionOfInterest& region);

 private:
  explicit LandmarkModel(Network network) : network_(std::move(network)) {}

  Network network_;
};

}  // namespace posecoach
