// A film that is looked at through a glass: larger, and moved. Plain arithmetic between the screen and the
// film's own pixels.
#pragma once

#include "ui/render/scene.h"
#include "ui/widgets/rect.h"

namespace posecoach {

struct FilmZoom {
  double factor = 1;      // 1: the whole film
  Vec2 centre{0.5, 0.5};  // fraction of the film that lies in the area's middle
  bool operator==(const FilmZoom&) const = default;
};
inline constexpr double kLargestZoom = 8;

// Where a film of this size lies on the screen, and how its pixels are found there.
struct FilmPlace {
  Rect area;   // that may be drawn on
  Rect whole;  // of the whole film, larger than the area where it is zoomed
  double width_px = 1, height_px = 1;
  bool is_mirrored = false;

  Vec2 screen_from_film(const Vec2& px) const;
  Vec2 film_from_screen(const Vec2& at) const;
  // Points a pixel of the film.
  double scale() const { return whole.width / width_px; }
};
FilmPlace place_film(const Rect& area, double width_px, double height_px, const FilmZoom& zoom,
                     bool is_mirrored = false);

// This part of the film, in its pixels, as large as the area lets it be, but no pixel absurdly so.
FilmZoom zoom_on(const Vec2& from_px, const Vec2& to_px, const Rect& area, double width_px, double height_px);
// What of the film is seen, and where on the screen.
struct SeenFilm {
  PicturePart part;  // of the film as it is stored, not mirrored
  Rect on_screen;
};
SeenFilm seen_film(const FilmPlace& place);

// By this factor about a point of the screen, which stays where it is.
FilmZoom zoomed(const FilmZoom& zoom, double by, const Vec2& about, const FilmPlace& place);
// The film follows the pointer.
FilmZoom panned(const FilmZoom& zoom, const Vec2& by, const FilmPlace& place);

}  // namespace posecoach
