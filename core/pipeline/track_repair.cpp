#include "core/pipeline/track_repair.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <vector>

#include "core/base/assert.h"

namespace posecoach {
namespace {

using enum Landmark;

constexpr double kLongestGap_s = 0.3;
constexpr double kJump_m = 0.08;
// The model's own sides are right until the travel of a half of the body says otherwise by this much, metres:
// for an exchange, and for each frame that it lasts.
constexpr double kExchangeCost_m = 0.2;
constexpr double kExchangedFrameCost_m = 0.01;

constexpr std::array kUpperSide = {LeftEar, LeftShoulder, LeftElbow, LeftWrist};
constexpr std::array kLowerSide = {LeftHip, LeftKnee, LeftAnkle, LeftHeel, LeftFootIndex};

bool is_lower(Landmark landmark) {
  return landmark >= LeftHip;
}

void exchange_sides(SeenPerson& person, bool lower) {
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    const auto landmark = static_cast<Landmark>(i);
    const Landmark other = mirrored(landmark);
    if (landmark >= other || is_lower(landmark) != lower) continue;
    std::swap(person.image[landmark], person.image[other]);
    std::swap(person.world[landmark], person.world[other]);
  }
}

// How far the joints of one half of the body travel between two frames, metres, if the sides of one are
// exchanged or not.
double travel(const SeenPerson& from, const SeenPerson& to, std::span<const Landmark> side, bool exchanged) {
  double sum = 0;
  for (const Landmark left : side) {
    const Landmark right = mirrored(left);
    sum += glm::distance(from.world[left].position_m, to.world[exchanged ? right : left].position_m);
    sum += glm::distance(from.world[right].position_m, to.world[exchanged ? left : right].position_m);
  }
  return sum;
}

// The least travel over the whole film decides for each frame (Viterbi over two states).
void repair_sides(std::span<const double> times_s, std::span<SeenPerson> people,
                  std::span<const Landmark> side, bool lower) {
  struct Step {
    std::array<bool, 2> from_exchanged{};
  };
  std::vector<Step> steps(people.size());
  std::array<double, 2> cost{};
  for (std::size_t f = 1; f < people.size(); ++f) {
    std::array<double, 2> next{};
    const bool apart = times_s[f] - times_s[f - 1] > kLongestGap_s;
    const double same = apart ? 0 : travel(people[f - 1], people[f], side, false);
    const double crossed = apart ? 0 : travel(people[f - 1], people[f], side, true);
    for (const std::size_t state : {0U, 1U}) {
      const double stay = cost[state] + same, change = cost[1 - state] + crossed + kExchangeCost_m;
      steps[f].from_exchanged[state] = (stay <= change ? state : 1 - state) == 1;
      next[state] = std::min(stay, change) + (state == 1 ? kExchangedFrameCost_m : 0);
    }
    cost = next;
  }
  std::vector<bool> exchanged(people.size());
  bool state = cost[1] < cost[0];
  for (std::size_t f = people.size(); f-- > 0;) {
    exchanged[f] = state;
    state = steps[f].from_exchanged[state ? 1 : 0];
  }
  const auto count = static_cast<std::size_t>(std::count(exchanged.begin(), exchanged.end(), true));
  const bool mostly = 2 * count > people.size();
  for (std::size_t f = 0; f < people.size(); ++f)
    if (exchanged[f] != mostly) exchange_sides(people[f], lower);
}

double median_of(std::array<double, 5> values) {
  std::nth_element(values.begin(), values.begin() + 2, values.end());
  return values[2];
}

void repair_jumps(std::span<const double> times_s, std::span<SeenPerson> people) {
  if (people.size() < 5) return;
  const std::vector<SeenPerson> seen(people.begin(), people.end());
  for (std::size_t f = 2; f + 2 < people.size(); ++f) {
    if (times_s[f + 2] - times_s[f - 2] > kLongestGap_s) continue;
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
      const auto middle = [&](auto value) {
        std::array<double, 5> values{};
        for (std::size_t k = 0; k < 5; ++k) values[k] = value(seen[f + k - 2]);
        return median_of(values);
      };
      const Vec3 usual(middle([&](const SeenPerson& p) { return p.world[i].position_m.x; }),
                       middle([&](const SeenPerson& p) { return p.world[i].position_m.y; }),
                       middle([&](const SeenPerson& p) { return p.world[i].position_m.z; }));
      // A jump comes back: the neighbours agree with each other better than with the frame between them.
      const Vec3& before = seen[f - 1].world[i].position_m;
      const Vec3& after = seen[f + 1].world[i].position_m;
      const double away = glm::distance(seen[f].world[i].position_m, usual);
      if (away < kJump_m || away < glm::distance(before, after)) continue;
      SeenPerson& person = people[f];
      person.world[i].position_m = usual;
      person.image[i].position_px = {middle([&](const SeenPerson& p) { return p.image[i].position_px.x; }),
                                     middle([&](const SeenPerson& p) { return p.image[i].position_px.y; })};
      person.world[i].visibility *= 0.5;
      person.image[i].visibility *= 0.5;
    }
  }
}

}  // namespace

void repair_people(std::span<const double> times_s, std::span<SeenPerson> people) {
  POSECOACH_ASSERT(times_s.size() == people.size());
  repair_sides(times_s, people, kUpperSide, false);
  repair_sides(times_s, people, kLowerSide, true);
  repair_jumps(times_s, people);
}

}  // namespace posecoach
