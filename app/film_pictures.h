// The pictures of a stored film in any order, for the review: those that were seen once are kept in memory as
// JPEGs, as many as fit.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "core/pipeline/analyzed_swing.h"

namespace posecoach {

struct FilmPicturesOptions {
  std::size_t most_bytes = 400'000'000;
  int quality = 92;  // of the JPEGs
};

// `times` are the film's, one a picture, as its pose track has them. Going on is quick, as is going back to
// what is in memory; else the film is read again from its start. Errors: those of open_video_file.
Result<std::shared_ptr<PictureStore>> open_film_pictures(const std::filesystem::path& film,
                                                         std::vector<MediaTime> times,
                                                         const FilmPicturesOptions& options = {});

}  // namespace posecoach
