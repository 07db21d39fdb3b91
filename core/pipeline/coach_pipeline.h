// The live loop as one function of the frames: a picture in, everything that the window shows out. Knows
// neither threads nor clocks: time is the frames' own, requests are plain calls between two steps, and what
// takes long goes to the BackgroundWork. The same frames and requests give the same snapshots.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/body/mirror.h"
#include "core/motion/motion.h"
#include "core/pipeline/analyze.h"
#include "core/pipeline/background_work.h"
#include "core/pipeline/coach_snapshot.h"
#include "core/pipeline/filmed_coach.h"
#include "core/pipeline/pose_estimator.h"

namespace posecoach {

struct CoachPipelineOptions {
  RetargetOptions retarget = AnalyzeOptions{}.retarget;  // of the ghost and of the analysis
  double count_down_s = 3;                               // before the body is measured
  double measuring_s = 3;                                // how long it takes
  double replay_s = 12;         // until the answer to a swing gives way to the live picture by itself
  std::string source = "live";  // what swings are called
};

// What is known of who stands before the camera.
struct Golfer {
  std::optional<Skeleton> body = {};  // measured before; a webcam body
  std::optional<Handedness> hand = {};
  std::optional<double> height_m = {};  // stature, where no body was measured
};

class CoachPipeline {
 public:
  // `work` must outlive the pipeline.
  CoachPipeline(std::unique_ptr<PoseEstimator> estimator, BackgroundWork& work,
                CoachPipelineOptions options = {});
  ~CoachPipeline();

  // Frames in the order of their time. The runner's fields (source, counters) are left empty. Errors: the
  // estimator's.
  Result<CoachSnapshot> step(const Frame& frame);

  // `source` is what the analysis calls him. Without a coach there is no ghost, and swings are not analysed.
  void set_coach(Motion motion, std::string source);
  // Of whom there are only pictures: he is carried over across the view alone.
  void set_coach(FilmedCoach coach);
  void set_person(Golfer golfer);
  // Stand still for a few seconds, best with the arms to the sides. Again: from the start.
  void start_measuring();
  void stop_measuring();
  // The hands-free loop.
  void arm();
  void disarm();
  void dismiss_replay();
  // `speed` of the coach's own time; only for Pace::Play.
  void set_pace(Pace pace, double speed = 1);
  // Another camera or film: its time starts anew, nothing seen before counts. `source` is what its swings are
  // called.
  void change_source(std::string source);
  // The same source begins anew: a camera that was plugged in again, a demonstration that is played again.
  void start_take();

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace posecoach
