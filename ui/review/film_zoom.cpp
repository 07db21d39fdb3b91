#include "ui/review/film_zoom.h"

#include <algorithm>

namespace posecoach {
namespace {

// Without a gap at the sides where the film is larger than the area.
double kept_inside(double centre, double shown) {
  const double half = 0.5 * std::min(1.0, shown);
  return std::clamp(centre, half, 1 - half);
}

}  // namespace

Vec2 FilmPlace::screen_from_film(const Vec2& px) const {
  const double x = (is_mirrored ? width_px - px.x : px.x) / width_px;
  return {whole.x + x * whole.width, whole.y + px.y / height_px * whole.height};
}

Vec2 FilmPlace::film_from_screen(const Vec2& at) const {
  const double x = (at.x - whole.x) / whole.width * width_px;
  return {is_mirrored ? width_px - x : x, (at.y - whole.y) / whole.height * height_px};
}

FilmPlace place_film(const Rect& area, double width_px, double height_px, const FilmZoom& zoom,
                     bool is_mirrored) {
  FilmPlace place{area, area, std::max(1.0, width_px), std::max(1.0, height_px), is_mirrored};
  if (area.is_empty()) {
    place.whole = {area.x, area.y, 1, 1};
    return place;
  }
  const Rect fit = fitted(place.width_px, place.height_px, area);
  const double factor = std::clamp(zoom.factor, 1.0, kLargestZoom);
  const double width = factor * fit.width, height = factor * fit.height;
  const double x = kept_inside(zoom.centre.x, area.width / width),
               y = kept_inside(zoom.centre.y, area.height / height);
  place.whole = {area.centre().x - x * width, area.centre().y - y * height, width, height};
  return place;
}

FilmZoom zoomed(const FilmZoom& zoom, double by, const Vec2& about, const FilmPlace& place) {
  FilmZoom next = zoom;
  next.factor = std::clamp(zoom.factor * by, 1.0, kLargestZoom);
  const Vec2 fraction = (about - place.whole.corner()) / place.whole.size();
  const Vec2 size = place.whole.size() * (next.factor / std::clamp(zoom.factor, 1.0, kLargestZoom));
  next.centre = fraction + (place.area.centre() - about) / size;
  next.centre = {kept_inside(next.centre.x, place.area.width / size.x),
                 kept_inside(next.centre.y, place.area.height / size.y)};
  return next;
}

FilmZoom panned(const FilmZoom& zoom, const Vec2& by, const FilmPlace& place) {
  FilmZoom next = zoom;
  next.centre = {
      kept_inside(zoom.centre.x - by.x / place.whole.width, place.area.width / place.whole.width),
      kept_inside(zoom.centre.y - by.y / place.whole.height, place.area.height / place.whole.height)};
  return next;
}

}  // namespace posecoach
