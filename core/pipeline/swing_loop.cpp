#include "core/pipeline/swing_loop.h"

#include <algorithm>

namespace posecoach {
namespace {

// Before the hands leave the address, and after they rest: both rests belong to the swing.
constexpr double kPreRoll_s = 2.5, kPostRoll_s = 0.25;
// That for a stroke of this length; a slow one rests more slowly too.
constexpr double kUsualStroke_s = 2.2, kLongestPostRoll_s = 0.8;
constexpr double kGone_s = 0.7;
// A golfer who has stood at address for so long wants to go on, not to look at the last swing.
constexpr double kReadyEndsReplay_s = 1.5, kShortestReplay_s = 4;

Duration post_roll(const FoundSwing& swing) {
  const double slower = std::max(1.0, to_seconds(swing.end - swing.begin) / kUsualStroke_s);
  return duration_from_seconds(std::min(kPostRoll_s * slower, kLongestPostRoll_s));
}

}  // namespace

Result<AnalyzedSwing> analyze_swing(SwingMemory::Cut cut, const SwingComparison& comparison) {
  Result<LiftedStudent> student = lift(cut.track, comparison.lift);
  if (!student) return tl::unexpected(student.error());
  const StudentInput input = student_from_film(cut.track.source, cut.track, *student);
  Result<AnalyzedPair> pair =
      comparison.filmed ? analyze_in_picture(*comparison.filmed, input, *student, comparison.options)
                        : analyze(input, *comparison.coach, comparison.options);
  if (!pair) return tl::unexpected(pair.error());
  return AnalyzedSwing{std::move(cut.track), *std::move(student), *std::move(pair), std::move(cut.pictures)};
}

void SwingLoop::arm() {
  if (is_armed_) return;
  is_armed_ = true;
  state_ = LoopState::Armed;
  // Of a swing that has begun already only the rest would be remembered.
  finder_.reset();
  message_.clear();
}

void SwingLoop::disarm() {
  is_armed_ = false;
  forget();
  state_ = LoopState::Off;
}

void SwingLoop::dismiss_replay() {
  replay_since_.reset();
}

void SwingLoop::forget() {
  finder_.reset();
  memory_.clear();
  found_.reset();
  nobody_since_.reset();
  pending_.clear();
  replay_since_.reset();
}

void SwingLoop::step(const Frame& frame, const PoseObservation& seen,
                     const std::optional<JointMoment>& student, const Sight& sight,
                     const SwingComparison& comparison, const std::string& source) {
  if (student) {
    nobody_since_.reset();
  } else if (!nobody_since_) {
    nobody_since_ = frame.time;
  } else if (to_seconds(frame.time - *nobody_since_) > kGone_s) {
    finder_.reset();
  }
  // Also when not armed: who stands at address is told what to change there.
  const std::optional<FoundSwing> found =
      student ? finder_.step(frame.time, *student, sight) : std::optional<FoundSwing>();
  if (!is_armed_) return;
  if (std::exchange(is_new_take_, false)) {
    if (found_) begin_analysis(comparison, source);
    memory_.clear();
  }
  memory_.add(frame, seen);
  take_answer(frame.time);
  if (found) found_ = found;
  if (found_ && frame.time - found_->end >= post_roll(*found_)) begin_analysis(comparison, source);
  state_ = state_at(frame.time);
}

void SwingLoop::begin_analysis(const SwingComparison& comparison, const std::string& source) {
  const FoundSwing found = *std::exchange(found_, std::nullopt);
  if (!comparison.coach && !comparison.filmed) {
    message_ = "A swing was seen. Choose a coach to have it compared.";
    return;
  }
  SwingMemory::Cut cut =
      memory_.cut(found.begin - duration_from_seconds(kPreRoll_s), found.end + post_roll(found), source);
  pending_.emplace_back(work_, [cut = std::move(cut), comparison] { return analyze_swing(cut, comparison); });
}

void SwingLoop::take_answer(MediaTime now) {
  if (pending_.empty()) return;
  std::optional<Result<AnalyzedSwing>> answer = pending_.front().take();
  if (!answer) return;
  pending_.pop_front();
  if (!*answer) {
    message_ = answer->error().message;
    return;
  }
  message_.clear();
  swing_ = std::make_shared<const AnalyzedSwing>(std::move(**answer));
  replay_since_ = now;
}

LoopState SwingLoop::state_at(MediaTime now) {
  const bool swings = finder_.phase() == SwingFinder::Phase::Swinging;
  if (replay_since_) {
    const double shown_s = to_seconds(now - *replay_since_);
    const bool is_ready = finder_.address_s() > kReadyEndsReplay_s && shown_s > kShortestReplay_s;
    if (swings || is_ready || shown_s > replay_s_) replay_since_.reset();
  }
  if (found_ || (!pending_.empty() && !swings)) return LoopState::Analyzing;
  if (swings) return LoopState::Swinging;
  if (replay_since_) return LoopState::Replay;
  return finder_.phase() == SwingFinder::Phase::AtAddress ? LoopState::Ready : LoopState::Armed;
}

}  // namespace posecoach
