// When events of somebody seen by one camera happened, told by what that side of him shows best: the path of
// the hands alone, which tells them through joints, is hidden there, runs along the line of sight, or
// trembles. A right-hander's, as everything in comparing. Each is off by its habit still (film_habits.h), and
// nothing where the film does not show enough of it.
#pragma once

#include <optional>

#include "core/coaching/joint_track.h"
#include "core/coaching/sight.h"
#include "core/coaching/swing_events.h"
#include "core/coaching/viewpoint.h"

namespace posecoach {

struct SeenStroke {
  const SwingEvents& found;
  const JointTrack& track;
  const Sight& sight;
  Viewpoint view;
  double slow = 1;  // how many times as slowly as usual it is played; times to look at grow with it
};

// The middle of the hands' turn: of swings, and of putts from in front.
double top_in_film(const SeenStroke& stroke);

// A putt seen down the line, told by how far the shoulder line has turned across the picture (pendulum.h).
// Its rise and fall, of which a pose model shows a third, says less. Near the ball joints stick to where they
// rested: how long they take on their way there tells when they pass it.
struct PuttDownTheLine {
  double takeaway_s = 0, top_s = 0, impact_s = 0;
};
std::optional<PuttDownTheLine> putt_down_the_line(const SeenStroke& stroke);

// Of a full swing seen down the line. The shaft is level when the hands have risen a third of their way to
// where the lead arm is, for the arms' angle takes in their depth.
std::optional<double> toe_up_down_the_line(const SeenStroke& stroke);

// Of a full swing seen down the line, where the hands go back along the line of sight: when the lead shoulder
// and the trail wrist begin to move across it, as people begin a way. `toe_up_s` ends the way that is looked
// at.
std::optional<double> takeaway_down_the_line(const SeenStroke& stroke, double toe_up_s);

// Of a full swing. Hands that settle behind the head tremble, and their last centimetre takes a fifth of a
// second. The body comes to rest with them: seen from in front the head tells it, from down the line head and
// neck over the pelvis, by the whole of their way since the follow-through and not only its end.
std::optional<double> finish_in_film(const SeenStroke& stroke);

}  // namespace posecoach
