// The decoding half of a film: packets in, decoded frames out, with everything that can be wrong with a file
// turned into errors and counts.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "capture/orientation.h"
#include "core/base/error.h"
#include "core/base/time.h"

struct AVFrame;

namespace posecoach {

struct FilmFacts {
  Orientation orientation;
  double nominal_fps = 0;
  std::optional<std::size_t> frame_count;  // as the container claims
};

struct DecodedPicture {
  const AVFrame* frame = nullptr;  // valid until the next call
  MediaTime time;                  // later than the one before
};

class FilmDecoder {
 public:
  static Result<std::unique_ptr<FilmDecoder>> open(const std::filesystem::path& path);
  ~FilmDecoder();

  const FilmFacts& facts() const;
  // Nothing at the end. Damaged packets are skipped.
  std::optional<DecodedPicture> next();
  // Whether anything was skipped or is missing so far.
  bool is_damaged() const;
  // Whether it ended before what it announced.
  bool is_cut_off() const;

 private:
  class Implementation;
  explicit FilmDecoder(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace posecoach
