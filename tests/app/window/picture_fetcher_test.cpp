#include "app/window/picture_fetcher.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace posecoach {
namespace {

using namespace std::chrono_literals;

// Picture k is k + 1 pixels wide. Each takes its time, and may have to wait for the test's leave.
class NumberedStore : public PictureStore {
 public:
  explicit NumberedStore(std::size_t count, std::size_t broken_from = 1'000'000)
      : count_(count), broken_from_(broken_from) {}
  std::size_t count() const override { return count_; }
  MediaTime time(std::size_t index) const override { return MediaTime(33ms * static_cast<int>(index)); }
  Result<std::shared_ptr<const Image>> picture(std::size_t index) override {
    {
      const std::scoped_lock lock(mutex_);
      asked_.push_back(index);
    }
    while (is_held) std::this_thread::sleep_for(1ms);
    if (index >= broken_from_)
      return fail(ErrorCode::Incomplete, "film.mp4: it ends before picture " + std::to_string(index));
    return std::make_shared<const Image>(Image::black(static_cast<int>(index) + 1, 1));
  }
  std::vector<std::size_t> asked() const {
    const std::scoped_lock lock(mutex_);
    return asked_;
  }
  std::atomic<bool> is_held = false;

 private:
  std::size_t count_, broken_from_;
  mutable std::mutex mutex_;
  std::vector<std::size_t> asked_;
};

ShownPicture wait_for(PictureFetcher& fetcher, int wanted) {
  while (true) {
    if (const auto shown = fetcher.lookup(wanted); shown && shown->frame == wanted) return *shown;
    std::this_thread::sleep_for(1ms);
  }
}

TEST(PictureFetcher, gives_the_picture_that_was_asked_for) {
  PictureFetcher fetcher(std::make_shared<NumberedStore>(200));
  for (const int wanted : {0, 17, 199, 3, 120, 4}) {
    const ShownPicture shown = wait_for(fetcher, wanted);
    EXPECT_EQ(shown.image->width, wanted + 1);
    EXPECT_EQ(shown.waited_s, 0);
  }
}

TEST(PictureFetcher, what_was_asked_for_last_comes_first) {
  const auto store = std::make_shared<NumberedStore>(1000);
  store->is_held = true;
  PictureFetcher fetcher(store);
  while (store->asked().empty()) std::this_thread::sleep_for(1ms);
  // While one picture is on its way the user drags over the film.
  for (const int passed : {100, 200, 300, 400, 500}) EXPECT_FALSE(fetcher.lookup(passed));
  store->is_held = false;
  wait_for(fetcher, 500);
  const std::vector<std::size_t> asked = store->asked();
  ASSERT_GE(asked.size(), 2U);
  EXPECT_EQ(asked[1], 500U);
  for (const std::size_t passed : {100U, 200U, 300U, 400U})
    EXPECT_THAT(asked, testing::Not(testing::Contains(passed)));
}

TEST(PictureFetcher, shows_the_nearest_meanwhile_and_tells_how_long_the_wanted_one_has_been_missing) {
  const auto store = std::make_shared<NumberedStore>(1000);
  PictureFetcher fetcher(store);
  wait_for(fetcher, 50);
  wait_for(fetcher, 59);  // fetched ahead
  store->is_held = true;
  (void)fetcher.lookup(300);
  std::this_thread::sleep_for(20ms);
  const auto meanwhile = fetcher.lookup(300);
  ASSERT_TRUE(meanwhile);
  EXPECT_GE(meanwhile->frame, 59);
  EXPECT_LT(meanwhile->frame, 80);
  EXPECT_EQ(meanwhile->image->width, meanwhile->frame + 1);
  EXPECT_GT(meanwhile->waited_s, 0.015);
  store->is_held = false;
  EXPECT_EQ(wait_for(fetcher, 300).waited_s, 0);
}

TEST(PictureFetcher, fetches_what_comes_next_before_it_is_wanted_but_not_the_whole_film) {
  const auto store = std::make_shared<NumberedStore>(5000);
  PictureFetcher fetcher(store);
  wait_for(fetcher, 700);
  while (store->asked().back() != 709) std::this_thread::sleep_for(1ms);
  std::this_thread::sleep_for(50ms);
  EXPECT_EQ(store->asked().back(), 709U);
}

TEST(PictureFetcher, reads_a_whole_film_ahead_where_that_makes_its_pictures_quick) {
  const auto store = std::make_shared<NumberedStore>(300);
  PictureFetcher fetcher(store, Reading::Ahead);
  wait_for(fetcher, 0);
  while (store->asked().size() < 310) std::this_thread::sleep_for(1ms);
  const std::vector<std::size_t> asked = store->asked();
  for (std::size_t i = 0; i < 300; ++i) EXPECT_THAT(asked, testing::Contains(i));
}

TEST(PictureFetcher, says_once_what_is_wrong_and_goes_on_showing_what_there_is) {
  const auto store = std::make_shared<NumberedStore>(100, 40);
  PictureFetcher fetcher(store);
  testing::internal::CaptureStderr();
  wait_for(fetcher, 30);
  // The last that can be read has been; those after it cannot.
  while (store->asked().back() < 39) std::this_thread::sleep_for(1ms);
  for (int wanted = 39; wanted < 100; wanted += 10) {
    (void)fetcher.lookup(wanted);
    std::this_thread::sleep_for(5ms);
  }
  std::optional<ShownPicture> shown = fetcher.lookup(90);
  while (!shown->is_wanted_unreadable) {
    std::this_thread::sleep_for(1ms);
    shown = fetcher.lookup(90);
  }
  EXPECT_EQ(shown->frame, 39);
  // One before the hole is still to be had.
  EXPECT_EQ(wait_for(fetcher, 10).image->width, 11);
  EXPECT_FALSE(fetcher.lookup(10)->is_wanted_unreadable);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_THAT(said, testing::HasSubstr("it ends before picture"));
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
}

TEST(PictureFetcher, ends_while_a_picture_is_on_its_way) {
  const auto store = std::make_shared<NumberedStore>(100);
  store->is_held = true;
  std::jthread later([store] {
    std::this_thread::sleep_for(30ms);
    store->is_held = false;
  });
  PictureFetcher fetcher(store);
  EXPECT_FALSE(fetcher.lookup(5));
}

TEST(PictureFetcher, memory_is_bounded_however_far_the_film_is_played) {
  PictureFetcher fetcher(std::make_shared<NumberedStore>(2000));
  std::vector<std::weak_ptr<const Image>> seen;
  for (int frame = 0; frame < 1000; ++frame) seen.push_back(wait_for(fetcher, frame).image);
  const auto kept =
      std::count_if(seen.begin(), seen.end(), [](const auto& image) { return !image.expired(); });
  EXPECT_LE(kept, 64);
}

}  // namespace
}  // namespace posecoach
