#include "core/pipeline/stance.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "core/base/assert.h"
#include "core/base/median.h"
#include "core/body/landmark_body.h"

namespace posecoach {
namespace {

constexpr std::size_t kJoints = kLandmarkBodyJointCount;
using FramePositions = std::span<const Vec3, kJoints>;

const Vec3& at(FramePositions frame, Landmark landmark) {
  return frame[static_cast<std::size_t>(landmark_joint(landmark))];
}

FramePositions frame_of(std::span<const Vec3> positions, std::size_t frame) {
  return positions.subspan(frame * kJoints).first<kJoints>();
}

Vec3 middle_of(const std::vector<Vec3>& values) {
  Vec3 result;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> parts;
    for (const Vec3& value : values) parts.push_back(value[axis]);
    result[axis] = median(std::move(parts));
  }
  return result;
}

// Masses of segments as shares of the body, at their middles; after de Leva (1996), trunk and head as one.
Vec3 centre_of_mass(FramePositions frame) {
  using enum Landmark;
  Vec3 sum = 0.08 * 0.5 * (at(frame, LeftEar) + at(frame, RightEar));
  sum += 0.43 * 0.25 *
         (at(frame, LeftShoulder) + at(frame, RightShoulder) + at(frame, LeftHip) + at(frame, RightHip));
  sum += 0.05 * (at(frame, LeftElbow) + at(frame, RightElbow));
  sum += 0.14 * 0.5 * (at(frame, LeftHip) + at(frame, LeftKnee) + at(frame, RightHip) + at(frame, RightKnee));
  sum += 0.06 * 0.5 *
         (at(frame, LeftKnee) + at(frame, LeftAnkle) + at(frame, RightKnee) + at(frame, RightAnkle));
  return sum / (0.08 + 0.43 + 0.10 + 0.28 + 0.12);
}

Vec3 foot_centre(FramePositions frame) {
  using enum Landmark;
  return 0.25 *
         (at(frame, LeftHeel) + at(frame, RightHeel) + at(frame, LeftFootIndex) + at(frame, RightFootIndex));
}

// How far to each side of a frame its speed is looked at; and frames nearer to each other than half of it
// tell one place together, so that in a film of many frames a second trembling is no speed.
constexpr double kSpeedReach_s = 0.067;

double wrist_and_hip_speed(std::span<const Vec3> positions, std::size_t frame, std::size_t reach) {
  const std::size_t frames = positions.size() / kJoints;
  const std::size_t around = (reach - 1) / 2;
  const auto place = [&](std::size_t middle, Landmark landmark) {
    const std::size_t first = middle > around ? middle - around : 0,
                      last = std::min(frames - 1, middle + around);
    Vec3 sum(0);
    for (std::size_t f = first; f <= last; ++f) sum += at(frame_of(positions, f), landmark);
    return sum / static_cast<double>(last - first + 1);
  };
  const std::size_t before = frame > reach ? frame - reach : 0, after = std::min(frames - 1, frame + reach);
  double sum = 0;
  for (const Landmark landmark :
       {Landmark::LeftWrist, Landmark::RightWrist, Landmark::LeftHip, Landmark::RightHip})
    sum += glm::distance(place(before, landmark), place(after, landmark));
  return sum / static_cast<double>(after - before);
}

// Before the fastest moment of the film (a golfer stands on both feet until he has hit the ball, and on one
// afterwards), the third of the frames in which wrists and hips move least; all of them in a very short film.
std::vector<std::size_t> still_frames(std::span<const Vec3> positions, std::size_t frames,
                                      double frames_per_second) {
  std::vector<std::size_t> order(frames);
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (frames < 6) return order;
  const auto reach = static_cast<std::size_t>(std::max(2L, std::lround(kSpeedReach_s * frames_per_second)));
  std::vector<double> speed;
  for (std::size_t f = 0; f < frames; ++f) speed.push_back(wrist_and_hip_speed(positions, f, reach));
  const auto fastest = static_cast<std::size_t>(std::max_element(speed.begin(), speed.end()) - speed.begin());
  order.resize(std::max<std::size_t>(fastest, 6));
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return speed[a] < speed[b]; });
  order.resize(std::max<std::size_t>(3, order.size() / 3));
  std::sort(order.begin(), order.end());
  return order;
}

// Tilts of the camera against gravity: `pitch` > 0 looks down, `roll` > 0 leans to its right.
struct Tilt {
  double pitch = 0, roll = 0;
};

