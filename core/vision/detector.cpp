#include "core/vision/detector.h"

#include "core/vision/letterbox.h"
#include "core/vision/model_file.h"

namespace posecoach {
namespace {

constexpr int kAnchors = static_cast<int>(kAnchorCount);

}  // namespace

Result<Detector> Detector::load(const std::filesystem::path& file) {
  auto network = load_network(
      file, {1, kDetectorInputSize, kDetectorInputSize, 3},
      {{"Identity", {1, kAnchors, static_cast<int>(kBoxNumbers)}}, {"Identity_1", {1, kAnchors, 1}}});
  if (!network) return tl::unexpected(network.error());
  return Detector(std::move(*network));
}

Result<std::vector<RegionOfInterest>> Detector::detect(const Image& image) {
  const Letterbox letterbox(image.width, image.height);
  sample_square(image, letterbox.square(), kDetectorInputSize, OutsidePicture::IsBlack,
                {2.0F / 255.0F, -1.0F}, network_.input());
  if (const auto ran = network_.run(); !ran) return tl::unexpected(ran.error());
  std::vector<RegionOfInterest> regions;
  for (const Detection& person :
       merge_overlapping(decode_detections(network_.output(0), network_.output(1), anchors_)))
    regions.push_back(
        region_from_points(letterbox.to_picture(person.points[0]), letterbox.to_picture(person.points[1])));
  return regions;
}

}  // namespace posecoach
