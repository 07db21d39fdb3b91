#include "tests/capture/numbered_film.h"

#include "capture/bar_code.h"
#include "capture/video_file.h"

namespace posecoach {

Image numbered_picture(int width, int height, std::uint32_t number) {
  Image image = Image::black(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      image.pixel(x, y)[0] = static_cast<std::uint8_t>(200 * x / width);
      image.pixel(x, y)[1] = static_cast<std::uint8_t>(200 * y / height);
      image.pixel(x, y)[2] = 90;
    }
  write_bar_code(image, number);
  return image;
}

Frame numbered_frame(int width, int height, std::size_t number, double time_s) {
  return {number, media_time_from_seconds(time_s), std::nullopt,
          std::make_shared<const Image>(numbered_picture(width, height, static_cast<std::uint32_t>(number)))};
}

NumberedFilm read_numbered_film(const std::filesystem::path& path) {
  NumberedFilm film;
  const auto source = open_video_file(path);
  if (!source) return film;
  for (auto frame = (*source)->next({}); frame && *frame; frame = (*source)->next({})) {
    film.times_s.push_back(to_seconds((*frame)->time));
    film.numbers.push_back(read_bar_code(*(*frame)->image));
  }
  return film;
}

}  // namespace posecoach