// From a direction that is up, in camera axes (level camera: 0, -1, 0).
Tilt tilt_of_up(const Vec3& up) {
  return {std::atan2(-up.z, -up.y), std::atan2(up.x, -up.y)};
}

// The plane through heels and toes, as the tilt of its normal; nothing when the four points make no plane.
std::optional<Tilt> tilt_of_feet(const std::array<Vec3, 4>& feet) {
  const Vec3 across = 0.5 * (feet[0] + feet[1] - feet[2] - feet[3]);  // left foot from right foot
  const Vec3 along = 0.5 * (feet[1] + feet[3] - feet[0] - feet[2]);   // toes from heels
  Vec3 normal = glm::cross(across, along);
  if (glm::length(across) < 0.08 || glm::length(along) < 0.08 ||
      glm::length(normal) < 0.3 * glm::length(across) * glm::length(along))
    return std::nullopt;
  normal = glm::normalize(normal.y > 0 ? -normal : normal);
  return tilt_of_up(normal);
}

// How far each witness may be off, degrees: cameras stand level but look down at a person; a balanced body is
// over its feet to a hand's breadth; the model's depth of toes and heels is poor.
constexpr double kLevelPitch = 8, kLevelRoll = 2.5, kBalance = 4, kFeet = 10;

Tilt combined_tilt(const Tilt& balance, const std::optional<Tilt>& feet) {
  const auto weigh = [](double sigma) { return 1 / (sigma * sigma); };
  double pitch = balance.pitch * weigh(kBalance), roll = balance.roll * weigh(kBalance);
  double pitch_weight = weigh(kBalance) + weigh(kLevelPitch),
         roll_weight = weigh(kBalance) + weigh(kLevelRoll);
  constexpr double kBelievable = radians_from_degrees(30);
  if (feet && std::abs(feet->pitch) < kBelievable && std::abs(feet->roll) < kBelievable) {
    pitch += feet->pitch * weigh(kFeet);
    roll += feet->roll * weigh(kFeet);
    pitch_weight += weigh(kFeet);
    roll_weight += weigh(kFeet);
  }
  return {pitch / pitch_weight, roll / roll_weight};
}

}  // namespace

Stance estimate_stance(std::span<const Vec3> positions, double frames_per_second) {
  POSECOACH_ASSERT(!positions.empty() && positions.size() % kJoints == 0);
  Stance stance;
  stance.still_frames = still_frames(positions, positions.size() / kJoints, frames_per_second);

  std::vector<Vec3> balance, feet_centres;
  std::array<std::vector<Vec3>, 4> feet;
  constexpr std::array<Landmark, 4> kFootPoints = {Landmark::LeftHeel, Landmark::LeftFootIndex,
                                                   Landmark::RightHeel, Landmark::RightFootIndex};
  for (const std::size_t f : stance.still_frames) {
    const FramePositions frame = frame_of(positions, f);
    balance.push_back(centre_of_mass(frame) - foot_centre(frame));
    feet_centres.push_back(foot_centre(frame));
    for (std::size_t i = 0; i < 4; ++i) feet[i].push_back(at(frame, kFootPoints[i]));
  }
  const Tilt tilt = combined_tilt(
      tilt_of_up(middle_of(balance)),
      tilt_of_feet({middle_of(feet[0]), middle_of(feet[1]), middle_of(feet[2]), middle_of(feet[3])}));

  const Vec3 up = glm::normalize(Vec3(std::tan(tilt.roll), -1, -std::tan(tilt.pitch)));
  const Vec3 towards_camera = glm::normalize(Vec3(0, 0, -1) - up * glm::dot(up, Vec3(0, 0, -1)));
  stance.world_from_camera = glm::transpose(Mat3(glm::cross(up, towards_camera), up, towards_camera));

  std::vector<double> floor;
  for (const std::size_t f : stance.still_frames) {
    std::array<double, 4> heights{};
    for (std::size_t i = 0; i < 4; ++i) heights[i] = glm::dot(up, at(frame_of(positions, f), kFootPoints[i]));
    std::sort(heights.begin(), heights.end());
    floor.push_back(0.5 * (heights[0] + heights[1]));
  }
  const Vec3 under = middle_of(feet_centres);
  stance.origin = under + up * (median(std::move(floor)) - glm::dot(up, under));
  return stance;
}

}  // namespace posecoach
