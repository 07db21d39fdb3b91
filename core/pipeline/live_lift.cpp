#include "core/pipeline/live_lift.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/body/body_measurement.h"
#include "core/pipeline/ghost_driver.h"
#include "core/pipeline/placing.h"
#include "core/pipeline/stance.h"

namespace posecoach {
namespace {

// As in lift(), but only the past is known: half as slow, so that it lags about as much.
constexpr double kLiveDepthSmoothing_s = 0.3;
constexpr double kForgotten_s = 1.0;
constexpr double kWindow_s = 4.0, kWindowStep_s = 0.1;
constexpr int kFewestForBody = 10;
// The focal length is the camera's: a few looks settle it.
constexpr int kMostCameraFits = 8;
constexpr int kSightingsAFit = 5;
// Over a fifth of a second, joints that stand tremble slower than this, seen in sizes of the torso a second.
constexpr double kStandingSpeed = 0.8, kRecent_s = 0.2;
constexpr double kGroundWeight = 0.3;
constexpr double kFacingWeight = 0.1;

double torso_px(const SeenPerson& person) {
  const auto middle = [&](Landmark a, Landmark b) {
    return 0.5 * (person.image[a].position_px + person.image[b].position_px);
  };
  return std::max(1.0, glm::distance(middle(Landmark::LeftShoulder, Landmark::RightShoulder),
                                     middle(Landmark::LeftHip, Landmark::RightHip)));
}

// Of the fastest of hips, wrists and ankles across the picture, torsos a second.
double speed_between(const SeenPerson& a, const SeenPerson& b, double seconds) {
  double fastest = 0;
  for (const Landmark l : {Landmark::LeftHip, Landmark::RightHip, Landmark::LeftWrist, Landmark::RightWrist,
                           Landmark::LeftAnkle, Landmark::RightAnkle}) {
    if (std::min(a.image[l].visibility, b.image[l].visibility) < 0.5) continue;
    fastest = std::max(fastest, glm::distance(a.image[l].position_px, b.image[l].position_px));
  }
  return fastest / torso_px(b) / std::max(seconds, 1e-3);
}

std::array<double, kLandmarkCount> visibility_of(const SeenPerson& person) {
  std::array<double, kLandmarkCount> visibility{};
  for (std::size_t i = 0; i < kLandmarkCount; ++i)
    visibility[i] = std::clamp(person.image[i].visibility, 0.0, 1.0);
  return visibility;
}

WorldKeypoints keypoints_at(const SeenPerson& person, double depth, const Intrinsics& camera) {
  const std::array<Vec3, kLandmarkCount> points = on_rays(person, depth, camera);
  WorldKeypoints placed;
  for (std::size_t i = 0; i < kLandmarkCount; ++i) placed[i] = {points[i], person.image[i].visibility};
  return placed;
}

std::array<Vec3, kLandmarkCount> points_of(const WorldKeypoints& placed) {
  std::array<Vec3, kLandmarkCount> points;
  for (std::size_t i = 0; i < kLandmarkCount; ++i) points[i] = placed[i].position_m;
  return points;
}

Mat3 world_from_camera(const Vec3& up) {
  const Vec3 towards_camera = glm::normalize(Vec3(0, 0, -1) - up * glm::dot(up, Vec3(0, 0, -1)));
  return glm::transpose(Mat3(glm::cross(up, towards_camera), up, towards_camera));
}

}  // namespace

void LiveLift::set_size(std::optional<Skeleton> body, std::optional<double> height_m) {
  body_ = std::move(body);
  height_m_ = height_m;
}

void LiveLift::reset() {
  std::optional<Skeleton> body = std::move(body_);
  const std::optional<double> height_m = height_m_;
  *this = LiveLift();
  set_size(std::move(body), height_m);
}

std::optional<LiveStudent> LiveLift::step(MediaTime time, const std::optional<SeenPerson>& person,
                                          int width_px, int height_px) {
  placed_.reset();
  if (width_px != width_px_ || height_px != height_px_) {
    reset();
    width_px_ = width_px;
    height_px_ = height_px;
  }
  if (!person) return std::nullopt;
  if (!recent_.empty() && to_seconds(time - recent_.back().time) > kForgotten_s) {
    window_.clear();
    recent_.clear();
    moving_since_.reset();
    depth_.reset();
  }
  const bool is_standing_now = is_standing(time, *person);
  if (is_standing_now || window_.empty()) remember(time, *person);
  if (!intrinsics_ || (new_in_window_ >= kSightingsAFit && camera_fits_ < kMostCameraFits))
    fit_camera(width_px, height_px);
  const std::optional<Vec3> place = fit_translation(*person, *intrinsics_);
  if (!place && !depth_) return std::nullopt;
  const double depth = place ? smooth_depth(time, place->z) : *depth_;
  if (!ground_ || new_in_window_ >= kSightingsAFit) fit_ground();
  recent_.push_back({time, *person});
  while (recent_.size() > 2 && to_seconds(time - recent_[1].time) > kRecent_s) recent_.pop_front();

  const double size = scale();
  const Mat3 turn = world_from_camera(ground_->up);
  LiveStudent student;
  placed_ = keypoints_at(*person, depth, *intrinsics_);
  const auto joints = landmark_body_positions(points_of(*placed_));
  for (std::size_t j = 0; j < kLandmarkBodyJointCount; ++j)
    student.positions[j] = turn * (size * (joints[j] - ground_->origin));
  for (WorldKeypoint& keypoint : *placed_) keypoint.position_m *= size;
  student.confidence = landmark_body_confidence(visibility_of(*person));
  student.camera = {width_px,
                    height_px,
                    intrinsics_->focal_px,
                    intrinsics_->centre_px,
                    glm::transpose(turn),
                    size * ground_->origin};
  student.side = side_of(student);
  return student;
}

bool LiveLift::is_standing(MediaTime time, const SeenPerson& person) {
  if (recent_.empty()) return true;
  const Sighting& before = recent_.front();
  if (speed_between(before.person, person, std::max(to_seconds(time - before.time), 0.5 * kRecent_s)) >
      kStandingSpeed)
    moving_since_ = time;
  // Slow moments at the top of a swing are not standing.
  return !moving_since_ || to_seconds(time - *moving_since_) > 0.5;
}

void LiveLift::remember(MediaTime time, const SeenPerson& person) {
  if (!window_.empty() && to_seconds(time - window_.back().time) < kWindowStep_s) return;
  window_.push_back({time, person});
  ++new_in_window_;
  while (to_seconds(time - window_.front().time) > kWindow_s) window_.pop_front();
  measured_size_.reset();
  measured_stature_.reset();
}

double LiveLift::smooth_depth(MediaTime time, double depth) {
  const double seconds = recent_.empty() ? 0.0 : to_seconds(time - recent_.back().time);
  if (!depth_)
    depth_ = depth;
  else
    *depth_ += (depth - *depth_) * (1 - std::exp(-seconds / kLiveDepthSmoothing_s));
  return *depth_;
}

void LiveLift::fit_camera(int width_px, int height_px) {
  std::vector<SeenPerson> people;
  for (const Sighting& sighting : window_) people.push_back(sighting.person);
  const double focal = estimate_focal_px(people, width_px, height_px);
  ++camera_fits_;
  // Each look counts as much as those before it together count once more: a running mean of the logarithm.
  const double mean = !intrinsics_ ? focal
                                   : std::exp(std::log(intrinsics_->focal_px) +
                                              std::log(focal / intrinsics_->focal_px) / camera_fits_);
  const double change = intrinsics_ ? mean / intrinsics_->focal_px : 1.0;
  intrinsics_ = {mean, {0.5 * width_px, 0.5 * height_px}};
  if (depth_) *depth_ *= change;
  if (ground_) ground_->origin.z *= change;
  measured_size_.reset();
  measured_stature_.reset();
}

std::vector<WorldKeypoints> LiveLift::placed_window() const {
  std::vector<WorldKeypoints> placed;
  for (const Sighting& sighting : window_)
    if (const auto place = fit_translation(sighting.person, *intrinsics_))
      placed.push_back(keypoints_at(sighting.person, place->z, *intrinsics_));
  return placed;
}

void LiveLift::fit_ground() {
  new_in_window_ = 0;
  std::vector<Vec3> positions;
  for (const WorldKeypoints& frame : placed_window()) {
    const auto joints = landmark_body_positions(points_of(frame));
    positions.insert(positions.end(), joints.begin(), joints.end());
  }
  if (positions.empty()) {
    if (!ground_) ground_ = Ground{{0, -1, 0}, {0, 1, *depth_}};
    return;
  }
  const Stance stance = estimate_stance(positions);
  const Vec3 up = glm::transpose(stance.world_from_camera) * Vec3(0, 1, 0);
  if (!ground_) ground_ = Ground{up, stance.origin};
  // The floor may rise and sink; the world does not follow him about.
  const double weight = camera_fits_ < kMostCameraFits / 2 ? 1 : kGroundWeight;
  ground_->up = glm::normalize(glm::mix(ground_->up, up, weight));
  ground_->origin += weight * glm::dot(stance.origin - ground_->origin, ground_->up) * ground_->up;
}

double LiveLift::scale() const {
  if (!body_ && !height_m_) return 1;
  if (!measured_size_ || !measured_stature_) {
    const std::vector<WorldKeypoints> frames = placed_window();
    const Result<Skeleton> measured = measure_landmark_body(frames);
    if (!measured) return 1;
    measured_size_ = arms_legs_and_torso(*measured);
    measured_stature_ = stature(*measured);
  }
  return body_ ? arms_legs_and_torso(*body_) / *measured_size_ : *height_m_ / *measured_stature_;
}

std::optional<Skeleton> LiveLift::provisional_body() const {
  if (body_) return body_;
  if (static_cast<int>(window_.size()) < kFewestForBody) return std::nullopt;
  const Result<Skeleton> measured = measure_landmark_body(placed_window(), {height_m_});
  return measured ? std::optional(*measured) : std::nullopt;
}

CameraSide LiveLift::side_of(const LiveStudent& student) {
  const auto at = [&](Landmark l) { return student.positions[static_cast<std::size_t>(landmark_joint(l))]; };
  const Vec3 across = at(Landmark::LeftHip) - at(Landmark::RightHip) + at(Landmark::LeftShoulder) -
                      at(Landmark::RightShoulder);
  const Vec3 front = glm::cross(across, Vec3(0, 1, 0));
  const bool is_still = !moving_since_ || *moving_since_ < recent_.back().time;
  // Who holds his finish stands still, too, and faces the target.
  const bool is_at_address = is_still && has_hands_down(joint_moment(student.positions, student.confidence));
  if (glm::length(front) > 1e-9 && (is_at_address || facing_ == Vec3(0)))
    facing_ += kFacingWeight * (glm::normalize(front) - facing_);
  return camera_side(facing_, student.camera.position() - student.positions[0]);
}

}  // namespace posecoach
