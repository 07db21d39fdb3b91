// Finds strokes while they happen, from the body alone: the golfer stands still at address with both hands on
// the club, the hands go back, come through where they were, and go out on the other side to their finish.
// Waggles come back to where they began, people who walk about have no address.
//
// The less the hands tremble at address, the shorter a putt may be. What the camera cannot see of the hands'
// way, because it runs along its line of sight, the shoulders tell (pendulum.h): from behind, a putt is found
// by them.
#pragma once

#include <deque>
#include <optional>

#include "core/base/time.h"
#include "core/coaching/joint_moment.h"
#include "core/coaching/pendulum.h"
#include "core/coaching/sight.h"
#include "core/coaching/swing_events.h"

namespace posecoach {

struct FoundSwing {
  StrokeKind kind = StrokeKind::FullSwing;
  MediaTime begin;  // the hands leave the address
  MediaTime end;    // they rest at the finish
};

class SwingFinder {
 public:
  enum class Phase {
    Searching,
    AtAddress,  // still, hands on the club
    Swinging    // the hands have left; a stroke, or something else
  };

  // Poses in the order of their time; a gap of over half a second begins anew. Answers in the step that saw
  // the end of a stroke.
  std::optional<FoundSwing> step(MediaTime time, const JointMoment& student, const Sight& sight);
  Phase phase() const { return phase_; }
  // How long the golfer has been at address, seconds.
  double address_s() const { return address_s_; }
  void reset() { *this = SwingFinder(); }

 private:
  // Lengths in torsos.
  struct Sample {
    MediaTime time;
    Vec3 hands;  // over the pelvis
    Vec3 feet;
  };
  struct Stroke {
    MediaTime begin;
    Vec3 rest, feet;
    Vec3 back;     // farthest from rest before the hands came through
    Vec3 through;  // farthest from rest afterwards
    std::optional<MediaTime> passed_at;
  };

  void follow_posture(MediaTime time, const JointMoment& student);
  std::optional<Sample> sample_of(MediaTime time, const JointMoment& student, const Sight& sight);
  // How much the hands trembled about their mean; nothing where they, or the feet, moved.
  std::optional<double> trembling(double seconds, double hands_within) const;
  bool is_resting(double seconds, double hands_within) const;
  bool is_creeping(double spread) const;  // more than the trembling at address
  double shortest() const;                // strokes, in parts of those that much trembling allows
  double near_rest() const;
  bool passes_rest() const;
  Vec3 mean_hands(double seconds) const;
  bool has_hands_on_club(const JointMoment& student, const Sight& sight) const;
  void search(const JointMoment& student, const Sight& sight, double seconds);
  std::optional<FoundSwing> follow(const JointMoment& student, const Sight& sight);
  std::optional<FoundSwing> go_through();
  double slowness() const;  // 1 for a swing at its usual pace
  void give_up();

  Phase phase_ = Phase::Searching;
  double torso_m_ = 0;
  std::optional<PuttPosture> posture_;  // of late; as it was at address while the hands are away
  double address_s_ = 0;
  std::deque<Sample> samples_;
  Vec3 rest_;  // of the hands at address
  double trembling_ = 0;
  Vec3 rest_feet_;
  MediaTime near_rest_at_;  // when they were last there
  Stroke stroke_;
};

}  // namespace posecoach
