#include "core/pipeline/camera_fit.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/base/median.h"

namespace posecoach {
namespace {

// Over the picture's longer side. Main cameras of phones film at 0.7 to 0.8, webcams at 0.7 to 1; crops of a
// film look longer.
constexpr double kUsualFocal = 0.9;
constexpr double kUsualSpread = 0.35;  // of its logarithm

double weight_of(double visibility) {
  return visibility * visibility;
}

Vec2 project(const Vec3& p, const Intrinsics& camera) {
  return camera.focal_px * Vec2(p.x, p.y) / p.z + camera.centre_px;
}

std::optional<Vec3> solve(const Mat3& normal, const Vec3& right_side) {
  if (std::abs(glm::determinant(normal)) < 1e-18) return std::nullopt;
  const Vec3 solution = glm::inverse(normal) * right_side;
  if (!is_finite(solution)) return std::nullopt;
  return solution;
}

}  // namespace

std::optional<Vec3> fit_translation(const SeenPerson& person, const Intrinsics& camera) {
  Mat3 normal(0.0);
  Vec3 right_side(0);
  const auto add_row = [&](const Vec3& row, double value, double weight) {
    normal += weight * glm::outerProduct(row, row);
    right_side += weight * value * row;
  };
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    const Vec2 ray = (person.image[i].position_px - camera.centre_px) / camera.focal_px;
    const Vec3& p = person.world[i].position_m;
    const double weight = weight_of(person.image[i].visibility);
    add_row({1, 0, -ray.x}, ray.x * p.z - p.x, weight);
    add_row({0, 1, -ray.y}, ray.y * p.z - p.y, weight);
  }
  std::optional<Vec3> place = solve(normal, right_side);
  for (int iteration = 0; iteration < 4 && place; ++iteration) {
    normal = Mat3(0.0);
    right_side = Vec3(0);
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
      const Vec3 p = person.world[i].position_m + *place;
      if (p.z < 0.05) continue;
      const Vec2 miss = person.image[i].position_px - project(p, camera);
      // Far-off joints (a guessed arm) count less: weight of a Huber loss, 2 % of the person's distance wide.
      const double width = 0.02 * camera.focal_px;
      const double distance = glm::length(miss);
      const double weight =
          weight_of(person.image[i].visibility) * (distance > width ? width / distance : 1.0);
      const double scale = camera.focal_px / p.z;
      add_row(scale * Vec3(1, 0, -p.x / p.z), miss.x, weight);
      add_row(scale * Vec3(0, 1, -p.y / p.z), miss.y, weight);
    }
    const auto step = solve(normal, right_side);
    if (!step) break;
    *place += *step;
  }
  if (!place || place->z < 0.1) return std::nullopt;
  return place;
}

double reprojection_error_px(std::span<const SeenPerson> people, std::span<const Vec3> translations,
                             const Intrinsics& camera) {
  std::vector<double> distances;
  for (std::size_t frame = 0; frame < people.size(); ++frame)
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
      const Vec3 p = people[frame].world[i].position_m + translations[frame];
      if (p.z < 0.05 || people[frame].image[i].visibility < 0.5) continue;
      distances.push_back(glm::distance(project(p, camera), people[frame].image[i].position_px));
    }
  return distances.empty() ? 0 : median(std::move(distances));
}

double estimate_focal_px(std::span<const SeenPerson> people, int width_px, int height_px) {
  const double side = std::max(width_px, height_px);
  const Vec2 centre(0.5 * width_px, 0.5 * height_px);
  // A few dozen frames tell as much as all: their errors are the model's habits, not noise.
  const std::size_t step = std::max<std::size_t>(1, people.size() / 40);
  double best = kUsualFocal, best_cost = 1e300;
  for (double focal = 0.5; focal < 3.0; focal *= 1.06) {
    const Intrinsics camera{focal * side, centre};
    std::vector<SeenPerson> chosen;
    std::vector<Vec3> places;
    for (std::size_t i = 0; i < people.size(); i += step)
      if (const auto place = fit_translation(people[i], camera)) {
        chosen.push_back(people[i]);
        places.push_back(*place);
      }
    if (chosen.empty()) continue;
    const double error = std::max(reprojection_error_px(chosen, places, camera), 1e-3 * side);
    // Errors of the joints hang together, so a film counts as a handful of independent looks.
    constexpr double kIndependentLooks = 10;
    const double off = std::log(focal / kUsualFocal) / kUsualSpread;
    const double cost = kIndependentLooks * std::log(error) + 0.5 * off * off;
    if (cost < best_cost) {
      best_cost = cost;
      best = focal;
    }
  }
  return best * side;
}

}  // namespace posecoach
