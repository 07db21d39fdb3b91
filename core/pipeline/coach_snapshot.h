// What the window shows of the live loop at one moment: plain values, made by CoachPipeline::step, never
// changed afterwards, so that any thread may hold one.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/body/humanoid.h"
#include "core/body/skeleton.h"
#include "core/image/camera.h"
#include "core/image/frame.h"
#include "core/pipeline/analyzed_swing.h"

namespace posecoach {

// A body at one moment: world positions, metres, one a joint of `skeleton`, with confidence in [0, 1].
struct BodyPose {
  std::shared_ptr<const Skeleton> skeleton;
  std::vector<Vec3> positions;
  std::vector<double> confidence;
};

// "Stand here": what keeps the camera from seeing the golfer well.
enum class SetUpTopic { WholeBody, Light, OnePerson, View, Distance };
enum class SetUpLevel { Good, Poor, Bad };
struct SetUpCheck {
  SetUpTopic topic = SetUpTopic::WholeBody;
  SetUpLevel level = SetUpLevel::Bad;
  std::string words;  // what to do, or that it is well
};

// Measuring the body: a count-down, then a few seconds of standing (or a T-pose).
struct Measuring {
  enum class Stage { CountDown, Looking, Done, Failed };
  Stage stage = Stage::CountDown;
  double seconds_left = 0;
  std::string words;
};

// The hands-free loop.
enum class LoopState {
  Off,
  Armed,      // waiting for the golfer to stand still at address
  Ready,      // he stands still: a swing may begin
  Swinging,   // it has begun
  Analyzing,  // it is over
  Replay      // its answer is there: `swing`
};

// Who drives the coach's ghost.
enum class Pace {
  Follow,  // it waits for the golfer: online DTW
  Play     // its own time, at a chosen speed
};

struct Ghost {
  BodyPose body;        // in the camera's world, on the student's feet
  int coach_frame = 0;  // of the coach's motion in the student's body
  double fraction = 0;  // of that motion, 0 to 1
  // How close each joint of the student is to the ghost's, 1 (there) to 0 (a forearm away or more); negative
  // where it cannot be told.
  std::array<double, kHumanoidJointCount> closeness{};
};

enum class SourceState { Opening, Live, Stalled, Lost, Ended };

struct LiveCounters {
  std::uint64_t captured = 0;             // frames that the source gave
  std::uint64_t lost_by_camera = 0;       // gaps in its numbering
  std::uint64_t skipped_by_pose = 0;      // overtaken by a newer one before the pose stage, on purpose
  double captured_fps = 0, pose_fps = 0;  // over the last two seconds
  // From capture to snapshot, of the last 120 poses.
  double latency_median_ms = 0, latency_p95_ms = 0;
};

struct CoachSnapshot {
  std::uint64_t number = 0;  // rises by one with each
  SourceState source_state = SourceState::Opening;
  std::string source;  // as people say it
  // Why it is stalled or lost, or what was wrong with the film that is over, and what to do; empty when live.
  std::string source_message;
  std::optional<Frame> frame;  // the picture that `person` was seen in
  std::optional<SeenPerson> person;
  std::optional<BodyPose> student;      // lifted into the camera's world
  std::optional<PinholeCamera> camera;  // while there is a student
  std::optional<Ghost> ghost;
  // Why the coach cannot be shown in the student's body, or what of him is not; usually empty.
  std::string coach_message;
  std::vector<SetUpCheck> checks;
  // Posture against the coach's at address, in the golfer's words; empty where there is nothing to say.
  std::vector<std::string> address_advice;
  std::optional<Measuring> measuring;
  std::shared_ptr<const Skeleton> measured_body;  // once measured
  LoopState loop = LoopState::Off;
  std::shared_ptr<const AnalyzedSwing> swing;  // the last one that was analysed
  std::string swing_message;                   // why the last one could not be
  LiveCounters counters;
};

}  // namespace posecoach
