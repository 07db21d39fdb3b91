#include "core/coaching/film_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/base/assert.h"

namespace posecoach {
namespace {

struct Row {
  std::string_view part;
  double swing_face_on, swing_down_the_line, putt_face_on, putt_down_the_line;
};

// A putt down the line cannot be divided into phases.
constexpr std::array kRows = {
    Row{"hips", 0.025, 0.023, 0.013, 0.008},      Row{"trunk", 0.072, 0.046, 0.073, 0.030},
    Row{"head", 0.123, 0.067, 0.181, 0.026},      Row{"lead_arm", 0.090, 0.133, 0.077, 0.096},
    Row{"trail_arm", 0.085, 0.096, 0.105, 0.072}, Row{"lead_leg", 0.046, 0.075, 0.037, 0.027},
    Row{"trail_leg", 0.043, 0.073, 0.048, 0.046}, Row{"backswing", 0.059, 0.059, 0.069, 0.034},
    Row{"downswing", 0.071, 0.059, 0.066, 0.034}, Row{"follow_through", 0.062, 0.066, 0.059, 0.034},
};

}  // namespace

UsualFilmError::UsualFilmError(StrokeKind kind, double line_share)
    : is_film_(true), kind_(kind), line_share_(line_share) {}

UsualFilmError UsualFilmError::between_films(bool from_one_side) const {
  // Of faultless full swings of six bodies, 15 pairs a side: 0.28 face-on and 0.23 down the line.
  constexpr double kLeftBetweenFilms = 0.28;
  UsualFilmError left = *this;
  left.share_left_ = from_one_side ? kLeftBetweenFilms : std::numbers::sqrt2;
  return left;
}

double UsualFilmError::of(std::string_view part) const {
  if (!is_film_) return 0;
  const auto row = std::find_if(kRows.begin(), kRows.end(), [&](const Row& r) { return r.part == part; });
  POSECOACH_ASSERT(row != kRows.end());
  return share_left_ * (kind_ == StrokeKind::Putt
                            ? std::lerp(row->putt_face_on, row->putt_down_the_line, line_share_)
                            : std::lerp(row->swing_face_on, row->swing_down_the_line, line_share_));
}

double line_share_of(const Vec3& sight, const Vec3& front) {
  const Vec3 level(sight.x, 0, sight.z), forward(front.x, 0, front.z);
  if (glm::length(level) < 1e-9 || glm::length(forward) < 1e-9) return 0.5;
  const double along = glm::dot(glm::normalize(level), glm::normalize(forward));
  return std::clamp(1 - along * along, 0.0, 1.0);
}

}  // namespace posecoach
