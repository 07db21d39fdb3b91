// The last seconds before a swing was known to be one: what the pose stage saw, and its pictures, compressed.
#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/pipeline/analyzed_swing.h"
#include "core/pipeline/background_work.h"

namespace posecoach {

// One picture that is raw until somebody has had the time to compress it. Any thread.
class StoredPicture {
 public:
  explicit StoredPicture(std::shared_ptr<const Image> image) : image_(std::move(image)) {}
  void compress();
  Result<std::shared_ptr<const Image>> picture() const;
  std::size_t bytes() const;

 private:
  mutable std::mutex mutex_;
  std::shared_ptr<const Image> image_;  // null once compressed
  std::string jpeg_;
};

// A swing's pictures in memory.
class MemoryPictures : public PictureStore {
 public:
  struct Entry {
    MediaTime time;
    std::shared_ptr<const StoredPicture> stored;
  };
  explicit MemoryPictures(std::vector<Entry> entries) : entries_(std::move(entries)) {}

  std::size_t count() const override { return entries_.size(); }
  MediaTime time(std::size_t index) const override { return entries_[index].time; }
  Result<std::shared_ptr<const Image>> picture(std::size_t index) override {
    return entries_[index].stored->picture();
  }

 private:
  std::vector<Entry> entries_;
};

struct SwingMemoryOptions {
  double seconds = 13;
  std::size_t most_bytes = 400'000'000;
};

class SwingMemory {
 public:
  explicit SwingMemory(BackgroundWork& work, const SwingMemoryOptions& options = {})
      : work_(work), options_(options) {}

  void add(const Frame& frame, const PoseObservation& seen);
  void clear() { moments_.clear(); }
  double seconds_held() const;
  std::size_t bytes_held() const;

  struct Cut {
    PoseTrack track;  // its first frame is frame 0 at time 0
    std::shared_ptr<PictureStore> pictures;
  };
  // Everything seen from `begin` to `end`, as far as it is remembered.
  Cut cut(MediaTime begin, MediaTime end, std::string source) const;

 private:
  struct Moment {
    PoseObservation seen;
    int width = 0, height = 0;
    std::shared_ptr<StoredPicture> picture;
  };
  BackgroundWork& work_;
  SwingMemoryOptions options_;
  std::deque<Moment> moments_;
};

}  // namespace posecoach
