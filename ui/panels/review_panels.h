// The parts of the review. All of them show the same moment: the picture of `state.playback`.
#pragma once

#include "ui/panels/panel.h"

namespace posecoach {

// The film's picture with both bodies on it. `name` is that of its texture.
struct FilmView {
  std::string_view name = "film";
  const OpenedSwing* swing = nullptr;  // never null
  int picture = 0;
  const ReviewSwing* over = nullptr;  // another student over this one, in the coach's place
  bool is_mirrored = false;
  FilmZoom zoom = {};
  FigureShow figures = FigureShow::Both;
  bool says_when_late = true;  // that another picture than the wanted one is seen
};
// As large as its golfer lets it be in this area; the whole where he is not known.
FilmZoom golfer_zoom(const ReviewSwing& review, const Rect& area, bool is_mirrored);
// Where the film lies now.
FilmPlace draw_film(const PanelContext& context, const Rect& area, const FilmView& film);

void draw_review_header(const PanelContext& context, const Rect& area);
// The film, or both films when two swings are compared.
void draw_films(const PanelContext& context, const Rect& area);
void draw_bodies(const PanelContext& context, const Rect& area);
void draw_advice(const PanelContext& context, const Rect& area);
void draw_transport(const PanelContext& context, const Rect& area);
void draw_timeline(const PanelContext& context, const Rect& area);

FilmMarks marks_of(const ReviewSwing& review);
// The picture that all of them show: one that the film has, whatever the state says.
int shown_picture(const PanelContext& context);
// Over the films: both skeletons, only the student's, none, and again.
void change_figures(WindowState& state);
// Where the advice is looked at.
void show_advice(const PanelContext& context, int index);

}  // namespace posecoach
