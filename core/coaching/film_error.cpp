#include "core/coaching/film_error.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <span>

#include "core/base/assert.h"
#include "core/coaching/film_offset_table.h"

namespace posecoach {
namespace {

constexpr int kStagesPerEvent = 2;
// Between measured places that are no farther apart, offsets go over from one to the next; elsewhere the
// nearest one's fade out on this way.
constexpr double kNeighbours_deg = 25, kReach_deg = 20;
// Of films of the pose model that was measured, projected on its habits, 0.7 and more is seen, also of those
// with faults; of the one film of a real golfer that we have 0.9. Of true joints, nothing.
constexpr double kShownFully = 0.7, kNotShown = 0.3;

double degrees_apart(double a, double b) {
  return std::abs(std::remainder(a - b, 360));
}

struct Neighbours {
  std::size_t first = 0, second = 0;
  double part = 0;       // of the way from the first to the second
  double apart_deg = 0;  // from what is known
};

template <typename Cameras>
Neighbours neighbours_of(const Cameras& cameras, double camera_deg) {
  std::size_t nearest = 0;
  for (std::size_t k = 0; k + 1 < cameras.size(); ++k) {
    const double from = cameras[k].camera_deg, to = cameras[k + 1].camera_deg;
    if (camera_deg >= from && camera_deg <= to && to - from <= kNeighbours_deg)
      return {k, k + 1, (camera_deg - from) / (to - from), 0};
  }
  for (std::size_t k = 1; k < cameras.size(); ++k)
    if (degrees_apart(cameras[k].camera_deg, camera_deg) <
        degrees_apart(cameras[nearest].camera_deg, camera_deg))
      nearest = k;
  return {nearest, nearest, 0, degrees_apart(cameras[nearest].camera_deg, camera_deg)};
}

template <typename Cameras>
Vec3 offset_in(const Cameras& cameras, double camera_deg, std::size_t joint, int stage) {
  const Neighbours near = neighbours_of(cameras, camera_deg);
  const auto at = [&](std::size_t camera) {
    const auto* values = cameras[camera].joints[joint].data() + 3 * stage;
    return 0.001 * Vec3(values[0], values[1], values[2]);
  };
  return (1 - near.part) * at(near.first) + near.part * at(near.second);
}

double line_share(double camera_deg) {
  const double across = std::sin(radians_from_degrees(camera_deg));
  return across * across;
}

}  // namespace

FilmStages::FilmStages(const SwingEvents& stroke) : kind_(stroke.kind) {
  for (const SwingEvent& event : stroke.events) events_s_.push_back(event.time_s);
}

int FilmStages::count() const {
  return static_cast<int>(kind_ == StrokeKind::Putt ? kPuttStages : kSwingStages);
}

FilmStages::Phases FilmStages::phases() const {
  const int top = kind_ == StrokeKind::Putt ? 1 : 3, impact = kind_ == StrokeKind::Putt ? 2 : 5;
  return {0, kStagesPerEvent * top, kStagesPerEvent * impact, count()};
}

double FilmStages::weight(int stage, double time_s) const {
  const auto after = std::upper_bound(events_s_.begin() + 1, events_s_.end() - 1, time_s);
  const double part = (time_s - *(after - 1)) / (*after - *(after - 1));
  const double position =
      kStagesPerEvent * (static_cast<double>(after - events_s_.begin() - 1) + std::clamp(part, 0.0, 1.0));
  return std::max(0.0, 1 - std::abs(position - stage));
}

UsualFilmError::UsualFilmError(StrokeKind kind, double camera_deg)
    : is_film_(true), kind_(kind), camera_deg_(camera_deg) {
  const double apart_deg = kind == StrokeKind::Putt ? neighbours_of(kPuttOffsets, camera_deg).apart_deg
                                                    : neighbours_of(kSwingOffsets, camera_deg).apart_deg;
  share_ = std::clamp(1 - apart_deg / kReach_deg, 0.0, 1.0);
}

UsualFilmError UsualFilmError::between_films(bool from_one_side) const {
  UsualFilmError both = *this;
  both.are_offsets_alike_ = from_one_side;
  // Of two films from one side no more is left than of one: 18 faultless pairs of bodies score 96 to 100.
  both.left_times_ = from_one_side ? 1 : std::numbers::sqrt2;
  both.size_forgiven_ = 1;
  if (from_one_side) both.share_ = 0;
  return both;
}

UsualFilmError UsualFilmError::shown(double part) const {
  UsualFilmError film = *this;
  film.share_ *= std::clamp((part - kNotShown) / (kShownFully - kNotShown), 0.0, 1.0);
  return film;
}

Vec3 UsualFilmError::offset(HumanoidJoint joint, int stage) const {
  if (!is_film_ || are_offsets_alike_) return Vec3(0);
  if (joint == HumanoidJoint::Chest) joint = HumanoidJoint::Neck;
  const auto row = std::find(kOffsetJoints.begin(), kOffsetJoints.end(), joint);
  if (row == kOffsetJoints.end()) return Vec3(0);
  const auto index = static_cast<std::size_t>(row - kOffsetJoints.begin());
  return kind_ == StrokeKind::Putt ? offset_in(kPuttOffsets, camera_deg_, index, stage)
                                   : offset_in(kSwingOffsets, camera_deg_, index, stage);
}

double UsualFilmError::of(std::string_view part, int stage) const {
  if (!is_film_) return 0;
  return kind_ == StrokeKind::Putt ? of(kPuttFilmErrors, part, stage) : of(kSwingFilmErrors, part, stage);
}

template <typename Rows>
double UsualFilmError::of(const Rows& rows, std::string_view part, int stage) const {
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const auto& r) { return r.part == part; });
  POSECOACH_ASSERT(row != rows.end());
  const auto at = static_cast<std::size_t>(stage);
  const double line = line_share(camera_deg_);
  const double left =
      0.001 * left_times_ * std::lerp(row->left_face_on[at], row->left_down_the_line[at], line);
  if (are_offsets_alike_) return left;
  return left + 0.001 * (1 - share_ + size_forgiven_) *
                    std::lerp(row->size_face_on[at], row->size_down_the_line[at], line);
}

double camera_deg_of(const Vec3& sight, const Vec3& left, const Vec3& front) {
  return degrees_from_radians(std::atan2(-glm::dot(sight, left), -glm::dot(sight, front)));
}

}  // namespace posecoach
