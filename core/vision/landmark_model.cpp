#include "core/vision/landmark_model.h"

#include "core/vision/heatmap_refinement.h"
#include "core/vision/model_file.h"
#include "core/vision/plain_layers.h"

namespace posecoach {
namespace {

constexpr int kInputSize = 256;
constexpr int kPoints = 39;  // the landmarks, the two points of the next region, four without a meaning
constexpr std::size_t kPointNumbers = 5;  // x, y, z, visibility, presence
constexpr std::size_t kHipCentre = 33;
constexpr std::size_t kScalePoint = 34;
constexpr float kPresent = 0.5F;

enum Output : std::size_t { kLandmarks, kPresence, kHeatmap, kWorld };

}  // namespace

Result<LandmarkModel> LandmarkModel::load(const std::filesystem::path& file) {
  auto network = load_network(file, {1, kInputSize, kInputSize, 3},
                              {{"Identity", {1, kPoints * static_cast<int>(kPointNumbers)}},
                               {"Identity_1", {1, 1}},
                               {"Identity_3", {1, kHeatmapSize, kHeatmapSize, kPoints}},
                               {"Identity_4", {1, kPoints * 3}}});
  if (!network) return tl::unexpected(network.error());
  return LandmarkModel(std::move(*network));
}

Result<std::optional<LandmarkAnswer>> LandmarkModel::estimate(const Image& image,
                                                              const RegionOfInterest& region) {
  sample_square(image, region.square(), kInputSize, OutsidePicture::RepeatsTheEdge, {1.0F / 255.0F, 0.0F},
                network_.input());
  if (const auto ran = network_.run(); !ran) return tl::unexpected(ran.error());
  if (!(network_.output(kPresence)[0] > kPresent)) return std::nullopt;

  const auto numbers = network_.output(kLandmarks);
  const auto world = network_.output(kWorld);
  const CropSquare square = region.square();
  const auto position_px = [&](std::size_t i) {
    const Vec2 in_square =
        Vec2(numbers[kPointNumbers * i], numbers[kPointNumbers * i + 1]) / double{kInputSize};
    return square.at(refined_by_heatmap(in_square, network_.output(kHeatmap), static_cast<int>(i), kPoints));
  };
  const double cosine = std::cos(region.rotation);
  const double sine = std::sin(region.rotation);
  LandmarkAnswer answer;
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    const double visibility = logistic(static_cast<double>(numbers[kPointNumbers * i + 3]));
    answer.person.image[i] = {position_px(i), visibility};
    const Vec3 turned(world[3 * i], world[3 * i + 1], world[3 * i + 2]);
    answer.person.world[i] = {
        {cosine * turned.x - sine * turned.y, sine * turned.x + cosine * turned.y, turned.z}, visibility};
  }
  answer.hip_centre_px = position_px(kHipCentre);
  answer.scale_point_px = position_px(kScalePoint);
  return answer;
}

}  // namespace posecoach
