// A Matroska film that is whole at every moment: what flush() has written can be played whatever happens
// afterwards.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "capture/picture_encoder.h"

namespace posecoach {

class MatroskaFile {
 public:
  // A new file; an existing one is refused. Errors: InvalidArgument, NotFound, Unreadable (permission, disk
  // full).
  static Result<std::unique_ptr<MatroskaFile>> create(const std::filesystem::path& path);
  // Without finish() the film ends at the last flush().
  ~MatroskaFile();

  // Once, before the first picture.
  Result<void> begin(const FilmStream& stream);
  // `time` counts from the film's start; to the millisecond, which is what Matroska keeps. Two pictures of
  // the same millisecond are set one millisecond apart.
  Result<void> write(std::span<const std::uint8_t> bytes, bool is_key, Duration time);
  // Everything so far to the system; with Sync::Disk to the disk itself.
  enum class Sync { System, Disk };
  Result<void> flush(Sync sync);
  // Length and index, so that players can jump.
  Result<void> finish();
  // Ends the film at the last flush(): what is left of a failed write goes.
  void abandon();

  std::uint64_t bytes() const;

 private:
  class Implementation;
  explicit MatroskaFile(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace posecoach
