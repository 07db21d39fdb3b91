#include "ui/render/overlay_scene.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "ui/render/words.h"

namespace posecoach {
namespace {

constexpr Colour kWhite = colour_from_hex(0xFFFFFF);
constexpr Colour kInk = colour_from_hex(0x0C1016);
constexpr Colour kQuiet = colour_from_hex(0xC4CCD8);
constexpr Colour kAmber = colour_from_hex(0xFFC247);

Colour score_colour(double percent) {
  const auto p = static_cast<float>(percent);
  const Colour low = colour_from_hex(0xF0605A), middle = kAmber, high = colour_from_hex(0x45D483);
  return p < 60 ? mix(low, middle, std::clamp((p - 30) / 30, 0.0F, 1.0F))
                : mix(middle, high, std::clamp((p - 60) / 30, 0.0F, 1.0F));
}

// Draws in units of a picture 720 pixels high.
class Layout {
 public:
  Layout(Scene& scene, int width_px, int height_px)
      : scene_(scene),
        unit_(std::max(0.58, std::min(width_px, height_px) / 720.0)),
        width_(width_px / unit_),
        height_(height_px / unit_) {}

  double width() const { return width_; }
  double height() const { return height_; }

  void panel(Vec2 top_left, Vec2 size, double corner) {
    Box shadow = scaled(make_box(top_left + Vec2(0, 3), size, corner, kInk.with_alpha(0.35F)));
    shadow.softness = 10 * unit_;
    scene_.add(shadow);
    Box box = scaled(make_box(top_left, size, corner, kInk.with_alpha(0.74F)));
    box.border = std::max(1.0, unit_);
    box.border_colour = kWhite.with_alpha(0.14F);
    scene_.add(box);
  }
  void box(const Box& box) { scene_.add(scaled(box)); }
  void text(std::string_view utf8, Vec2 baseline, double size, FontWeight weight, Colour colour,
            Align align = Align::Left) {
    scene_.add(Text{std::string(utf8), baseline * unit_, size * unit_, weight, colour, align});
  }
  double text_width(std::string_view utf8, double size, FontWeight weight) const {
    return text_width_px(utf8, weight, size * unit_) / unit_;
  }
  // Part of a circle from twelve o'clock, clockwise, as many short strokes.
  void arc(Vec2 centre, double radius, double width, double fraction, Colour colour) {
    const int steps = std::max(1, static_cast<int>(std::lround(90 * fraction)));
    const auto at = [&](int i) {
      const double angle = 2 * kPi * fraction * i / steps;
      return centre + radius * Vec2(std::sin(angle), -std::cos(angle));
    };
    for (int i = 0; i < steps; ++i) box(make_line(at(i), at(i + 1), width, colour));
  }

 private:
  Box scaled(Box box) const {
    box.centre *= unit_;
    box.half_size *= unit_;
    box.corner_radius *= unit_;
    box.border *= unit_;
    box.softness *= unit_;
    return box;
  }

