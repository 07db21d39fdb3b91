#include "core/motion/authored/authored_motion.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"

namespace posecoach {

double AuthoredMotion::time_of(std::string_view event) const {
  const auto found =
      std::find_if(events.begin(), events.end(), [&](const AuthoredEvent& e) { return e.name == event; });
  POSECOACH_ASSERT(found != events.end());
  return found->time_s;
}

Result<AuthoredMotion> make_authored_motion(const GolfScript& script, const Skeleton& body,
                                            double frames_per_second, Handedness hand) {
  if (!(frames_per_second > 0 && frames_per_second <= 1000))
    return fail(ErrorCode::InvalidArgument,
                "the frame rate must be above 0 and at most 1000 frames per second");
  const bool left_handed = hand == Handedness::Left;
  // A left-hander is the right-hander in the mirror: pose the mirrored body, then mirror the motion back.
  const Result<GolferPoser> poser = GolferPoser::make(left_handed ? mirrored(body) : body, script);
  if (!poser) return tl::unexpected(poser.error());

  std::vector<MediaTime> times;
  std::vector<Vec3> roots;
  std::vector<Quat> rotations;
  std::vector<ClubPose> club;
  double deficit_m = 0;
  const auto frames = static_cast<int>(std::floor(script.duration_s() * frames_per_second + 1e-6)) + 1;
  for (int frame = 0; frame < frames; ++frame) {
    const double time_s = frame / frames_per_second;
    const GolferPose golfer = poser->pose(script.pose(time_s));
    times.push_back(media_time_from_seconds(time_s));
    roots.push_back(golfer.pose.root_position);
    rotations.insert(rotations.end(), golfer.pose.rotations.begin(), golfer.pose.rotations.end());
    club.push_back(golfer.club);
    deficit_m = std::max(deficit_m, golfer.deficit_m);
  }
  Result<Motion> motion = Motion::from_rotations(poser->body().skeleton, std::move(times), std::move(roots),
                                                 std::move(rotations));
  if (!motion) return tl::unexpected(motion.error());

  AuthoredMotion authored{*std::move(motion), std::move(club), {}, poser->ball(), deficit_m};
  for (const GolfInstant& instant : script.instants())
    authored.events.push_back({instant.name, instant.time_s});
  if (left_handed) {
    authored.motion = mirrored(authored.motion);
    for (ClubPose& pose : authored.club)
      pose = {mirrored(pose.butt), mirrored(pose.grip), mirrored(pose.head)};
    authored.ball = mirrored(authored.ball);
  }
  return authored;
}

}  // namespace posecoach
