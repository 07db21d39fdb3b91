#include "core/pipeline/track_repair.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

namespace posecoach {
namespace {

struct Track {
  std::vector<double> times_s;
  std::vector<SeenPerson> people;
};

// A person whose hands and hips swing from side to side, 30 frames a second; left landmarks at +0.2 m, right
// at -0.2 m.
Track swaying_person(double sway_m_per_frame = 0.03) {
  Track track;
  for (int f = 0; f < 40; ++f) {
    SeenPerson person;
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
      const auto landmark = static_cast<Landmark>(i);
      const double side = mirrored(landmark) == landmark ? 0 : landmark < mirrored(landmark) ? 0.2 : -0.2;
      const double x = side + sway_m_per_frame * 8 * std::sin(f / 8.0);
      person.world[i] = {{x, 0.05 * static_cast<double>(i), 0.1 * side}, 0.9};
      person.image[i] = {{400 + 300 * x, 20.0 * static_cast<double>(i)}, 0.9};
    }
    track.times_s.push_back(f / 30.0);
    track.people.push_back(person);
  }
  return track;
}

void exchange(SeenPerson& person) {
  const SeenPerson old = person;
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    const Landmark other = mirrored(static_cast<Landmark>(i));
    person.image[i] = old.image[other];
    person.world[i] = old.world[other];
  }
}

double largest_difference_m(const std::vector<SeenPerson>& a, const std::vector<SeenPerson>& b) {
  double largest = 0;
  for (std::size_t f = 0; f < a.size(); ++f)
    for (std::size_t i = 0; i < kLandmarkCount; ++i)
      largest = std::max(largest, glm::distance(a[f].world[i].position_m, b[f].world[i].position_m));
  return largest;
}

TEST(TrackRepair, an_honest_motion_is_left_alone) {
  const Track honest = swaying_person();
  Track track = honest;
  repair_people(track.times_s, track.people);
  EXPECT_EQ(largest_difference_m(track.people, honest.people), 0);
}

TEST(TrackRepair, exchanged_sides_go_back_whether_for_one_frame_or_for_ten) {
  for (const int last : {15, 24}) {
    const Track honest = swaying_person();
    Track track = honest;
    for (int f = 15; f <= last; ++f) exchange(track.people[static_cast<std::size_t>(f)]);
    EXPECT_GT(largest_difference_m(track.people, honest.people), 0.3);
    repair_people(track.times_s, track.people);
    EXPECT_EQ(largest_difference_m(track.people, honest.people), 0) << last;
  }
}

TEST(TrackRepair, a_person_who_turns_around_slowly_keeps_his_sides) {
  Track track = swaying_person(0);
  for (std::size_t f = 0; f < track.people.size(); ++f) {
    const double angle = 3.1 * static_cast<double>(f) / static_cast<double>(track.people.size());
    for (WorldKeypoint& point : track.people[f].world) {
      const Vec3 p = point.position_m;
      point.position_m = {std::cos(angle) * p.x + std::sin(angle) * p.z, p.y,
                          std::cos(angle) * p.z - std::sin(angle) * p.x};
    }
  }
  const Track honest = track;
  repair_people(track.times_s, track.people);
  EXPECT_EQ(largest_difference_m(track.people, honest.people), 0);
}

TEST(TrackRepair, a_joint_that_jumps_away_for_one_frame_comes_back_and_is_trusted_less) {
  const Track honest = swaying_person();
  Track track = honest;
  auto& wrist = track.people[20].world[Landmark::LeftWrist];
  wrist.position_m += Vec3(0.4, 0.3, 0);
  repair_people(track.times_s, track.people);
  EXPECT_LT(glm::distance(wrist.position_m, honest.people[20].world[Landmark::LeftWrist].position_m), 0.05);
  EXPECT_LT(wrist.visibility, 0.5);
  EXPECT_EQ(track.people[20].world[Landmark::RightWrist].visibility, 0.9);
}

TEST(TrackRepair, frames_far_apart_do_not_vouch_for_each_other) {
  Track track = swaying_person(0);
  // He goes away facing the camera and comes back with his back to it: his left is now really on the other
  // side.
  for (std::size_t f = 30; f < 40; ++f) {
    track.times_s[f] += 5;
    exchange(track.people[f]);
  }
  const Track honest = track;
  repair_people(track.times_s, track.people);
  EXPECT_EQ(largest_difference_m(track.people, honest.people), 0);
}

TEST(TrackRepair, nobody_and_a_single_frame_are_fine) {
  repair_people({}, {});
  Track track = swaying_person();
  track.times_s.resize(1);
  track.people.resize(1);
  repair_people(track.times_s, track.people);
  EXPECT_EQ(track.people[0].world[Landmark::LeftWrist].visibility, 0.9);
}

}  // namespace
}  // namespace posecoach