  Scene& scene_;
  double unit_, width_, height_;
};

constexpr double kMargin = 22;

void add_score(Layout& layout, const OverlayStory& story, const OverlayMoment& moment) {
  const std::string second = moment.apart_m   ? decimal(*moment.apart_m * 100, 1) + " cm apart now"
                             : moment.student ? decimal(story.mean_apart_m * 100, 1) + " cm apart overall"
                                              : "nobody seen now";
  const double words = std::max(layout.text_width("Overall match", 17, FontWeight::Bold),
                                layout.text_width("00.0 cm apart overall", 15, FontWeight::Medium));
  layout.panel({kMargin, kMargin}, {92 + words + 22, 84}, 18);
  const Vec2 centre(kMargin + 46, kMargin + 42);
  const double percent = std::clamp(story.score_percent, 0.0, 100.0);
  Box track = make_disc(centre, 32, kInk.with_alpha(0));
  track.border = 5;
  track.border_colour = kWhite.with_alpha(0.16F);
  layout.box(track);
  if (percent > 0.5) layout.arc(centre, 29.5, 5, percent / 100, score_colour(percent));
  layout.text(decimal(std::round(percent), 0), centre + Vec2(0, 8.5), 24, FontWeight::Bold, kWhite,
              Align::Centre);
  layout.text("Overall match", {kMargin + 92, kMargin + 38}, 17, FontWeight::Bold, kWhite);
  layout.text(second, {kMargin + 92, kMargin + 61}, 15, FontWeight::Medium, kQuiet);
}

void add_legend(Layout& layout, const OverlayStory& story) {
  const FigureStyle student = student_style(story.palette), coach = coach_style(story.palette);
  const bool narrow = layout.width() < 600;
  const std::string coach_words = narrow ? "Coach" : "Coach in your body";
  const double width = 58 + layout.text_width(coach_words, 15, FontWeight::Medium) + 18;
  const double left = layout.width() - kMargin - width;
  layout.panel({left, kMargin}, {width, 68}, 16);
  const auto row = [&](double y, const FigureStyle& style, std::string_view words) {
    const Vec2 from(left + 18, y), to(left + 42, y);
    layout.box(make_line(from, to, 7, style.bone));
    if (style.surface == Surface::Banded)
      for (const double t : {0.3, 0.7}) {
        const Vec2 middle = from + t * (to - from);
        layout.box(make_box(middle - Vec2(2.5, 3.5), {5, 7}, 0, mix(style.bone, kInk, 0.7F)));
      }
    layout.text(words, {left + 56, y + 5.4}, 15, FontWeight::Medium, kWhite);
  };
  row(kMargin + 23, student, "You");
  row(kMargin + 46, coach, coach_words);
}

void add_timeline(Layout& layout, const OverlayStory& story, const OverlayMoment& moment) {
  const double w = layout.width(), h = layout.height();
  Box scrim = make_box({-60, h - 98}, {w + 120, 200}, 0, kInk.with_alpha(0.80F));
  scrim.softness = 36;
  layout.box(scrim);

  const Colour student = student_style(story.palette).bone, coach = coach_style(story.palette).bone;
  const double left = kMargin + 58, right = w - kMargin - 4, upper = h - 54, lower = h - 24;
  const auto at = [&](double fraction) { return left + std::clamp(fraction, 0.0, 1.0) * (right - left); };
  for (const auto& [s, c] : story.links)
    layout.box(make_line({at(s), upper}, {at(c), lower}, 1, kWhite.with_alpha(0.17F)));
  const auto track = [&](double y, std::string_view name, Colour colour, std::optional<double> fraction,
                         const std::vector<double>& events) {
    layout.text(name, {left - 14, y + 5}, 14, FontWeight::Bold, mix(colour, kWhite, 0.35F), Align::Right);
    layout.box(make_line({left, y}, {right, y}, 4, mix(colour, kInk, 0.35F).with_alpha(0.75F)));
    if (fraction) layout.box(make_line({left, y}, {at(*fraction), y}, 4, mix(colour, kWhite, 0.12F)));
    for (const double event : events)
      layout.box(make_box({at(event) - 1.25, y - 6}, {2.5, 12}, 1.25, kWhite.with_alpha(0.85F)));
  };
  track(upper, "You", student, moment.student_fraction, story.student_events);
  track(lower, "Coach", coach, moment.coach_fraction, story.coach_events);
  const Vec2 his(at(moment.student_fraction), upper);
  if (moment.coach_fraction) {
    const Vec2 coachs(at(*moment.coach_fraction), lower);
    layout.box(make_line(his, coachs, 2.2, kWhite.with_alpha(0.95F)));
    layout.box(make_disc(coachs, 7.5, kWhite));
    layout.box(make_disc(coachs, 5.2, coach));
  }
  layout.box(make_disc(his, 7.5, kWhite));
  layout.box(make_disc(his, 5.2, student));

  const double line = h - 78;
  const double words = moment.phase.empty() ? 0 : layout.text_width(moment.phase, 21, FontWeight::Bold) + 12;
  layout.text(moment.phase, {kMargin, line}, 21, FontWeight::Bold, kWhite);
  layout.text(decimal(moment.time_s, 2) + " s", {kMargin + words, line}, 16, FontWeight::Medium, kQuiet);
}

void add_bodies(Scene& scene, const OverlayMoment& moment, Palette palette, const PinholeCamera& camera) {
  const double outline_px = std::max(1.0, 1.6 * std::min(camera.width_px, camera.height_px) / 720.0);
  const auto add = [&](const std::optional<BodyState>& body, FigureStyle style) {
    if (!body) return;
    style.outline_px = outline_px;
    style.thickness = 0.86;
    scene.figures.push_back(make_figure(*body, style));
  };
  add(moment.coach, coach_style(palette));
  add(moment.student, student_style(palette));
}

}  // namespace

PinholeCamera scaled_to(const PinholeCamera& camera, int width_px, int height_px) {
  return cropped_to(camera, {}, width_px, height_px);
}

PinholeCamera cropped_to(const PinholeCamera& camera, const PicturePart& part, int width_px, int height_px) {
  const Vec2 share = part.size();
  POSECOACH_ASSERT(camera.width_px > 0 && camera.height_px > 0 && share.x > 0 && share.y > 0);
  const Vec2 whole = Vec2(width_px, height_px) / share;
  PinholeCamera cropped = camera;
  cropped.width_px = width_px;
  cropped.height_px = height_px;
  cropped.focal_px *= whole.y / camera.height_px;
  cropped.centre_px *= whole / Vec2(camera.width_px, camera.height_px);
  cropped.centre_px -= part.begin * whole;
  return cropped;
}

OverlayStory make_overlay_story(const Analysis& analysis, Palette palette) {
  OverlayStory story;
  story.palette = palette;
  story.score_percent = analysis.score.percent;
  story.mean_apart_m = analysis.score.mean_joint_error_m;
  const auto fraction = [](double value, double of) {
    return of > 0 ? std::clamp(value / of, 0.0, 1.0) : 0.0;
  };
  for (const SwingEvent& event : analysis.student_events)
    story.student_events.push_back(fraction(event.frame, analysis.student.frames - 1));
  for (const SwingEvent& event : analysis.coach_events)
    story.coach_events.push_back(fraction(event.frame, analysis.coach.frames - 1));
  constexpr std::size_t kLinks = 44;
  const std::size_t count = analysis.path.size();
  for (std::size_t i = 0; i < std::min(count, kLinks); ++i) {
    const auto& [student, coach] = analysis.path[count <= kLinks ? i : i * (count - 1) / (kLinks - 1)];
    story.links.emplace_back(fraction(student, analysis.student.frames - 1),
                             fraction(coach, analysis.coach.frames - 1));
  }
  return story;
}

Scene make_bodies_scene(const OverlayMoment& moment, Palette palette, const PinholeCamera& camera,
                        const std::optional<OverlayHighlight>& highlight) {
  Scene scene;
  scene.picture = moment.film;
  add_bodies(scene, moment, palette, camera);
  if (highlight) {
    const std::optional<Vec2> student = camera.project(highlight->student),
                              coach = camera.project(highlight->coach);
    const double unit = std::min(camera.width_px, camera.height_px) / 720.0;
    if (student && coach) scene.add(make_line(*student, *coach, std::max(1.5, 3 * unit), kAmber));
    for (const std::optional<Vec2>& at : {student, coach}) {
      if (!at) continue;
      Box ring = make_disc(*at, std::max(6.0, 15 * unit), kAmber.with_alpha(0));
      ring.border = std::max(1.5, 3.5 * unit);
      ring.border_colour = kAmber;
      scene.add(ring);
    }
  }
  return scene;
}

Scene make_overlay_scene(const OverlayStory& story, const OverlayMoment& moment,
                         const PinholeCamera& camera) {
  POSECOACH_ASSERT(camera.width_px > 0 && camera.height_px > 0);
  Scene scene;
  scene.picture = moment.film;
  add_bodies(scene, moment, story.palette, camera);
  Layout layout(scene, camera.width_px, camera.height_px);
  add_timeline(layout, story, moment);
  add_score(layout, story, moment);
  add_legend(layout, story);
  return scene;
}

}  // namespace posecoach
