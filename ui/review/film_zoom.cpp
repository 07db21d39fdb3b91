#include "ui/review/film_zoom.h"

#include <algorithm>
#include <glm/common.hpp>

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

FilmZoom zoom_on(const Vec2& from_px, const Vec2& to_px, const Rect& area, double width_px,
                 double height_px) {
  constexpr double kLargest = 3;
  const Vec2 film(std::max(1.0, width_px), std::max(1.0, height_px));
  const Vec2 from = glm::clamp(from_px / film, Vec2(0), Vec2(1)),
             to = glm::clamp(to_px / film, Vec2(0), Vec2(1));
  const Vec2 share = to - from;
  if (area.is_empty() || !(share.x > 0 && share.y > 0)) return {};
  const Rect fit = fitted(film.x, film.y, area);
  FilmZoom zoom;
  zoom.factor = std::clamp(std::min(area.width / (share.x * fit.width), area.height / (share.y * fit.height)),
                           1.0, kLargest);
  zoom.centre = 0.5 * (from + to);
  const Vec2 size = zoom.factor * fit.size();
  zoom.centre = {kept_inside(zoom.centre.x, area.width / size.x),
                 kept_inside(zoom.centre.y, area.height / size.y)};
  return zoom;
}

SeenFilm seen_film(const FilmPlace& place) {
  const Rect& whole = place.whole;
  const double left = std::max(whole.x, place.area.x), top = std::max(whole.y, place.area.y);
  SeenFilm seen;
  seen.on_screen = {left, top, std::max(0.0, std::min(whole.right(), place.area.right()) - left),
                    std::max(0.0, std::min(whole.bottom(), place.area.bottom()) - top)};
  const Vec2 begin = (seen.on_screen.corner() - whole.corner()) / whole.size(),
             end = begin + seen.on_screen.size() / whole.size();
  seen.part =
      place.is_mirrored ? PicturePart{{1 - end.x, begin.y}, {1 - begin.x, end.y}} : PicturePart{begin, end};
  return seen;
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
