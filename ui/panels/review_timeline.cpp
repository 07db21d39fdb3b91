#include <array>
#include <cmath>

#include "ui/panels/review_events.h"
#include "ui/panels/review_panels.h"
#include "ui/render/words.h"
#include "ui/widgets/controls.h"

namespace posecoach {
namespace {

constexpr double kGutter = 62, kFoot = 26, kLabels = 18, kLeader = 10;
constexpr int kMostLinks = 60;

// The student's row above, the coach's row below, each over its own time; lines join the moments that answer
// each other. Above and below, both bodies at the named positions.
struct Layout {
  Rect figures_above, figures_below, ribbon;
  double left = 0, right = 0, student_y = 0, coach_y = 0, figure = 0;
  double student_begin = 0, student_end = 1, coach_begin = 0, coach_end = 1;

  double student_x(double seconds) const { return at(seconds, student_begin, student_end); }
  double coach_x(double seconds) const { return at(seconds, coach_begin, coach_end); }
  double at(double seconds, double begin, double end) const {
    return left +
           (end > begin ? std::clamp((seconds - begin) / (end - begin), 0.0, 1.0) : 0.5) * (right - left);
  }
  double student_time(double x) const {
    return student_begin + (x - left) / (right - left) * (student_end - student_begin);
  }
  double coach_time(double x) const {
    return coach_begin + (x - left) / (right - left) * (coach_end - coach_begin);
  }
};

double picture_time(const ReviewSwing& review, int picture) {
  return review.times_s[static_cast<std::size_t>(std::clamp(picture, 0, review.picture_count() - 1))];
}

Layout lay_out(const ReviewSwing& review, const Rect& area) {
  Layout layout;
  Rect inner = area.inset(space::kMedium, space::kSmall);
  layout.left = inner.x + kGutter;
  layout.right = inner.right() - 6;
  Rect foot = inner.take_bottom(kFoot);
  layout.ribbon = {layout.left, foot.y + 4, layout.right - layout.left, 9};
  inner.take_top(kLabels);
  layout.figure = std::max(20.0, 0.34 * (inner.height - 2 * kLeader));
  layout.figures_above = inner.take_top(layout.figure);
  layout.figures_below = inner.take_bottom(layout.figure, kLeader);
  layout.student_y = inner.y + kLeader;
  layout.coach_y = inner.bottom();
  if (!review.replay.steps.empty()) {
    const auto& steps = review.replay.steps;
    layout.student_begin = picture_time(review, steps.front().student_frame);
    layout.student_end = picture_time(review, steps.back().student_frame);
    layout.coach_begin = steps.front().coach_s - to_seconds(review.swing->pair.coach.time(0));
    layout.coach_end = steps.back().coach_s - to_seconds(review.swing->pair.coach.time(0));
  }
  return layout;
}

double coach_seconds(const ReviewSwing& review, const ReplayStep& step) {
  return step.coach_s - to_seconds(review.swing->pair.coach.time(0));
}

// As the film's camera sees them.
Vec2 seen_from(const Vec3& p, double angle) {
  return {p.x * std::cos(angle) - p.z * std::sin(angle), p.y};
}

void draw_figure(Ui& ui, const ReviewSwing& review, const std::vector<Vec3>& joints, const Vec2& feet,
                 double height, const Colour& colour) {
  const Replay& replay = review.replay;
  double tallest = 1.2, middle = 0;
  for (const Vec3& p : joints) {
    tallest = std::max(tallest, p.y);
    middle += seen_from(p, -review.front).x / static_cast<double>(joints.size());
  }
  const double factor = 0.94 * height / std::max(1.7, tallest);
  const auto at = [&](int joint) {
    const Vec2 p = seen_from(joints[static_cast<std::size_t>(joint)], -review.front);
    return Vec2(feet.x + factor * (p.x - middle), feet.y - factor * p.y);
  };
  for (const auto& [from, to] : replay.bones)
    ui.line(at(from), at(to), colour, std::max(1.6, 0.034 * height));
  for (std::size_t i = 0; i < replay.joints.size(); ++i)
    if (replay.joints[i] == HumanoidJoint::Head) ui.disc(at(static_cast<int>(i)), 0.085 * factor, colour);
}

struct Column {
  std::string label;
  const ReplayStep* step;
};

std::vector<Column> columns_of(const ReviewSwing& review, std::size_t most) {
  std::vector<Column> columns;
  for (const SwingEvent& event : review.analysis().student_events) {
    const ReplayStep* best = nullptr;
    for (const ReplayStep& step : review.replay.steps)
      if (!best || std::abs(step.student_frame - event.frame) < std::abs(best->student_frame - event.frame))
        best = &step;
    if (best) columns.push_back({title_from_name(event.name), best});
  }
  while (columns.size() > std::max<std::size_t>(most, 2)) columns.erase(columns.begin() + 1);
  return columns;
}

void draw_links(Ui& ui, const ReviewSwing& review, const Layout& layout) {
  const auto& steps = review.replay.steps;
  const int count = static_cast<int>(steps.size()), shown = std::min(count, kMostLinks);
  const Colour colour = ui.theme().faint.with_alpha(0.38F);
  for (int i = 0; i < shown; ++i) {
    const ReplayStep& step = steps[static_cast<std::size_t>(shown > 1 ? i * (count - 1) / (shown - 1) : 0)];
    ui.line({layout.student_x(picture_time(review, step.student_frame)), layout.student_y},
            {layout.coach_x(coach_seconds(review, step)), layout.coach_y}, colour, 1);
  }
}

void draw_columns(const PanelContext& context, const ReviewSwing& review, const Layout& layout) {
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  const double wide = std::max(46.0, 0.8 * layout.figure);
  const auto columns = columns_of(review, static_cast<std::size_t>((layout.right - layout.left) / wide));
  const double pitch =
      (layout.right - layout.left) / std::max<double>(1, static_cast<double>(columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const ReplayStep& step = *columns[i].step;
    const double x = layout.left + (static_cast<double>(i) + 0.5) * pitch;
    const double student_x = layout.student_x(picture_time(review, step.student_frame)),
                 coach_x = layout.coach_x(coach_seconds(review, step));
    const Rect place{x - 0.5 * pitch, layout.figures_above.y - kLabels, pitch,
                     layout.figures_below.bottom() - layout.figures_above.y + kLabels};
    const bool is_now = std::abs(step.student_frame - shown_picture(context)) <= 1;
    ui.text_in(TextStyle::Caption, {place.x, place.y - 2, place.width, kLabels}, columns[i].label,
               is_now ? theme.text : theme.quiet, Align::Centre);
    ui.line({x, layout.figures_above.bottom() + 1}, {student_x, layout.student_y - 3},
            theme.student.with_alpha(0.55F), 1);
    ui.line({coach_x, layout.coach_y + 3}, {x, layout.figures_below.y - 1}, theme.coach.with_alpha(0.55F), 1);
    ui.line({student_x, layout.student_y}, {coach_x, layout.coach_y}, theme.quiet, 1.4);
    draw_figure(ui, review, step.student, {x, layout.figures_above.bottom()}, layout.figure,
                theme.student_text);
    draw_figure(ui, review, step.coach, {x, layout.figures_below.bottom()}, layout.figure, theme.coach_text);
    for (const Rect& figure : {layout.figures_above, layout.figures_below}) {
      const Rect target{place.x, figure.y, pitch, figure.height};
      const Interaction on =
          ui.region("figure " + std::to_string(2 * i + (figure.y == layout.figures_above.y ? 0 : 1)), target,
                    Focus::Never);
      if (on.hovered) ui.use_hand_pointer();
      if (on.clicked)
        context.state.playback = moved_to(context.state.playback, step.student_frame, marks_of(review));
    }
  }
}

Colour tempo_colour(const Theme& theme, Tempo tempo) {
  const bool is_dark = theme.kind == ThemeKind::Dark;
  switch (tempo) {
    case Tempo::MuchFaster:
      return colour_from_hex(is_dark ? 0xFFB020 : 0xB36B00);
    case Tempo::Faster:
      return colour_from_hex(is_dark ? 0xD9A84E : 0xD9A040);
    case Tempo::Slower:
      return colour_from_hex(is_dark ? 0x6C93C7 : 0x7FA3D1);
    case Tempo::MuchSlower:
      return colour_from_hex(is_dark ? 0x4D9BFF : 0x1F5FBF);
    case Tempo::Same:
      break;
  }
  return theme.hovered;
}

// Faster stands above the line, slower hangs below it: told apart without colour.
void draw_ribbon(const PanelContext& context, const ReviewSwing& review, const Layout& layout) {
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  const double middle = layout.ribbon.centre().y;
  ui.fill({layout.left, middle - 1.5, layout.right - layout.left, 3}, theme.hovered, 1);
  for (const TempoPart& part : review.tempo) {
    const double from = layout.student_x(part.begin_s), to = layout.student_x(part.end_s);
    const double strength = part.tempo == Tempo::MuchFaster || part.tempo == Tempo::MuchSlower ? 8
                            : part.tempo == Tempo::Same                                        ? 0
                                                                                               : 5;
    if (strength == 0 || to - from < 0.5) continue;
    const bool is_faster = part.tempo == Tempo::Faster || part.tempo == Tempo::MuchFaster;
    ui.fill({from, is_faster ? middle - strength : middle, to - from, strength},
            tempo_colour(theme, part.tempo), 1.5);
  }
}

void draw_row_names(const PanelContext& context, const Layout& layout) {
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  const double x = layout.left - 12;
  const auto name = [&](double y, std::string_view words, const Colour& colour, TextStyle style) {
    ui.text(style, {x, y + 0.5 * ui.cap_height(style)}, words, colour, Align::Right);
  };
  name(layout.student_y, "You", theme.student_text, TextStyle::Strong);
  name(layout.coach_y, "Coach", theme.coach_text, TextStyle::Strong);
  name(layout.ribbon.centre().y - 6, "faster", theme.quiet, TextStyle::Caption);
  name(layout.ribbon.centre().y + 7, "slower", theme.quiet, TextStyle::Caption);
}

void draw_now(const PanelContext& context, const ReviewSwing& review, const Layout& layout) {
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  const int picture = shown_picture(context);
  const Vec2 student(layout.student_x(picture_time(review, picture)), layout.student_y);
  const Vec2 coach(layout.coach_x(coach_time_at(review, picture)), layout.coach_y);
  ui.line(student, coach, theme.text, 2.2);
  ui.fill({student.x - 0.75, layout.ribbon.y - 4, 1.5, layout.ribbon.height + 8}, theme.text);
  for (const auto& [at, colour] : {std::pair(student, theme.student), std::pair(coach, theme.coach)}) {
    ui.disc(at, 8, theme.text);
    ui.disc(at, 5.5, colour);
  }
}

}  // namespace

void draw_timeline(const PanelContext& context, const Rect& area) {
  if (!context.model.opened) return;
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  const ReviewSwing& review = *context.model.opened->review;
  draw_card(ui, area, 0);
  if (review.replay.steps.empty() || review.times_s.empty())
    return draw_empty(ui, area, Icon::Information, "No alignment", "The two motions have nothing in common.");
  const Layout layout = lay_out(review, area);
  const Playback& playback = context.state.playback;
  if (playback.in && playback.out) {
    const double from = layout.student_x(picture_time(review, *playback.in)),
                 to = layout.student_x(picture_time(review, *playback.out));
    ui.fill({from, layout.student_y - 6, std::max(2.0, to - from), 12}, theme.accent.with_alpha(0.3F), 3);
  }
  draw_links(ui, review, layout);
  if (review.events.empty() && !review.analysis().notes.empty())
    ui.paragraph(TextStyle::Body,
                 {layout.left, layout.figures_above.y, layout.right - layout.left, layout.figure},
                 review.analysis().notes.front(), theme.warning, 2);
  draw_columns(context, review, layout);
  ui.line({layout.left, layout.student_y}, {layout.right, layout.student_y}, theme.student, 4);
  ui.line({layout.left, layout.coach_y}, {layout.right, layout.coach_y}, theme.coach, 4);
  if (theme.palette == Palette::ColourBlindSafe)
    for (double x = layout.left + 8; x < layout.right; x += 16)
      ui.line({x, layout.coach_y}, {x + 6, layout.coach_y}, theme.surface.with_alpha(1), 4);
  draw_ribbon(context, review, layout);
  draw_row_names(context, layout);
  // The student's half scrubs his time, the coach's half the coach's.
  const double middle = 0.5 * (layout.student_y + layout.coach_y);
  const Rect upper{layout.left - 8, layout.figures_above.bottom(), layout.right - layout.left + 16,
                   middle - layout.figures_above.bottom()};
  const Rect lower{upper.x, middle, upper.width, layout.figures_below.y - middle};
  const Rect ribbon{upper.x, layout.ribbon.y - 6, upper.width, layout.ribbon.height + 12};
  const FilmMarks film = marks_of(review);
  for (const auto& [id, place] : {std::pair("student row", upper), std::pair("ribbon", ribbon)}) {
    const Interaction on = ui.region(id, place, Focus::Never);
    if (on.held)
      context.state.playback = moved_to(playback, frame_at(layout.student_time(on.mouse.x), film), film);
  }
  const Interaction on = ui.region("coach row", lower, Focus::Never);
  if (on.held)
    context.state.playback =
        moved_to(playback, picture_of_coach_time(review, layout.coach_time(on.mouse.x)), film);
  // Over the rows: they are there to be dragged.
  draw_event_handles(context, {layout.student_y,
                               [&](int picture) { return layout.student_x(picture_time(review, picture)); },
                               [&](double x) { return frame_at(layout.student_time(x), film); }});
  draw_now(context, review, layout);
}

}  // namespace posecoach
