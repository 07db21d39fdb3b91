#include "app/window/picture_fetcher.h"

#include <algorithm>

#include "capture/open_source.h"
#include "core/base/log.h"
#include "core/image/image_codec.h"

namespace posecoach {
namespace {

constexpr std::size_t kMostPictures = 64;
constexpr int kAhead = 10;
constexpr std::size_t kMostJpegBytes = std::size_t{200} << 20;

class SharedStore : public PictureStore {
 public:
  explicit SharedStore(std::shared_ptr<PictureStore> store) : store_(std::move(store)) {}
  std::size_t count() const override {
    const std::lock_guard lock(mutex_);
    return store_->count();
  }
  MediaTime time(std::size_t index) const override {
    const std::lock_guard lock(mutex_);
    return store_->time(index);
  }
  Result<std::shared_ptr<const Image>> picture(std::size_t index) override {
    const std::lock_guard lock(mutex_);
    return store_->picture(index);
  }

 private:
  mutable std::mutex mutex_;
  std::shared_ptr<PictureStore> store_;
};

// Reads on from where it is and keeps what it passed as JPEGs; only far back does it start over.
class FilmStore : public PictureStore {
 public:
  FilmStore(std::string path, const PoseTrack& track) : path_(std::move(path)) {
    for (const PoseObservation& seen : track.frames) times_.push_back(seen.time);
  }
  std::size_t count() const override { return times_.size(); }
  MediaTime time(std::size_t index) const override { return times_[index]; }

  Result<std::shared_ptr<const Image>> picture(std::size_t index) override {
    if (const auto kept = kept_.find(index); kept != kept_.end()) {
      Result<Image> image = decode_image(kept->second, path_);
      if (!image) return tl::unexpected(image.error());
      return std::make_shared<const Image>(*std::move(image));
    }
    if (!film_ || index < next_) {
      Result<std::unique_ptr<FrameSource>> opened = open_source(path_);
      if (!opened) return tl::unexpected(opened.error());
      film_ = *std::move(opened);
      next_ = 0;
    }
    while (true) {
      Result<std::optional<Frame>> frame = film_->next({});
      if (!frame) return tl::unexpected(frame.error());
      if (!*frame)
        return fail(ErrorCode::Incomplete, path_ + ": the film ends before picture " + std::to_string(index));
      const std::size_t at = next_++;
      if (!kept_.contains(at)) keep(at, encode_jpeg(*(**frame).image, 90));
      if (at == index) return (**frame).image;
    }
  }

 private:
  void keep(std::size_t index, std::string jpeg) {
    bytes_ += jpeg.size();
    kept_[index] = std::move(jpeg);
    while (bytes_ > kMostJpegBytes && kept_.size() > 1) {
      // The picture farthest away goes.
      const auto first = kept_.begin(), last = std::prev(kept_.end());
      const auto far = index - first->first > last->first - index ? first : last;
      bytes_ -= far->second.size();
      kept_.erase(far);
    }
  }

  std::string path_;
  std::vector<MediaTime> times_;
  std::unique_ptr<FrameSource> film_;
  std::size_t next_ = 0, bytes_ = 0;
  std::map<std::size_t, std::string> kept_;
};

}  // namespace

std::shared_ptr<PictureStore> make_shared_store(std::shared_ptr<PictureStore> store) {
  return std::make_shared<SharedStore>(std::move(store));
}

Result<std::shared_ptr<PictureStore>> open_film_store(const std::string& path, const PoseTrack& track) {
  if (const auto opened = open_source(path); !opened) return tl::unexpected(opened.error());
  return std::make_shared<FilmStore>(path, track);
}

PictureFetcher::PictureFetcher(std::shared_ptr<PictureStore> store)
    : store_(std::move(store)), thread_([this](const std::stop_token& stop) { run(stop); }) {}

PictureFetcher::~PictureFetcher() = default;

std::optional<ShownPicture> PictureFetcher::lookup(int wanted) {
  const std::lock_guard lock(mutex_);
  if (wanted != wanted_ || !pictures_.contains(wanted)) {
    wanted_ = wanted;
    wanted_changed_.notify_one();
  }
  if (pictures_.contains(wanted)) shown_ = wanted;
  const auto found = pictures_.find(shown_);
  if (found == pictures_.end()) return std::nullopt;
  return ShownPicture{found->first, found->second};
}

std::optional<int> PictureFetcher::next_missing() const {
  const int count = static_cast<int>(store_->count());
  if (wanted_ < 0 || wanted_ >= count) return std::nullopt;
  for (int i = wanted_; i < std::min(count, wanted_ + kAhead); ++i)
    if (!pictures_.contains(i)) return i;
  return std::nullopt;
}

void PictureFetcher::run(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    const std::optional<int> missing = next_missing();
    if (!missing) {
      wanted_changed_.wait(lock, stop, [&] { return next_missing().has_value(); });
      continue;
    }
    lock.unlock();
    Result<std::shared_ptr<const Image>> picture = store_->picture(static_cast<std::size_t>(*missing));
    lock.lock();
    if (!picture) {
      log::warning(picture.error().message);
      return;
    }
    pictures_[*missing] = *std::move(picture);
    order_.push_back(*missing);
    while (pictures_.size() > kMostPictures) {
      const int oldest = order_.front();
      order_.pop_front();
      if (oldest == shown_ || oldest == wanted_)
        order_.push_back(oldest);
      else
        pictures_.erase(oldest);
    }
  }
}

PictureLookup lookup_of(std::shared_ptr<PictureFetcher> fetcher) {
  return [fetcher = std::move(fetcher)](int wanted) { return fetcher->lookup(wanted); };
}

}  // namespace posecoach
