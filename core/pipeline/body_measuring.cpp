#include "core/pipeline/body_measuring.h"

#include <algorithm>
#include <cstdio>
#include <glm/geometric.hpp>

#include "core/body/body_measurement.h"
#include "core/coaching/text/set_up_text.h"

namespace posecoach {
namespace {

constexpr double kAnswerStays_s = 4;
constexpr std::size_t kFewestSeen = 15;
constexpr double kLeastSeen = 0.7;

bool is_whole(const WorldKeypoints& placed) {
  using enum Landmark;
  return std::ranges::all_of(
      std::array{LeftShoulder, RightShoulder, LeftElbow, RightElbow, LeftWrist, RightWrist, LeftHip, RightHip,
                 LeftKnee, RightKnee, LeftAnkle, RightAnkle, LeftHeel, RightHeel},
      [&](Landmark l) { return placed[l].visibility >= 0.5; });
}

}  // namespace

std::optional<Skeleton> BodyMeasuring::step(MediaTime time, const std::optional<WorldKeypoints>& placed) {
  now_ = time;
  if (!since_) since_ = time;
  const double elapsed = to_seconds(time - *since_);
  switch (stage_) {
    case Measuring::Stage::CountDown:
      if (elapsed < options_.count_down_s) return std::nullopt;
      stage_ = Measuring::Stage::Looking;
      since_ = time;
      [[fallthrough]];
    case Measuring::Stage::Looking:
      ++looks_asked_;
      if (placed && is_whole(*placed)) looks_.push_back(*placed);
      return to_seconds(time - *since_) >= options_.looking_s ? finish() : std::nullopt;
    case Measuring::Stage::Done:
    case Measuring::Stage::Failed:
      is_over_ = elapsed >= kAnswerStays_s;
      return std::nullopt;
  }
  return std::nullopt;
}

std::optional<Skeleton> BodyMeasuring::finish() {
  since_ = now_;
  stage_ = Measuring::Stage::Failed;
  if (looks_.size() < kFewestSeen || static_cast<double>(looks_.size()) < kLeastSeen * looks_asked_) {
    words_ = text::measure(text::Measure::NotSeen);
    return std::nullopt;
  }
  const Result<Skeleton> body = measure_landmark_body(looks_, {options_.height_m});
  if (!body) {
    words_ = text::not_measured(body.error().message);
    return std::nullopt;
  }
  stage_ = Measuring::Stage::Done;
  words_ = text::measure(options_.height_m ? text::Measure::Done : text::Measure::DoneWithoutHeight);
  return *body;
}

Measuring BodyMeasuring::state() const {
  Measuring state;
  state.stage = stage_;
  const double elapsed = since_ ? to_seconds(now_ - *since_) : 0;
  const bool is_counting = stage_ == Measuring::Stage::CountDown;
  const double length = is_counting ? options_.count_down_s : options_.looking_s;
  if (is_counting || stage_ == Measuring::Stage::Looking)
    state.seconds_left = std::max(0.0, length - elapsed);
  state.words = is_counting                           ? text::measure(text::Measure::ArmsOut)
                : stage_ == Measuring::Stage::Looking ? text::measure(text::Measure::HoldStill)
                                                      : words_;
  return state;
}

}  // namespace posecoach
