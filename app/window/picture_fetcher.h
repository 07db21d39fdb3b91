// Pictures of an opened swing, fetched beside the window's thread: the wanted one first, then those that
// come next. Memory is bounded.
#pragma once

#include <chrono>
#include <condition_variable>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <thread>

#include "core/pipeline/analyzed_swing.h"
#include "ui/screens/window_model.h"

namespace posecoach {

// Lets several threads use one store, one after the other.
std::shared_ptr<PictureStore> make_shared_store(std::shared_ptr<PictureStore> store);

// Whether a store's later pictures come quicker once it has given those before them, as a film's do.
enum class Reading { AsWanted, Ahead };

class PictureFetcher {
 public:
  explicit PictureFetcher(std::shared_ptr<PictureStore> store, Reading reading = Reading::AsWanted);
  ~PictureFetcher();

  // Never waits. The wanted picture, or the nearest that is there, or nothing; and whether the wanted one
  // cannot be read, which the log says once.
  std::optional<ShownPicture> lookup(int wanted);

 private:
  void run(const std::stop_token& stop);
  std::optional<int> next_missing() const;
  bool has_unread() const { return wanted_ >= 0 && read_to_ < read_end_; }

  std::shared_ptr<PictureStore> store_;
  std::mutex mutex_;
  std::condition_variable_any wanted_changed_;
  int wanted_ = 0, shown_ = -1;
  int read_to_ = 0, read_end_ = 0;  // pictures that the store has been made to read ahead
  std::chrono::steady_clock::time_point had_wanted_at_ = std::chrono::steady_clock::now();
  std::map<int, std::shared_ptr<const Image>> pictures_;
  std::list<int> order_;
  std::set<int> unreadable_;
  std::jthread thread_;  // last: it uses all of the above
};

// As the window's model wants it; keeps the fetcher alive.
PictureLookup lookup_of(std::shared_ptr<PictureFetcher> fetcher);

}  // namespace posecoach
