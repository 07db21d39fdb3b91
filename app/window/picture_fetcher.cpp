#include "app/window/picture_fetcher.h"

#include <algorithm>
#include <iterator>

#include "core/base/log.h"

namespace posecoach {
namespace {

constexpr std::size_t kMostPictures = 64;
constexpr int kAhead = 10;
constexpr int kMostRead = 1500;  // of a longer film the store would not keep them

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

}  // namespace

std::shared_ptr<PictureStore> make_shared_store(std::shared_ptr<PictureStore> store) {
  return std::make_shared<SharedStore>(std::move(store));
}

PictureFetcher::PictureFetcher(std::shared_ptr<PictureStore> store, Reading reading)
    : store_(std::move(store)),
      read_end_(reading == Reading::Ahead && store_->count() <= kMostRead ? static_cast<int>(store_->count())
                                                                          : 0),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

PictureFetcher::~PictureFetcher() = default;

std::optional<ShownPicture> PictureFetcher::lookup(int wanted) {
  const std::lock_guard lock(mutex_);
  const bool is_unreadable = unreadable_.contains(wanted);
  if (wanted != wanted_ || (!pictures_.contains(wanted) && !is_unreadable)) {
    wanted_ = wanted;
    wanted_changed_.notify_one();
  }
  // Meanwhile the nearest: a film that is played faster than it is fetched still moves.
  const auto after = pictures_.lower_bound(wanted);
  if (after != pictures_.end()) shown_ = after->first;
  if (after != pictures_.begin())
    if (const int before = std::prev(after)->first;
        after == pictures_.end() || wanted - before < after->first - wanted)
      shown_ = before;
  const auto now = std::chrono::steady_clock::now();
  if (shown_ == wanted) had_wanted_at_ = now;
  const auto found = pictures_.find(shown_);
  const double waited_s = std::chrono::duration<double>(now - had_wanted_at_).count();
  if (found != pictures_.end()) return ShownPicture{found->first, found->second, waited_s, is_unreadable};
  if (is_unreadable) return ShownPicture{wanted, nullptr, waited_s, true};
  return std::nullopt;
}

std::optional<int> PictureFetcher::next_missing() const {
  const int count = static_cast<int>(store_->count());
  if (wanted_ < 0 || wanted_ >= count) return std::nullopt;
  for (int i = wanted_; i < std::min(count, wanted_ + kAhead); ++i)
    if (!pictures_.contains(i) && !unreadable_.contains(i)) return i;
  return std::nullopt;
}

void PictureFetcher::run(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    const std::optional<int> missing = next_missing();
    if (!missing && !has_unread()) {
      wanted_changed_.wait(lock, stop, [&] { return next_missing().has_value(); });
      continue;
    }
    if (!missing) {
      const auto next = static_cast<std::size_t>(read_to_++);
      lock.unlock();
      const bool is_read = store_->picture(next).has_value();
      lock.lock();
      if (!is_read) read_end_ = 0;
      continue;
    }
    lock.unlock();
    Result<std::shared_ptr<const Image>> picture = store_->picture(static_cast<std::size_t>(*missing));
    lock.lock();
    if (!picture) {
      // Those before and after it may still be whole.
      if (unreadable_.empty()) log::warning(picture.error().message);
      unreadable_.insert(*missing);
      continue;
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
