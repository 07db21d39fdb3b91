// Which part of the body turns fastest when on the way down: good golfers' pelvis comes first, then the
// chest, then the lead arm. The peaks are 20 ms apart (Cheetham 2008), so the order is told only where every
// gap is longer than a frame.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/coaching/joint_track.h"
#include "core/coaching/swing_events.h"

namespace posecoach {

enum class Segment { Pelvis, Chest, LeadArm };
inline constexpr std::size_t kSegmentCount = 3;

struct SegmentPeak {
  Segment segment = Segment::Pelvis;
  double speed_deg_s = 0;
  double before_impact_s = 0;
};

struct KinematicSequence {
  std::array<SegmentPeak, kSegmentCount> peaks;  // from the ground up
  std::vector<Segment> order;                    // first peak first; empty where frames cannot tell
  bool is_from_the_ground_up() const;
};

// Of a right-hander's full swing.
KinematicSequence kinematic_sequence(const JointTrack& track, const SwingEvents& swing);

}  // namespace posecoach
