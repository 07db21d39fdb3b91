#include <cmath>

#include "ui/panels/common_panels.h"
#include "ui/panels/live_panels.h"
#include "ui/panels/live_scene.h"
#include "ui/panels/review_film_view.h"
#include "ui/widgets/controls.h"

namespace posecoach {
namespace {

enum class SourceKind { Camera, Film, Simulated };

SourceKind kind_of(const WindowModel& model) {
  if (model.is_simulated) return SourceKind::Simulated;
  const std::string_view source = model.source;
  return source.starts_with("camera:") || source.starts_with("/dev/") ? SourceKind::Camera : SourceKind::Film;
}

std::string_view source_title(SourceState state, SourceKind kind, bool is_damaged) {
  const bool is_camera = kind == SourceKind::Camera;
  switch (state) {
    case SourceState::Opening:
      return is_camera ? "Opening the camera" : "Starting";
    case SourceState::Stalled:
      return is_camera ? "The camera has stopped sending pictures" : "No more pictures are coming";
    case SourceState::Lost:
      return is_camera                  ? "The camera is gone"
             : kind == SourceKind::Film ? "The film cannot be played"
                                        : "There is no such student";
    case SourceState::Ended:
      return is_damaged ? "The film is over, and damaged" : "The film is over";
    case SourceState::Live:
      break;
  }
  return {};
}

}  // namespace

void draw_live_picture(const PanelContext& context, const Rect& area) {
  Ui& ui = context.ui;
  WindowState& state = context.state;
  ui.fill(area, colour_from_hex(0x07090C));
  if (!context.model.snapshot || !context.model.snapshot->frame || !context.model.snapshot->frame->image ||
      area.is_empty())
    return;
  const CoachSnapshot& snapshot = *context.model.snapshot;
  const Vec2 picture(snapshot.frame->image->width, snapshot.frame->image->height);
  const double shape = area.width / area.height;
  state.framing = framed(state.framing, snapshot, shape, ui.elapsed_s());
  const PicturePart part = state.frames_golfer ? state.framing.part : whole_part(picture.x, picture.y, shape);
  const Vec2 seen = part.size() * picture;
  const Rect place = fitted(seen.x, seen.y, area);
  const double pixels = place.width * place.height * ui.scale() * ui.scale();
  const double factor =
      ui.scale() * std::min(1.0, std::sqrt(ui.views().most_pixels() / std::max(1.0, pixels)));
  const Theme film = film_theme(context.theme());
  const LiveSceneStyle style{film.palette, film.good, film.warning, film.bad, state.figures};
  const int width = std::max(16, static_cast<int>(std::lround(place.width * factor))),
            height = std::max(16, static_cast<int>(std::lround(place.height * factor)));
  const std::uint64_t version = scene_version(
      {static_cast<double>(snapshot.number), 1.0 * width, 1.0 * height, part.begin.x, part.begin.y,
       part.end.x, part.end.y, static_cast<double>(style.palette), static_cast<double>(style.figures)},
      snapshot.frame->image.get());
  const TextureName texture = ui.views().scene(
      "live", version, [&] { return make_live_scene(snapshot, style, width, height, part); });
  const Rect shown = state.is_mirrored
                         ? Rect{area.x + area.right() - place.right(), place.y, place.width, place.height}
                         : place;
  ui.texture(texture, shown, 0, state.is_mirrored);
}

void draw_source_message(const PanelContext& context, const Rect& area) {
  Ui& ui = context.ui;
  const SourceState state =
      context.model.snapshot ? context.model.snapshot->source_state : SourceState::Opening;
  if (state == SourceState::Live) return;
  const Theme& theme = context.theme();
  const std::string message = context.model.snapshot ? context.model.snapshot->source_message : std::string();
  const double width = std::min(440.0, area.width - 40);
  const double words = message.empty() ? 0 : ui.paragraph_height(TextStyle::Body, width - 48, message, 5) + 8;
  const bool has_buttons = state != SourceState::Opening;
  const double height = 24 + 40 + 12 + 30 + words + (has_buttons ? 56 : 8) + 20;
  const Rect card{area.centre().x - 0.5 * width, area.centre().y - 0.5 * height, width, height};
  ui.shadow(card, radius::kLarge, 24);
  Rect inner = draw_card(ui, card, 24);
  const bool is_bad = state == SourceState::Stalled || state == SourceState::Lost || !message.empty();
  const SourceKind kind = kind_of(context.model);
  const Rect sign = inner.take_top(40, 12);
  if (state == SourceState::Opening) {
    const double angle = 4 * ui.time_s();
    ui.ring(sign.centre(), 16, theme.hovered, 4);
    ui.arc(sign.centre(), 16, angle, angle + 1.6, theme.accent, 4);
  } else {
    draw_icon(ui, is_bad ? Icon::Warning : Icon::Check, sign.centre(), 38,
              is_bad ? theme.warning : theme.good);
  }
  ui.text_in(TextStyle::Title, inner.take_top(26, 4), source_title(state, kind, !message.empty()), theme.text,
             Align::Centre);
  if (!message.empty())
    ui.paragraph(TextStyle::Body, inner.take_top(words), message, theme.quiet, 5, Align::Centre);
  if (!has_buttons) return;
  Rect row = inner.take_bottom(38);
  const std::string_view again = state == SourceState::Ended ? "Play it again" : "Try again";
  if (draw_button(ui, row.column(0, 2, 10),
                  {.id = "retry", .words = again, .icon = Icon::Retry, .look = ButtonLook::Primary}))
    context.want(intent::RetrySource{});
  if (kind == SourceKind::Film) {
    if (draw_button(ui, row.column(1, 2, 10),
                    {.id = "choose film", .words = "Another film", .icon = Icon::Folder}))
      open_import_dialog(context, BrowseFor::Source);
  } else if (draw_button(ui, row.column(1, 2, 10),
                         {.id = "choose", .words = "Choose a camera", .icon = Icon::Camera})) {
    context.state.screen = ScreenName::SetUp;
  }
}

void draw_measuring(const PanelContext& context, const Rect& area) {
  if (!context.model.snapshot || !context.model.snapshot->measuring) return;
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  const Measuring& measuring = *context.model.snapshot->measuring;
  const double width = std::min(460.0, area.width - 40), height = 320;
  const Rect card{area.centre().x - 0.5 * width, area.centre().y - 0.5 * height, width, height};
  ui.shadow(card, radius::kLarge, 24);
  Rect inner = draw_card(ui, card, 24);
  const Rect sign = inner.take_top(128, 10);
  const bool is_counting =
      measuring.stage == Measuring::Stage::CountDown || measuring.stage == Measuring::Stage::Looking;
  if (is_counting) {
    const double left = std::max(0.0, measuring.seconds_left);
    const Colour colour = measuring.stage == Measuring::Stage::CountDown ? theme.warning : theme.good;
    ui.ring(sign.centre(), 58, theme.hovered, 10);
    const double share = left - std::floor(left);
    ui.arc(sign.centre(), 58, 0, 2 * kPi * (share > 0 ? share : 1), colour, 10);
    ui.text(TextStyle::Giant, {sign.centre().x, sign.centre().y + 0.5 * ui.cap_height(TextStyle::Giant)},
            std::to_string(static_cast<int>(std::ceil(left))), theme.text, Align::Centre);
  } else {
    const bool is_done = measuring.stage == Measuring::Stage::Done;
    draw_icon(ui, is_done ? Icon::Check : Icon::Warning, sign.centre(), 110,
              is_done ? theme.good : theme.warning);
  }
  const std::string_view title = measuring.stage == Measuring::Stage::CountDown ? "Get ready"
                                 : measuring.stage == Measuring::Stage::Looking ? "Measuring: stand still"
                                 : measuring.stage == Measuring::Stage::Done    ? "Measured"
                                                                                : "Not measured";
  ui.text_in(TextStyle::Heading, inner.take_top(32), title, theme.text, Align::Centre);
  ui.paragraph(TextStyle::Body, inner.take_top(66), measuring.words, theme.quiet, 3, Align::Centre);
  if (is_counting && draw_button(ui, {card.centre().x - 60, card.bottom() - 50, 120, 34},
                                 {.id = "stop measuring", .words = "Stop", .look = ButtonLook::Plain}))
    context.want(intent::StopMeasuring{});
}

}  // namespace posecoach
