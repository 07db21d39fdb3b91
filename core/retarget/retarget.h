// A coach's motion in another body: same poses, the other's bone lengths, the root's path scaled to the
// other's legs.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/motion/motion.h"

namespace posecoach {

// rotation:  each bone's turn away from the coach's own T-pose, from the file's rotations or recovered from
//            positions (Kabsch at joints with several children, swing elsewhere), applied to the student's
//            T-pose.
// direction: the coach's bone directions with the student's lengths.
// scale:     the coach's joint positions times the ratio of heights (breaks the student's proportions: a
//            baseline).
// paper:     the paper's network, on positions.
// network:   a network takes the camera's errors out of a filmed coach's motion (nothing where there is
//            nothing to doubt), then `rotation`, then the legs go the coach's ways (Stride::LikeCoach).
enum class RetargetMethod { Rotation, Direction, Scale, Paper, Network };
// What analyses and commands take unless told otherwise: measured best on filmed coaches and no worse on
// exact ones.
inline constexpr RetargetMethod kDefaultRetargetMethod = RetargetMethod::Network;

std::string_view to_string(RetargetMethod method);
Result<RetargetMethod> retarget_method_from_string(std::string_view name);

enum class Contacts { Off, On };

// What to do with rotations that the coach's file has: use them, or look at the positions alone.
enum class RotationSource { FileFirst, Positions };

// Where the student's legs go: where turns away from the T-pose put them, or the coach's ways
// (core/retarget/stride.h; with contacts always).
enum class Stride { AsTurned, LikeCoach };

// Whether knees and elbows are kept from bending as no human's do (core/retarget/joint_limits.h).
enum class JointLimits { Off, On };

// Smoothing of positions before they change bodies, only where bones change their length.
enum class InputSmoothing { Off, WhereDoubtful };

struct RetargetOptions {
  RetargetMethod method = RetargetMethod::Rotation;
  Contacts contacts = Contacts::Off;
  RotationSource rotations = RotationSource::FileFirst;
  InputSmoothing smoothing = InputSmoothing::Off;    // `network` smooths by itself
  std::optional<Stride> stride = std::nullopt;       // none: LikeCoach for `network`, AsTurned for the others
  std::optional<JointLimits> limits = std::nullopt;  // none: On with contacts, else Off
  std::filesystem::path paper_weights = {};          // of `paper`; empty: the program's own
};

// What the constraint layer did; zeros with Contacts::Off or where the coach holds nothing.
struct ContactReport {
  int grip_frames = 0;             // frames in which the coach's hands hold the club
  double grip_error_p95_m = 0;     // of the wrists' relation, after the constraint, in frames within reach
  double reach_deficit_max_m = 0;  // how far the arms were too short, worst frame
  std::vector<int> unreachable_frames;
};

// What the joint limits did; zeros with JointLimits::Off and where every joint was within them.
struct JointLimitReport {
  int turned_frames = 0;
  double largest_turn_degrees = 0;
};

struct RetargetResult {
  Motion motion;  // on the body's own skeleton, with the coach's times; rotations except `scale`
  double bone_length_error_max = 0;  // relative
  ContactReport contacts;
  JointLimitReport limits;
};

// The largest relative difference between a bone of the motion, in any frame, and the same bone of its
// skeleton.
double bone_length_error(const Motion& motion);

// Errors: Incomplete naming the joints that either skeleton lacks.
Result<RetargetResult> retarget(const Motion& coach, const Skeleton& body,
                                const RetargetOptions& options = {});

}  // namespace posecoach
