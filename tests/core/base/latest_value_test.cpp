#include "core/base/latest_value.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>
#include <vector>

namespace posecoach {
namespace {

using namespace std::chrono_literals;

TEST(LatestValue, the_newest_wins_and_what_was_overtaken_is_counted) {
  LatestValue<int> value;
  EXPECT_FALSE(value.try_take());
  for (int i = 1; i <= 5; ++i) value.put(i);
  EXPECT_EQ(value.try_take(), 5);
  EXPECT_FALSE(value.try_take()) << "taken out";
  EXPECT_EQ(value.overtaken(), 4U);
}

TEST(LatestValue, waiting_ends_with_a_value_after_a_while_when_woken_and_when_stopped) {
  LatestValue<int> value;
  EXPECT_FALSE(value.take({}, 1ms));
  value.wake();
  EXPECT_FALSE(value.take({}, 1h));
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(value.take(stop.get_token(), 1h));
  std::jthread giver([&] { value.put(7); });
  EXPECT_EQ(value.take({}, 1h), 7);
}

TEST(LatestValue, a_value_that_came_together_with_a_wake_is_not_lost) {
  LatestValue<int> value;
  value.wake();
  value.put(3);
  EXPECT_EQ(value.take({}, 1h), 3);
}

TEST(LatestValue, under_stress_every_value_is_taken_or_overtaken_and_they_only_rise) {
  constexpr int kValues = 20'000;
  LatestValue<std::vector<int>> value;  // a heap object: a torn hand-over would be seen
  std::jthread giver([&] {
    for (int i = 1; i <= kValues; ++i) value.put(std::vector<int>(16, i));
  });
  int last = 0;
  std::uint64_t taken = 0;
  while (last < kValues) {
    const auto next = value.take({}, 1s);
    if (!next) continue;
    ++taken;
    ASSERT_GT(next->front(), last);
    ASSERT_EQ(next->front(), next->back());
    last = next->front();
  }
  EXPECT_EQ(taken + value.overtaken(), static_cast<std::uint64_t>(kValues));
}

TEST(LatestValue, several_takers_share_without_doubles) {
  constexpr int kValues = 5'000;
  LatestValue<int> value;
  std::vector<std::vector<int>> taken(3);
  {
    std::stop_source stop;
    std::vector<std::jthread> takers;
    for (auto& mine : taken)
      takers.emplace_back([&value, &mine, token = stop.get_token()] {
        while (!token.stop_requested())
          if (const auto next = value.take(token, 10ms)) mine.push_back(*next);
      });
    for (int i = 0; i < kValues; ++i) value.put(i);
    while (value.try_take()) {
    }
    stop.request_stop();
  }
  std::vector<int> all;
  for (const auto& mine : taken) all.insert(all.end(), mine.begin(), mine.end());
  std::sort(all.begin(), all.end());
  EXPECT_EQ(std::adjacent_find(all.begin(), all.end()), all.end());
}

}  // namespace
}  // namespace posecoach
