// What an authored golf motion says about the body at an instant: numbers that a golf coach would use, for a
// right-hander (lead = left). World frame: target at +X, ball at +Z, up +Y. Mirror the result for
// left-handers.
//
// Turns are about the segment's own long axis, positive when it opens to the target. `bend` and `side` say
// where that axis points: forward towards the ball, and sideways away from the target. Hands and club swing
// in planes through the target line, inclined by `plane` degrees (90 is upright): angle 0 points down to the
// ball, -90 away from the target, -180 up the plane, -270 to the target; positive the other way round.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace posecoach {

enum class GolfChannel : unsigned char {
  PelvisTurn,  // degrees
  PelvisBend,
  PelvisSide,
  PelvisSway,    // cm towards the target, of the middle of the hips, from address, for a stature of 1.80 m
  PelvisLift,    // cm up
  PelvisThrust,  // cm towards the ball
  ChestTurn,
  ChestBend,
  ChestSide,
  HeadTurn,
  HeadBend,
  HeadSide,
  LeadShoulderForward,  // degrees of the collar bone from the chest, round the body
  LeadShoulderUp,
  TrailShoulderForward,
  TrailShoulderUp,
  HandsAngle,  // of the line from between the shoulders to the grip
  HandsPlane,
  HandsOut,   // degrees by which that line is pushed out towards the ball
  LeadElbow,  // degrees of bend that the arm keeps at least; the straighter arm carries the grip
  TrailElbow,
  LeadElbowOut,  // where the elbow points, in the chest's axes: away from the middle, down, back
  LeadElbowDown,
  LeadElbowBack,
  TrailElbowOut,
  TrailElbowDown,
  TrailElbowBack,
  ClubAngle,  // of the shaft, from the grip to the head
  ClubPlane,
  ClubRoll,     // of the shaft about itself with the forearms; negative opens the face
  BallAim,      // 0 to 1: how much the shaft is turned so that the head stands at the ball
  LeadKneeYaw,  // where the knee points on the ground; 0 is forward, positive to the target
  TrailKneeYaw,
  TrailHeelLift,  // degrees of the foot about the ball of the toes
  TrailFootSpin,  // degrees of the foot on the ball of the toes, towards the target
};
inline constexpr std::size_t kGolfChannelCount = 35;

// "pelvis_turn_deg", "pelvis_sway_cm", ... as written in files.
std::string_view to_string(GolfChannel channel);
std::optional<GolfChannel> golf_channel_from_string(std::string_view name);

struct GolfPose : std::array<double, kGolfChannelCount> {
  double& operator[](GolfChannel c) {
    return std::array<double, kGolfChannelCount>::operator[](static_cast<std::size_t>(c));
  }
  double operator[](GolfChannel c) const {
    return std::array<double, kGolfChannelCount>::operator[](static_cast<std::size_t>(c));
  }
};

}  // namespace posecoach
