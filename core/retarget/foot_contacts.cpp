#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/index.h"
#include "core/retarget/feet.h"
#include "core/retarget/root_path.h"
#include "core/retarget/smoothing.h"
#include "core/retarget/t_pose.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

// All for legs of this length; hysteresis between coming to rest and leaving.
constexpr double kUsualLeg_m = 0.85;
struct Limits {
  double land_speed_m_s, leave_speed_m_s;
  double land_height_m, leave_height_m;
};
// A heel that has come up a little no longer stands; toes bend in shoes.
constexpr Limits kAnkleLimits{0.15, 0.30, 0.025, 0.035};
constexpr Limits kToeLimits{0.15, 0.35, 0.04, 0.06};
constexpr double kShortest_s = 0.12;
constexpr double kSpeedWindow_s = 0.05;
constexpr double kNoiseSmoothing_s = 0.04;
// Toes that dip below the floor and feet in the air do not decide how high the floor is.
constexpr double kNearGround_m = 0.12;

// One point of one foot over time.
struct Track {
  std::vector<Vec3> places;
  std::vector<double> speeds;
  double usual_height = 0;
};

Track track_of(const Motion& coach, int joint) {
  Track track;
  for (int f = 0; f < coach.frame_count(); ++f) track.places.push_back(coach.position(f, joint));
  track.places = smoothed_over_time(track.places, coach.times(), kNoiseSmoothing_s);
  for (int f = 0; f < coach.frame_count(); ++f) {
    const auto [first, last] = frames_within(coach.times(), index(f), kSpeedWindow_s);
    const double seconds = to_seconds(coach.times()[last] - coach.times()[first]);
    track.speeds.push_back(seconds > 0 ? glm::distance(track.places[last], track.places[first]) / seconds
                                       : 0.0);
  }
  return track;
}

double at_share(std::vector<double> values, double share) {
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// Sets both tracks' usual heights: the middle of the heights at which each point rests near the ground.
void find_usual_heights(std::array<Track, 2>& feet, double size) {
  std::vector<double> all;
  for (const Track& track : feet)
    for (const Vec3& place : track.places) all.push_back(place.y);
  const double low = at_share(all, 0.05);
  for (Track& track : feet) {
    std::vector<double> resting;
    for (std::size_t f = 0; f < track.places.size(); ++f)
      if (track.speeds[f] < kAnkleLimits.land_speed_m_s * size &&
          track.places[f].y < low + kNearGround_m * size)
        resting.push_back(track.places[f].y);
    track.usual_height = resting.empty() ? low : at_share(resting, 0.5);
  }
}

std::vector<bool> rests(const Track& track, const Limits& limits, double size,
                        std::span<const MediaTime> times) {
  std::vector<bool> planted(track.places.size());
  bool now = false;
  for (std::size_t f = 0; f < planted.size(); ++f) {
    const double speed = track.speeds[f] / size;
    const double height = (track.places[f].y - track.usual_height) / size;
    now = now ? speed < limits.leave_speed_m_s && height < limits.leave_height_m
              : speed < limits.land_speed_m_s && height < limits.land_height_m;
    planted[f] = now;
  }
  // Short rests are none, except where the whole motion is short.
  for (std::size_t begin = 0; begin < planted.size(); ++begin) {
    if (!planted[begin]) continue;
    std::size_t end = begin;
    while (end + 1 < planted.size() && planted[end + 1]) ++end;
    const bool whole = begin == 0 && end + 1 == planted.size();
    if (!whole && to_seconds(times[end] - times[begin]) < kShortest_s)
      for (std::size_t f = begin; f <= end; ++f) planted[f] = false;
    begin = end;
  }
  return planted;
}

std::vector<PlantedFoot> contacts_from(const std::vector<bool>& ankle, const std::vector<bool>& toe) {
  std::vector<PlantedFoot> contacts;
  for (std::size_t i = 0; i < ankle.size(); ++i) {
    const int f = static_cast<int>(i);
    if (!ankle[i] && !toe[i]) continue;
    const FootAnchor anchor = ankle[i] ? FootAnchor::Ankle : FootAnchor::Toe;
    if (contacts.empty() || contacts.back().end != f || contacts.back().anchor != anchor)
      contacts.push_back({f, f, anchor});
    contacts.back().end = f + 1;
  }
  return contacts;
}

}  // namespace

int anchor_joint(const Skeleton& skeleton, FootAnchor anchor, bool left) {
  const int toe = skeleton.find(left ? LeftToe : RightToe);
  return anchor == FootAnchor::Toe && toe != kNoJoint ? toe : skeleton.find(left ? LeftAnkle : RightAnkle);
}

FootContacts find_foot_contacts(const Motion& coach) {
  const Skeleton& skeleton = coach.skeleton();
  const double size = skeleton.leg_length() / kUsualLeg_m;
  std::array ankles = {track_of(coach, skeleton.find(LeftAnkle)), track_of(coach, skeleton.find(RightAnkle))};
  find_usual_heights(ankles, size);
  std::array<std::vector<bool>, 2> ankle_rests, toe_rests;
  for (std::size_t side = 0; side < 2; ++side) {
    ankle_rests[side] = rests(ankles[side], kAnkleLimits, size, coach.times());
    toe_rests[side].assign(coach.times().size(), false);
  }
  if (skeleton.has(LeftToe) && skeleton.has(RightToe)) {
    std::array toes = {track_of(coach, skeleton.find(LeftToe)), track_of(coach, skeleton.find(RightToe))};
    find_usual_heights(toes, size);
    for (std::size_t side = 0; side < 2; ++side)
      toe_rests[side] = rests(toes[side], kToeLimits, size, coach.times());
  }
  const TPose t_pose = make_t_pose(skeleton);
  double floor = 0;
  for (const auto& [track, role] : {std::pair(&ankles[0], LeftAnkle), std::pair(&ankles[1], RightAnkle)})
    floor += 0.5 * (track->usual_height - sole_clearance(skeleton, t_pose, skeleton.find(role)));
  return {contacts_from(ankle_rests[0], toe_rests[0]), contacts_from(ankle_rests[1], toe_rests[1]), floor};
}

}  // namespace posecoach
