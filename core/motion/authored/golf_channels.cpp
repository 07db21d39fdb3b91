#include "core/motion/authored/golf_channels.h"

namespace posecoach {
namespace {

constexpr std::array<std::string_view, kGolfChannelCount> kNames = {
    "pelvis_turn_deg",
    "pelvis_bend_deg",
    "pelvis_side_deg",
    "pelvis_sway_cm",
    "pelvis_lift_cm",
    "pelvis_thrust_cm",
    "chest_turn_deg",
    "chest_bend_deg",
    "chest_side_deg",
    "head_turn_deg",
    "head_bend_deg",
    "head_side_deg",
    "lead_shoulder_forward_deg",
    "lead_shoulder_up_deg",
    "trail_shoulder_forward_deg",
    "trail_shoulder_up_deg",
    "hands_angle_deg",
    "hands_plane_deg",
    "hands_out_deg",
    "lead_elbow_deg",
    "trail_elbow_deg",
    "lead_elbow_out",
    "lead_elbow_down",
    "lead_elbow_back",
    "trail_elbow_out",
    "trail_elbow_down",
    "trail_elbow_back",
    "club_angle_deg",
    "club_plane_deg",
    "club_roll_deg",
    "ball_aim",
    "lead_knee_yaw_deg",
    "trail_knee_yaw_deg",
    "trail_heel_lift_deg",
    "trail_foot_spin_deg",
};

}  // namespace

std::string_view to_string(GolfChannel channel) {
  return kNames[static_cast<std::size_t>(channel)];
}

std::optional<GolfChannel> golf_channel_from_string(std::string_view name) {
  for (std::size_t i = 0; i < kGolfChannelCount; ++i)
    if (kNames[i] == name) return static_cast<GolfChannel>(i);
  return std::nullopt;
}

}  // namespace posecoach
