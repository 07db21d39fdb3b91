// The coach at the student's own pace: he waits at his address until the student stands still at his, goes
// through the stroke with him, waits when he waits, and starts over when he is back at address. Of a putt
// seen along the target line only the shoulders show how far it is; everything else would drown that in its
// trembling.
#pragma once

#include <optional>
#include <vector>

#include "core/coaching/alignment.h"
#include "core/coaching/hand_speed.h"
#include "core/coaching/joint_moment.h"
#include "core/coaching/online_dtw.h"
#include "core/coaching/shoulder_turn.h"

namespace posecoach {

class FollowAlong {
 public:
  // `coach` is in the student's body; `stroke` is the part to be followed, from address to the end.
  FollowAlong(const JointTrack& coach, const TimeWindow& stroke);

  // The coach's time, seconds, that answers this moment. `yaw` is the turn about +Y that makes the coach face
  // as the student does; like `sight` it counts from the next address on.
  double step(MediaTime time, const JointMoment& student, double yaw, const Sight& sight);
  double coach_time_s() const;
  void start_over();

 private:
  PoseSequence coach_poses() const;
  PoseSequence pose_of(const JointMoment& student, const std::vector<Vec3>& habit) const;
  bool is_at_address(const JointMoment& student, double yaw, const Sight& sight, double seconds);
  bool is_near_address(const JointMoment& student, double seconds);
  bool has_shoulders_at_address(double seconds);
  void learn_habit(const PoseSequence& at_address, double seconds);
  void look_from(double yaw, const Sight& sight);
  void follow(MediaTime time, const JointMoment& student);
  int position() const { return turn_warp_ ? turn_warp_->position() : warp_.position(); }
  bool hides_stroke() const;
  PoseSequence coach_turns() const;
  double turn_of(const Vec3& left_shoulder, const Vec3& right_shoulder) const;

  JointTrack coach_;  // the stroke at kAlignmentRate
  std::vector<HumanoidJoint> joints_;
  double begin_s_ = 0;
  double yaw_ = 0;
  Sight sight_;
  OnlineWarp warp_;
  // Of a putt along the line of sight: the warp that counts, and what it goes by.
  std::optional<OnlineWarp> turn_warp_;
  ShoulderTurn turn_;
  Vec3 turn_sight_;  // the line of sight that turn_ was measured across; kept while he stands there
  Vec3 last_turn_;
  bool has_walked_ = false;
  std::vector<Vec3> habit_;  // of each joint at address, the student's place less the coach's; as seen
  HandSpeed speed_;
  bool is_following_ = false;
  double away_s_ = 0;  // how long he has stood still away from his address
  std::optional<MediaTime> last_time_;
  JointMoment last_;
  double fed_s_ = 0;  // time since last_time_ that no pose at the common rate stands for yet
};

}  // namespace posecoach
