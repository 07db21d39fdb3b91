#include "core/pipeline/swing_memory.h"

#include "core/image/image_codec.h"

namespace posecoach {
namespace {

// Good enough for the replay and for looking at a hand; a third of the size of the best.
constexpr int kQuality = 85;

}  // namespace

void StoredPicture::compress() {
  std::shared_ptr<const Image> image;
  {
    const std::lock_guard lock(mutex_);
    image = image_;
  }
  if (!image) return;
  std::string jpeg = encode_jpeg(*image, kQuality);
  const std::lock_guard lock(mutex_);
  jpeg_ = std::move(jpeg);
  image_.reset();
}

Result<std::shared_ptr<const Image>> StoredPicture::picture() const {
  {
    const std::lock_guard lock(mutex_);
    if (image_) return image_;
  }
  // Compressed once and for all: nobody changes it any more.
  Result<Image> decoded = decode_image(jpeg_, "a picture of the last seconds");
  if (!decoded) return tl::unexpected(decoded.error());
  return std::make_shared<const Image>(*std::move(decoded));
}

std::size_t StoredPicture::bytes() const {
  const std::lock_guard lock(mutex_);
  return image_ ? image_->rgb.size() : jpeg_.size();
}

void SwingMemory::add(const Frame& frame, const PoseObservation& seen) {
  auto picture = std::make_shared<StoredPicture>(frame.image);
  moments_.push_back({seen, frame.image->width, frame.image->height, picture});
  work_.start([picture] { picture->compress(); });
  while (to_seconds(frame.time - moments_.front().seen.time) > options_.seconds) moments_.pop_front();
  // Counting is cheap once in a while only.
  if (frame.index % 16 == 0)
    while (moments_.size() > 1 && bytes_held() > options_.most_bytes) moments_.pop_front();
}

double SwingMemory::seconds_held() const {
  return moments_.empty() ? 0 : to_seconds(moments_.back().seen.time - moments_.front().seen.time);
}

std::size_t SwingMemory::bytes_held() const {
  std::size_t sum = 0;
  for (const Moment& moment : moments_) sum += moment.picture->bytes();
  return sum;
}

SwingMemory::Cut SwingMemory::cut(MediaTime begin, MediaTime end, std::string source) const {
  Cut cut;
  cut.track.source = std::move(source);
  std::vector<MemoryPictures::Entry> entries;
  std::optional<MediaTime> first;
  for (const Moment& moment : moments_) {
    if (moment.seen.time < begin || moment.seen.time > end) continue;
    if (!first) {
      first = moment.seen.time;
      cut.track.width = moment.width;
      cut.track.height = moment.height;
    }
    const MediaTime time(moment.seen.time - *first);
    cut.track.frames.push_back({entries.size(), time, moment.seen.person});
    entries.push_back({time, moment.picture});
  }
  cut.pictures = std::make_shared<MemoryPictures>(std::move(entries));
  return cut;
}

}  // namespace posecoach
