#include "core/pipeline/lift.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/median.h"
#include "core/body/body_measurement.h"
#include "core/body/landmark_body.h"
#include "core/pipeline/placing.h"
#include "core/pipeline/stance.h"
#include "core/pipeline/track_repair.h"

namespace posecoach {
namespace {

constexpr std::size_t kFewestFrames = 3;
// A golfer shifts his weight within a second or two; the model's sense of size wavers faster than that.
constexpr double kDepthSmoothing_s = 0.5;

// The frames in which somebody is seen.
struct Sightings {
  std::vector<std::size_t> frames;  // of the track
  std::vector<double> times_s;
  std::vector<SeenPerson> people;
};

Result<Sightings> sightings_of(const PoseTrack& track) {
  Sightings sightings;
  for (std::size_t i = 0; i < track.frames.size(); ++i) {
    if (!track.frames[i].person) continue;
    sightings.frames.push_back(i);
    sightings.times_s.push_back(to_seconds(track.frames[i].time));
    sightings.people.push_back(*track.frames[i].person);
  }
  if (sightings.frames.empty())
    return fail(ErrorCode::NoPerson, track.source + ": nobody is seen in any frame");
  if (sightings.frames.size() < kFewestFrames)
    return fail(ErrorCode::Incomplete, track.source + ": a person is seen in only " +
                                           std::to_string(sightings.frames.size()) +
                                           " frames; a motion needs at least 3");
  repair_people(sightings.times_s, sightings.people);
  return sightings;
}

// Each frame's depth of the hips, smoothed over time; frames whose fit failed take their neighbours'.
std::vector<double> smooth_depths(std::span<const std::optional<Vec3>> places,
                                  std::span<const double> times_s) {
  std::vector<double> depths(places.size(), 0.0);
  std::vector<double> known;
  for (const auto& place : places)
    if (place) known.push_back(place->z);
  const double usual = median(std::move(known));
  std::size_t begin = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    while (times_s[begin] < times_s[i] - 3 * kDepthSmoothing_s) ++begin;
    double sum = 1e-6 * usual, weights = 1e-6;
    for (std::size_t j = begin; j < places.size() && times_s[j] <= times_s[i] + 3 * kDepthSmoothing_s; ++j) {
      if (!places[j]) continue;
      const double distance = (times_s[j] - times_s[i]) / kDepthSmoothing_s;
      const double weight = std::exp(-0.5 * distance * distance);
      sum += weight * places[j]->z;
      weights += weight;
    }
    depths[i] = sum / weights;
  }
  return depths;
}

// The people of all sightings before one camera that stands still, in the model's metres.
struct Placed {
  Intrinsics intrinsics;
  std::vector<Vec3> positions;     // joints of the webcam body, frame-major, camera axes
  std::vector<double> confidence;  // likewise
  double residual_px = 0;
};

Result<Placed> place_before_camera(const Sightings& sightings, const PoseTrack& track) {
  Placed placed;
  placed.intrinsics = {estimate_focal_px(sightings.people, track.width, track.height),
                       {0.5 * track.width, 0.5 * track.height}};
  std::vector<std::optional<Vec3>> places;
  std::vector<SeenPerson> fitted_people;
  std::vector<Vec3> fitted_places;
  for (const SeenPerson& person : sightings.people) {
    places.push_back(fit_translation(person, placed.intrinsics));
    if (!places.back()) continue;
    fitted_people.push_back(person);
    fitted_places.push_back(*places.back());
  }
  if (fitted_places.empty())
    return fail(ErrorCode::NoPerson,
                track.source + ": the joints that are seen do not make a body before a camera");
  placed.residual_px = reprojection_error_px(fitted_people, fitted_places, placed.intrinsics);
  const std::vector<double> depths = smooth_depths(places, sightings.times_s);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const SeenPerson& person = sightings.people[i];
    const auto joints = landmark_body_positions(on_rays(person, depths[i], placed.intrinsics));
    placed.positions.insert(placed.positions.end(), joints.begin(), joints.end());
    std::array<double, kLandmarkCount> visibility{};
    for (std::size_t k = 0; k < kLandmarkCount; ++k)
      visibility[k] = std::clamp(person.image[k].visibility, 0.0, 1.0);
    const auto confidence = landmark_body_confidence(visibility);
    placed.confidence.insert(placed.confidence.end(), confidence.begin(), confidence.end());
  }
  return placed;
}

struct SizedBody {
  Skeleton body;
  double scale = 1;  // from the model's metres to the student's
};

