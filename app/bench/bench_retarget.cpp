#include <cmath>
#include <random>

#include "app/bench/bench.h"
#include "core/body/standard_body.h"
#include "core/motion/bundled_motion.h"
#include "core/retarget/streamed.h"
#include "core/retarget/webcam_noise.h"

namespace posecoach {
namespace {

// The bundled swing to and fro until it is as long as asked.
Result<Motion> long_swing(double seconds, double frames_per_second) {
  const Result<Motion> swing = bundled_motion("swing");
  if (!swing) return swing;
  const double once = to_seconds(swing->duration());
  std::vector<MediaTime> within, times;
  for (int f = 0; f < static_cast<int>(seconds * frames_per_second); ++f) {
    const double t = f / frames_per_second, phase = std::fmod(t, 2 * once);
    times.push_back(media_time_from_seconds(t));
    within.push_back(media_time_from_seconds(phase < once ? phase : 2 * once - phase));
  }
  std::vector<Vec3> roots;
  std::vector<Quat> rotations;
  for (const MediaTime time : within) {
    const Motion frame = resample(*swing, std::vector{time});
    roots.push_back(frame.position(0, 0));
    rotations.insert(rotations.end(), frame.rotations(0).begin(), frame.rotations(0).end());
  }
  return Motion::from_rotations(swing->skeleton(), std::move(times), std::move(roots), std::move(rotations));
}

}  // namespace

Result<void> bench_retarget(const BenchOptions&, std::vector<BenchRow>& rows) {
  const Result<Motion> coach = long_swing(10, 30);
  if (!coach) return tl::unexpected(coach.error());
  const Skeleton body = make_standard_body({.height_m = 1.65, .arms = 1.1, .shoulders = 0.9, .thighs = 1.05});
  for (const RetargetMethod method :
       {RetargetMethod::Rotation, RetargetMethod::Direction, RetargetMethod::Scale, RetargetMethod::Paper})
    for (const Contacts contacts : {Contacts::Off, Contacts::On}) {
      const std::string name = "retarget 300 frames, " + std::string(to_string(method)) +
                               (contacts == Contacts::On ? ", contacts" : "");
      rows.push_back(measure(name, 20, [&] { (void)retarget(*coach, body, {method, contacts}); }));
    }
  RetargetOptions positions;
  positions.rotations = RotationSource::Positions;
  rows.push_back(measure("retarget 300 frames, rotation from positions", 20,
                         [&] { (void)retarget(*coach, body, positions); }));
  std::mt19937_64 random(1);
  const Motion filmed = with_webcam_noise(*coach, random);
  RetargetOptions network;
  network.method = RetargetMethod::Network;
  rows.push_back(
      measure("retarget 300 filmed frames, network", 20, [&] { (void)retarget(filmed, body, network); }));
  StreamedRetargeter stream(filmed.skeleton(), body, network);
  const std::vector<double> sure(static_cast<std::size_t>(filmed.joint_count()), 1.0);
  int next = 0;
  const auto push = [&] {
    if (next == filmed.frame_count()) {
      stream.reset();
      next = 0;
    }
    (void)stream.push(filmed.time(next), filmed.positions(next), sure);
    ++next;
  };
  for (int f = 0; f < 60; ++f) push();  // until its memory is full
  rows.push_back(measure("retarget a frame of a filmed coach, network, streaming", 200, push));
  return {};
}

}  // namespace posecoach
