// From golf numbers to a body's pose: pelvis and back by rotation, both hands on the grip and both feet on
// the ground by inverse kinematics. All bones keep their lengths, the club is fitted to the body, as good
// golfers' clubs are, and the hands stay in one relation to it.
#pragma once

#include "core/body/forward_kinematics.h"
#include "core/motion/authored/golf_script.h"
#include "core/motion/authored/golfer_body.h"

namespace posecoach {

// The shaft's ends and the point between the hands; world, metres.
struct ClubPose {
  Vec3 butt, grip, head;
};

struct GolferPose {
  Pose pose;
  ClubPose club;
  double deficit_m = 0;  // by how much hands or feet miss their places, the worst of the four
};

class GolferPoser {
 public:
  // Fits the club to the body and, where no club is long or short enough, the script's address to the club:
  // bends it so that the club reaches the ground. Lays the ball there. Errors: Incomplete, see GolferBody.
  static Result<GolferPoser> make(const Skeleton& skeleton, const GolfScript& script);

  GolferPose pose(const GolfPose& numbers) const;
  // Where the club's head stands at address.
  const Vec3& ball() const { return ball_; }
  const GolferBody& body() const { return body_; }

 private:
  explicit GolferPoser(GolferBody body) : body_(std::move(body)) {}

  struct Torso;
  struct Grip;
  Quat segment_rotation(double turn_deg, double bend_deg, double side_deg) const;
  double address_hips_height() const;
  Torso place_torso(const GolfPose& numbers) const;
  void place_head(const GolfPose& numbers, std::vector<Quat>& global) const;
  Grip place_grip(const GolfPose& numbers, const std::array<Vec3, 2>& shoulders) const;
  double place_arms(const GolfPose& numbers, const Grip& grip, const std::array<Vec3, 2>& shoulders,
                    std::vector<Quat>& global) const;
  double place_legs(const GolfPose& numbers, const std::array<Vec3, 2>& hips,
                    std::vector<Quat>& global) const;
  Vec3 planted_ankle(int side) const;
  struct Foot;
  Foot foot(int side, const GolfPose& numbers) const;
  void fit_club(const GolfPose& address);
  void fit_address(const GolfPose& address);
  void fit_impact(const GolfPose& written, const GolfPose& impact);

  GolferBody body_;
  GolfClub club_;
  GolfStance stance_;
  double hips_height_m_ = 0;     // at address
  double bend_offset_deg_ = 0;   // of the whole motion, for this body
  double hips_offset_m_ = 0;     // down, likewise
  double lie_offset_deg_ = 0;    // of the shaft, likewise
  Quat aim_at_impact_;           // of the shaft, where the numbers say BallAim
  double sink_at_impact_m_ = 0;  // of the hips, likewise
  Vec3 ball_;
};

}  // namespace posecoach
