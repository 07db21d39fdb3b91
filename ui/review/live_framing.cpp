#include "ui/review/live_framing.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace posecoach {
namespace {

using enum Landmark;

constexpr double kSeen = 0.5;
constexpr double kRoom = 1.56;      // of the picture's height over the golfer's: a club reaches far above him
constexpr double kUpwards = -0.03;  // of his height: below lies what the window shows of itself
constexpr double kSmallest = 0.4;   // of the picture: beyond that its pixels show
constexpr double kThinBars = 0.08;
constexpr double kTolerance = 0.11;  // of the part: what is less is not followed
constexpr double kEase_s = 0.45, kPatience_s = 1.5;

double kept_inside(double centre, double size) {
  return std::clamp(centre, 0.5 * size, 1 - 0.5 * size);
}

PicturePart part_about(const Vec2& centre, const Vec2& size) {
  const Vec2 middle(kept_inside(centre.x, size.x), kept_inside(centre.y, size.y));
  return {middle - 0.5 * size, middle + 0.5 * size};
}

bool is_all_seen(const CoachSnapshot& snapshot) {
  return std::none_of(snapshot.checks.begin(), snapshot.checks.end(), [](const SetUpCheck& check) {
    return (check.topic == SetUpTopic::WholeBody || check.topic == SetUpTopic::Distance) &&
           check.level != SetUpLevel::Good;
  });
}

// Nothing where it cannot be told how tall he is in the picture.
std::optional<PicturePart> part_of_golfer(const CoachSnapshot& snapshot, double shape) {
  if (!snapshot.person || !snapshot.frame || !snapshot.frame->image || !is_all_seen(snapshot)) return {};
  const Vec2 picture(snapshot.frame->image->width, snapshot.frame->image->height);
  const auto& image = snapshot.person->image;
  double head = 1e9, feet = -1e9;
  for (const Landmark landmark : {Nose, LeftEar, RightEar})
    if (image[landmark].visibility >= kSeen) head = std::min(head, image[landmark].position_px.y);
  for (const Landmark landmark : {LeftHeel, RightHeel, LeftFootIndex, RightFootIndex})
    if (image[landmark].visibility >= kSeen) feet = std::max(feet, image[landmark].position_px.y);
  if (image[LeftHip].visibility < kSeen || image[RightHip].visibility < kSeen) return {};
  const double height = 1.08 * (feet - head);
  if (!(height > 16)) return {};
  Vec2 size;
  size.y = std::clamp(kRoom * height / picture.y, kSmallest, 1.0);
  size.x = std::min(1.0, size.y * picture.y * shape / picture.x);
  const double across = 0.5 * (image[LeftHip].position_px.x + image[RightHip].position_px.x);
  const double down = feet - (0.5 + kUpwards) * height;
  return part_about(Vec2(across, down) / picture, size);
}

double apart(const PicturePart& a, const PicturePart& b) {
  const Vec2 size = b.size();
  return std::max({std::abs(a.begin.x - b.begin.x) / size.x, std::abs(a.end.x - b.end.x) / size.x,
                   std::abs(a.begin.y - b.begin.y) / size.y, std::abs(a.end.y - b.end.y) / size.y});
}

}  // namespace

PicturePart whole_part(double width_px, double height_px, double shape) {
  if (!(width_px > 0 && height_px > 0 && shape > 0)) return {};
  const double across = height_px * shape / width_px, down = 1 / across;
  if (across < 1 && across >= 1 - kThinBars) return part_about({0.5, 0.5}, {across, 1});
  if (down < 1 && down >= 1 - kThinBars) return part_about({0.5, 0.5}, {1, down});
  return {};
}

LiveFraming framed(LiveFraming framing, const CoachSnapshot& snapshot, double shape, double elapsed_s) {
  if (!snapshot.frame || !snapshot.frame->image || !(shape > 0)) return framing;
  const Image& image = *snapshot.frame->image;
  const bool is_swinging = snapshot.loop == LoopState::Swinging || snapshot.loop == LoopState::Analyzing;
  const std::optional<PicturePart> golfer = part_of_golfer(snapshot, shape);
  framing.unseen_s = golfer ? 0 : framing.unseen_s + elapsed_s;
  const PicturePart wanted = golfer ? *golfer : whole_part(image.width, image.height, shape);
  if (!framing.has_begun || std::abs(shape - framing.shape) > 1e-3 * shape) {
    framing.part = framing.aim = wanted;
    framing.shape = shape;
    framing.has_begun = golfer.has_value();
    return framing;
  }
  const bool is_due = golfer ? !is_swinging : framing.unseen_s > kPatience_s;
  if (is_due && apart(wanted, framing.aim) > kTolerance) framing.aim = wanted;
  const double step = 1 - std::exp(-elapsed_s / kEase_s);
  framing.part.begin += step * (framing.aim.begin - framing.part.begin);
  framing.part.end += step * (framing.aim.end - framing.part.end);
  return framing;
}

}  // namespace posecoach
