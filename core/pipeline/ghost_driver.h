// The coach's ghost beside the student: which moment of the coach, where on the floor, how close.
#pragma once

#include <memory>
#include <optional>

#include "core/body/landmark_body.h"
#include "core/coaching/follow_along.h"
#include "core/coaching/joint_moment.h"
#include "core/pipeline/coach_snapshot.h"
#include "core/pipeline/personal_coach.h"

namespace posecoach {

// The canonical joints of a webcam body.
JointMoment joint_moment(std::span<const Vec3, kLandmarkBodyJointCount> positions,
                         std::span<const double, kLandmarkBodyJointCount> confidence);

// At address and while he stands about: at the top and in the finish his body is turned.
bool has_hands_down(const JointMoment& student);

class GhostDriver {
 public:
  // Nothing: no ghost. A coach in another body goes on where the old one was.
  void set_coach(std::shared_ptr<const PersonalCoach> coach);
  const std::shared_ptr<const PersonalCoach>& coach() const { return coach_; }
  void set_pace(Pace pace, double speed);

  // `hands` is how fast the student moves now: a ghost does not shift its feet in the middle of a swing.
  std::optional<Ghost> step(MediaTime time, const JointMoment& student, const Sight& sight,
                            const HandSpeed& hands);
  // The student is gone.
  void reset();

 private:
  void place(MediaTime time, const JointMoment& student, const HandSpeed& hands);
  // By how much the coach is turned to face as the student does.
  double yaw() const;
  double coach_time(MediaTime time, const JointMoment& student, const Sight& sight);
  double play(MediaTime time);
  Ghost ghost_at(double coach_time_s) const;
  void add_closeness(Ghost& ghost, const JointMoment& student, const Sight& sight) const;

  std::shared_ptr<const PersonalCoach> coach_;
  std::optional<FollowAlong> follow_;
  Pace pace_ = Pace::Follow;
  double speed_ = 1;
  double played_s_ = 0;
  std::optional<MediaTime> last_time_;
  std::optional<Vec3> feet_;  // where the ghost stands
  Vec3 front_;                // where the student faces
};

}  // namespace posecoach
