#include "core/pipeline/set_up_check.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/coaching/text/set_up_text.h"

namespace posecoach {
namespace {

using enum Landmark;
using enum SetUpLevel;
using enum text::SetUp;

// What is seen must last this long before it is told.
constexpr double kLasting_s = 0.4;
constexpr double kBrightnessEvery_s = 0.25;
// Levels change back only when they are better by this part: they do not swing around a limit.
constexpr double kHysteresis = 0.08;
constexpr double kVisible = 0.5;
constexpr double kDark = 35, kDim = 65, kGlaring = 225, kFlat = 28, kBacklight = 75;
// Height of the golfer in the picture, of its height.
constexpr double kFar = 0.20, kRatherFar = 0.30, kNear = 0.90;

std::string said(text::SetUp what) {
  return text::set_up(what);
}

double luminance(const std::uint8_t* rgb) {
  return 0.299 * rgb[0] + 0.587 * rgb[1] + 0.114 * rgb[2];
}

struct Box {
  Vec2 low, high;
};

Box box_of(const ImageKeypoints& person) {
  Box box{person[std::size_t{0}].position_px, person[std::size_t{0}].position_px};
  for (const ImageKeypoint& keypoint : person) {
    box.low = glm::min(box.low, keypoint.position_px);
    box.high = glm::max(box.high, keypoint.position_px);
  }
  return box;
}

// Whether `value` is below a limit, a little more willing to say what was said before.
bool is_below(double value, double limit, bool was) {
  return value < limit * (was ? 1 + kHysteresis : 1);
}

SetUpCheck whole_body(const SetUpSight& sight) {
  if (!sight.person) return {SetUpTopic::WholeBody, Bad, said(StepIn)};
  const ImageKeypoints& image = sight.person->image;
  const Vec2 size(sight.image.width, sight.image.height);
  const auto is_cut = [&](std::initializer_list<Landmark> landmarks) {
    return std::any_of(landmarks.begin(), landmarks.end(), [&](Landmark l) {
      const Vec2& p = image[l].position_px;
      return p.x < 0 || p.y < 0 || p.x >= size.x || p.y >= size.y;
    });
  };
  // Of a pair, the hidden one behind the body does not count: it is seen from one side only.
  const auto is_unseen = [&](Landmark left) {
    return std::max(image[left].visibility, image[mirrored(left)].visibility) < kVisible;
  };
  if (is_cut({LeftShoulder, RightShoulder, LeftHip, RightHip, LeftKnee, RightKnee}))
    return {SetUpTopic::WholeBody, Bad, said(OnlyPart)};
  if (is_cut({LeftHeel, RightHeel, LeftFootIndex, RightFootIndex, LeftAnkle, RightAnkle}))
    return {SetUpTopic::WholeBody, Poor, said(FeetCut)};
  if (is_cut({Nose, LeftEar, RightEar})) return {SetUpTopic::WholeBody, Poor, said(HeadCut)};
  if (is_cut({LeftWrist, RightWrist})) return {SetUpTopic::WholeBody, Poor, said(HandsCut)};
  if (is_unseen(LeftAnkle) || is_unseen(LeftHeel)) return {SetUpTopic::WholeBody, Poor, said(FeetHidden)};
  if (is_unseen(LeftShoulder) || is_unseen(LeftHip)) return {SetUpTopic::WholeBody, Poor, said(BodyHidden)};
  return {SetUpTopic::WholeBody, Good, said(WholeBody)};
}

SetUpCheck light(const std::optional<Brightness>& brightness, const SetUpCheck* before) {
  const bool was_bad = before && before->level == Bad, was_poor = before && before->level == Poor;
  if (!brightness) return {SetUpTopic::Light, Bad, said(StepInForLight)};
  if (is_below(brightness->person, kDark, was_bad)) return {SetUpTopic::Light, Bad, said(TooDark)};
  if (brightness->around - brightness->person > kBacklight * (was_poor ? 1 - kHysteresis : 1))
    return {SetUpTopic::Light, Poor, said(LightBehind)};
  if (is_below(brightness->person, kDim, was_poor)) return {SetUpTopic::Light, Poor, said(RatherDark)};
  if (is_below(255 - brightness->person, 255 - kGlaring, was_poor))
    return {SetUpTopic::Light, Poor, said(TooBright)};
  if (is_below(brightness->contrast, kFlat, was_poor)) return {SetUpTopic::Light, Poor, said(NoContrast)};
  return {SetUpTopic::Light, Good, said(LightGood)};
}

SetUpCheck one_person(const SetUpSight& sight) {
  if (!sight.person) return {SetUpTopic::OnePerson, Bad, said(Nobody)};
  if (sight.people && *sight.people > 1) return {SetUpTopic::OnePerson, Poor, said(SomebodyElse)};
  return {SetUpTopic::OnePerson, Good, said(OnlyYou)};
}

SetUpCheck view(const SetUpSight& sight, const SetUpCheck* before) {
  if (!sight.side || !sight.person) return {SetUpTopic::View, Bad, said(AddressForView)};
  const CameraSide& side = *sight.side;
  if (side.view == View::Between) return {SetUpTopic::View, Poor, said(AtAnAngle)};
  if (side.view == View::DownTheLine && sight.stroke == StrokeKind::Putt)
    return {SetUpTopic::View, Poor, said(PuttFromBehind)};
  if (!is_below(std::abs(side.aside_deg), kSquare_deg, before == nullptr || before->level == Good))
    return {SetUpTopic::View, Poor, text::camera_stands_aside(viewpoint_of(side.view), side.aside_deg)};
  return {SetUpTopic::View, Good, said(side.view == View::FaceOn ? FaceOn : DownTheLine)};
}

SetUpCheck distance(const SetUpSight& sight, const SetUpCheck* before) {
  if (!sight.person) return {SetUpTopic::Distance, Bad, said(StepIn)};
  const Box box = box_of(sight.person->image);
  const double part = (box.high.y - box.low.y) / sight.image.height;
  const bool was_bad = before && before->level == Bad, was_poor = before && before->level == Poor;
  if (is_below(part, kFar, was_bad)) return {SetUpTopic::Distance, Bad, said(TooFar)};
  if (is_below(part, kRatherFar, was_poor)) return {SetUpTopic::Distance, Poor, said(RatherFar)};
  if (part > kNear * (was_poor ? 1 - 0.5 * kHysteresis : 1))
    return {SetUpTopic::Distance, Poor, said(TooClose)};
  return {SetUpTopic::Distance, Good, said(DistanceGood)};
}

}  // namespace

std::optional<Brightness> measure_brightness(const Image& image, const ImageKeypoints& person) {
  constexpr int kGrid = 40;
  const Box box = box_of(person);
  const Vec2 size = box.high - box.low;
  const Vec2 low = box.low - 0.5 * size, high = box.high + 0.5 * size;
  std::vector<double> inside, around;
  for (int gy = 0; gy < kGrid; ++gy)
    for (int gx = 0; gx < kGrid; ++gx) {
      const Vec2 p = low + (high - low) * Vec2((gx + 0.5) / kGrid, (gy + 0.5) / kGrid);
      const int x = static_cast<int>(std::floor(p.x)), y = static_cast<int>(std::floor(p.y));
      if (x < 0 || y < 0 || x >= image.width || y >= image.height) continue;
      // The middle of the box is body, its corners are background.
      const Vec2 from_middle = (p - 0.5 * (box.low + box.high)) / (0.5 * size);
      const double out = std::max(std::abs(from_middle.x), std::abs(from_middle.y));
      if (std::abs(from_middle.x) < 0.6 && std::abs(from_middle.y) < 1)
        inside.push_back(luminance(image.pixel(x, y)));
      else if (out > 1)
        around.push_back(luminance(image.pixel(x, y)));
    }
  if (inside.size() < 20) return std::nullopt;
  std::sort(inside.begin(), inside.end());
  const auto mean = [](const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
  };
  const Brightness brightness{mean(inside), around.empty() ? mean(inside) : mean(around),
                              inside[inside.size() * 95 / 100] - inside[inside.size() * 5 / 100]};
  return brightness;
}

bool SetUpChecks::tells_putt_from_behind() const {
  return !shown_.empty() && shown_[static_cast<std::size_t>(SetUpTopic::View)].words == said(PuttFromBehind);
}

const std::vector<SetUpCheck>& SetUpChecks::step(MediaTime time, const SetUpSight& sight) {
  if (!brightness_at_ || to_seconds(time - *brightness_at_) >= kBrightnessEvery_s || !sight.person) {
    brightness_ = sight.person ? measure_brightness(sight.image, sight.person->image) : std::nullopt;
    brightness_at_ = sight.person ? std::optional(time) : std::nullopt;
  }
  const auto before = [&](SetUpTopic topic) -> const SetUpCheck* {
    return shown_.empty() ? nullptr : &shown_[static_cast<std::size_t>(topic)];
  };
  const std::array<SetUpCheck, 5> now = {whole_body(sight), light(brightness_, before(SetUpTopic::Light)),
                                         one_person(sight), view(sight, before(SetUpTopic::View)),
                                         distance(sight, before(SetUpTopic::Distance))};
  if (shown_.empty()) shown_.assign(now.begin(), now.end());
  for (std::size_t k = 0; k < now.size(); ++k) {
    const bool is_same = now[k].level == shown_[k].level && now[k].words == shown_[k].words;
    Candidate& candidate = candidates_[k];
    if (is_same || candidate.check.words != now[k].words || candidate.check.level != now[k].level)
      candidate = {now[k], time};
    if (!is_same && to_seconds(time - candidate.since) >= kLasting_s) shown_[k] = now[k];
  }
  return shown_;
}

}  // namespace posecoach
