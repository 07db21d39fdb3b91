// The hands-free loop: armed, ready, swinging, analysing, replay, and back to live by itself.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/coaching/swing_finder.h"
#include "core/pipeline/analyzed_swing.h"
#include "core/pipeline/background_work.h"
#include "core/pipeline/coach_snapshot.h"
#include "core/pipeline/filmed_coach.h"
#include "core/pipeline/swing_memory.h"

namespace posecoach {

// The same lift() and analyze() as for a film.
struct SwingComparison;
Result<AnalyzedSwing> analyze_swing(SwingMemory::Cut cut, const SwingComparison& comparison);

// What a swing is compared with; asked for when one is found.
struct SwingComparison {
  std::shared_ptr<const CoachInput> coach;
  std::shared_ptr<const FilmedCoach> filmed;  // in his place; neither: swings are found, not analysed
  LiftOptions lift;
  AnalyzeOptions options;
};

class SwingLoop {
 public:
  SwingLoop(BackgroundWork& work, double replay_s) : work_(work), memory_(work), replay_s_(replay_s) {}

  void arm();
  void disarm();
  void dismiss_replay();
  bool is_armed() const { return is_armed_; }
  // Another source, another time.
  void forget();

  // What comes does not go on from what was seen: no swing holds pictures of both.
  void start_take() { is_new_take_ = true; }
  // `student` is nothing while nobody is seen.
  void step(const Frame& frame, const PoseObservation& seen, const std::optional<JointMoment>& student,
            const Sight& sight, const SwingComparison& comparison, const std::string& source);

  LoopState state() const { return state_; }
  SwingFinder::Phase phase() const { return finder_.phase(); }
  double address_s() const { return finder_.address_s(); }
  // The last swing, and why the last one has no answer.
  const std::shared_ptr<const AnalyzedSwing>& swing() const { return swing_; }
  const std::string& message() const { return message_; }

 private:
  void take_answer(MediaTime now);
  void begin_analysis(const SwingComparison& comparison, const std::string& source);
  LoopState state_at(MediaTime now);

  BackgroundWork& work_;
  SwingMemory memory_;
  double replay_s_;
  bool is_armed_ = false, is_new_take_ = false;
  SwingFinder finder_;
  std::optional<FoundSwing> found_;  // waiting for the last frames that belong to it
  std::optional<MediaTime> nobody_since_;
  std::deque<Pending<Result<AnalyzedSwing>>> pending_;
  std::shared_ptr<const AnalyzedSwing> swing_;
  std::string message_;
  std::optional<MediaTime> replay_since_;
  LoopState state_ = LoopState::Off;
};

}  // namespace posecoach
