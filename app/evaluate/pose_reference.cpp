#include "app/evaluate/pose_reference.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "core/base/file.h"

namespace posecoach {
namespace {

using nlohmann::json;

SeenPerson person_from(const json& frame) {
  const double width = frame.at("width");
  const double height = frame.at("height");
  SeenPerson person;
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    const json& image = frame.at("landmarks").at(i);
    const json& world = frame.at("world").at(i);
    person.image[i] = {{image.at(0).get<double>() * width, image.at(1).get<double>() * height}, image.at(3)};
    person.world[i] = {{world.at(0), world.at(1), world.at(2)}, world.at(3)};
  }
  return person;
}

PoseReference reference_from(const json& stored) {
  PoseReference reference;
  const std::string model = stored.at("model");
  reference.options.model = model == "lite"    ? PoseModel::Lite
                            : model == "heavy" ? PoseModel::Heavy
                                               : PoseModel::Full;
  reference.options.smoothing = stored.at("smoothing").get<bool>() ? Smoothing::On : Smoothing::Off;
  reference.options.search =
      stored.at("detector_every_frame").get<bool>() ? Search::InEveryFrame : Search::WhenLost;
  for (const json& frame : stored.at("frames")) {
    PoseReferenceFrame read;
    read.frame_index = frame.at("frame");
    if (const auto found = frame.find("landmarks"); found != frame.end() && !found->empty())
      read.person = person_from(frame);
    reference.frames.push_back(std::move(read));
  }
  return reference;
}

// Of sorted values: the smallest that at least this share does not exceed.
double quantile(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) return 0;
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
  return sorted[std::clamp<std::size_t>(rank, 1, sorted.size()) - 1];
}

}  // namespace

Result<PoseReference> read_pose_reference(const std::filesystem::path& file) {
  const auto text = read_file(file);
  if (!text) return tl::unexpected(text.error());
  try {
    PoseReference reference = reference_from(json::parse(*text));
    reference.name = file.stem().string();
    return reference;
  } catch (const json::exception& error) {
    return fail(ErrorCode::Malformed, file.string() + " is not a pose reference: " + error.what());
  }
}

PoseAgreement compare_poses(const PoseTrack& track, const PoseReference& reference) {
  PoseAgreement agreement;
  std::vector<double> image_px;
  std::vector<double> world_mm;
  for (const PoseReferenceFrame& theirs : reference.frames) {
    const bool exists = theirs.frame_index < track.frames.size();
    const auto& ours = exists ? track.frames[theirs.frame_index].person : std::nullopt;
    if (ours.has_value() != theirs.person.has_value()) ++agreement.mismatched;
    if (!ours || !theirs.person) continue;
    double image_sum = 0;
    double world_sum = 0;
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
      image_sum += glm::distance(ours->image[i].position_px, theirs.person->image[i].position_px);
      world_sum += glm::distance(ours->world[i].position_m, theirs.person->world[i].position_m);
    }
    image_px.push_back(image_sum / kLandmarkCount);
    world_mm.push_back(1000 * world_sum / kLandmarkCount);
  }
  std::sort(image_px.begin(), image_px.end());
  std::sort(world_mm.begin(), world_mm.end());
  agreement.frames = image_px.size();
  agreement.image_median_px = quantile(image_px, 0.5);
  agreement.image_percentile95_px = quantile(image_px, 0.95);
  agreement.image_max_px = quantile(image_px, 1);
  agreement.world_median_mm = quantile(world_mm, 0.5);
  return agreement;
}

}  // namespace posecoach