// Measured where the joints were placed: across the view they are as exact as the 2D joints.
Result<SizedBody> size_body(const Placed& placed, const Sightings& sightings, const LiftOptions& options) {
  std::vector<WorldKeypoints> frames(sightings.people.size());
  for (std::size_t f = 0; f < frames.size(); ++f)
    for (std::size_t i = 0; i < kLandmarkCount; ++i)
      frames[f][i] = {placed.positions[f * kLandmarkBodyJointCount + i + kLandmarkBodyDerivedJoints],
                      sightings.people[f].image[i].visibility};
  const Result<Skeleton> measured = measure_landmark_body(frames);
  if (!measured) return tl::unexpected(measured.error());
  if (options.body) {
    if (!is_landmark_body(*options.body))
      return fail(ErrorCode::InvalidArgument, "a student seen by a camera needs a body measured by a camera");
    return SizedBody{*options.body, arms_legs_and_torso(*options.body) / arms_legs_and_torso(*measured)};
  }
  if (!options.height_m) return SizedBody{*measured, 1};
  Result<Skeleton> scaled = scaled_to_stature(*measured, *options.height_m);
  if (!scaled) return tl::unexpected(scaled.error());
  return SizedBody{*std::move(scaled), *options.height_m / stature(*measured)};
}

// All frames from the first to the last sighting; between sightings, a straight line that claims nothing.
Result<Motion> motion_in_world(const PoseTrack& track, const Sightings& sightings, const Placed& placed,
                               const Stance& stance, const Skeleton& body) {
  std::vector<MediaTime> times;
  std::vector<Vec3> positions;
  std::vector<double> confidence;
  std::size_t left = 0;
  for (std::size_t frame = sightings.frames.front(); frame <= sightings.frames.back(); ++frame) {
    while (left + 1 < sightings.frames.size() && sightings.frames[left + 1] <= frame) ++left;
    const std::size_t right = std::min(left + 1, sightings.frames.size() - 1);
    const bool seen = sightings.frames[left] == frame;
    times.push_back(track.frames[frame].time);
    const double span = sightings.times_s[right] - sightings.times_s[left];
    const double part = seen || span <= 0 ? 0.0 : (to_seconds(times.back()) - sightings.times_s[left]) / span;
    for (std::size_t j = 0; j < kLandmarkBodyJointCount; ++j) {
      const Vec3 place = glm::mix(placed.positions[left * kLandmarkBodyJointCount + j],
                                  placed.positions[right * kLandmarkBodyJointCount + j], part);
      positions.push_back(stance.world_from_camera * (place - stance.origin));
      confidence.push_back(seen ? placed.confidence[left * kLandmarkBodyJointCount + j] : 0.0);
    }
  }
  return Motion::from_positions(body, std::move(times), std::move(positions), std::move(confidence));
}

CameraSide side_of(const Motion& motion, const PinholeCamera& camera, std::span<const std::size_t> still) {
  Vec3 facing(0);
  for (const std::size_t i : still) facing += facing_in(motion, static_cast<int>(i));
  const Vec3 to_camera = camera.position() - motion.position(static_cast<int>(still[0]), 0);
  return camera_side(facing, to_camera);
}

}  // namespace

Result<LiftedStudent> lift(const PoseTrack& track, const LiftOptions& options) {
  if (track.width <= 0 || track.height <= 0)
    return fail(ErrorCode::Malformed, track.source + ": the size of the picture is missing");
  const Result<Sightings> sightings = sightings_of(track);
  if (!sightings) return tl::unexpected(sightings.error());
  Result<Placed> placed = place_before_camera(*sightings, track);
  if (!placed) return tl::unexpected(placed.error());
  const Result<SizedBody> sized = size_body(*placed, *sightings, options);
  if (!sized) return fail(sized.error().code, track.source + ": " + sized.error().message);
  for (Vec3& position : placed->positions) position *= sized->scale;

  const double seconds = sightings->times_s.back() - sightings->times_s.front();
  const Stance stance = estimate_stance(
      placed->positions, seconds > 0 ? static_cast<double>(sightings->frames.size() - 1) / seconds : 30);
  Result<Motion> motion = motion_in_world(track, *sightings, *placed, stance, sized->body);
  if (!motion) return fail(motion.error().code, track.source + ": " + motion.error().message);
  const PinholeCamera camera{track.width,
                             track.height,
                             placed->intrinsics.focal_px,
                             placed->intrinsics.centre_px,
                             glm::transpose(stance.world_from_camera),
                             stance.origin};
  const std::size_t first = sightings->frames.front();
  std::vector<std::size_t> still;
  for (const std::size_t i : stance.still_frames) still.push_back(sightings->frames[i] - first);
  const CameraSide side = side_of(*motion, camera, still);
  return LiftedStudent{.motion = *std::move(motion),
                       .body = sized->body,
                       .camera = camera,
                       .view = side.view,
                       .first_frame = static_cast<int>(first),
                       .aside_deg = side.aside_deg,
                       .model_residual_px = placed->residual_px};
}

}  // namespace posecoach
