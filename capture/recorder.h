// Records a film while it happens, before everything else: on a thread of its own, into a file that a crash
// cannot spoil. Cut short at any moment, even by kill -9, the film opens and misses at most the last second.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/image/frame.h"

namespace posecoach {

enum class RecorderCodec {
  Automatic,  // H.264 where this machine keeps up with it (tried on the first frames), else Jpeg
  H264,
  Jpeg
};

struct RecorderOptions {
  double nominal_fps = 30;  // of the source; frames keep their own times whatever they are
  RecorderCodec codec = RecorderCodec::Automatic;
  std::size_t most_queued_bytes = std::size_t{384} << 20;
  // The recording ends cleanly when the disk has less than this left.
  std::uint64_t reserved_disk_bytes = std::uint64_t{64} << 20;
};

struct RecorderStatus {
  std::size_t offered = 0;
  std::size_t written = 0;
  std::size_t dropped = 0;  // the queue was full: 0 in a good recording
  std::size_t queued = 0;   // waiting now
  std::size_t most_queued = 0;
  std::uint64_t bytes = 0;       // on the disk
  Duration length{};             // of the film so far
  double minutes_left = 0;       // that fit on the disk, at the rate so far
  std::string codec;             // "H.264", "JPEG"; empty before the first frame
  std::optional<Error> failure;  // disk full: the film ended there; what was written is whole
  std::filesystem::path path;
};

// A written frame: the film's frame k was the source's frame `index`.
struct RecordedFrame {
  std::size_t index = 0;
  Duration time{};  // from the first
};

class Recorder {
 public:
  // `path` ends in .mkv. The film takes its size from the first frame; later ones of another size are scaled.
  // Errors: InvalidArgument, NotFound or Unreadable (folder, permission, disk full already now).
  static Result<std::unique_ptr<Recorder>> start(const std::filesystem::path& path,
                                                 const RecorderOptions& options = {});
  // Finishes.
  ~Recorder();

  // From one thread at a time; never waits. No frame is copied. False: not taken, because the queue is full
  // or the recording has failed.
  bool offer(const Frame& frame);
  // From any thread.
  RecorderStatus status() const;
  // Writes what is queued and closes the film. A recording that failed returns its failure, as does one
  // without any frame (Incomplete), which leaves no file.
  Result<RecorderStatus> finish();
  // Once finished.
  const std::vector<RecordedFrame>& frames() const;

 private:
  class Implementation;
  explicit Recorder(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

// Before a recording: what fits on the disk of `folder`, or of its nearest folder that exists.
struct RecordingRoom {
  std::uint64_t free_bytes = 0;
  double minutes = 0;  // estimated
};
Result<RecordingRoom> recording_room(const std::filesystem::path& folder, int width, int height, double fps);

}  // namespace posecoach
