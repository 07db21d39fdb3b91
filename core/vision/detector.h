// Finds people in a whole picture.
#pragma once

#include <filesystem>
#include <vector>

#include "core/image/frame.h"
#include "core/vision/detection.h"
#include "core/vision/network.h"
#include "core/vision/region_of_interest.h"

namespace posecoach {

class Detector {
 public:
  // Errors: the file's, and Unsupported when it is another network.
  static Result<Detector> load(const std::filesystem::path& file);

  // Where people are, best first.
  Result<std::vector<RegionOfInterest>> detect(const Image& image);

 private:
  explicit Detector(Network network) : network_(std::move(network)), anchors_(make_anchors()) {}

  Network network_;
  std::vector<Vec2> anchors_;
};

}  // namespace posecoach
