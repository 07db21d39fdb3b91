// Wall time: when a swing was recorded, as people say it. It never mixes with media or capture time.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace posecoach {

struct WallTime {
  std::chrono::sys_time<std::chrono::milliseconds> utc{};
  std::chrono::minutes offset{};  // of the clock on the wall where it was taken, ahead of UTC

  bool operator==(const WallTime&) const = default;
};

// Of this machine in its time zone.
WallTime wall_time_now();
// The same moment in this machine's time zone; of a file's date, for one.
WallTime wall_time_at(std::chrono::sys_time<std::chrono::milliseconds> utc);

// "2026-11-22T05:37:10.123+01:00"
std::string to_iso(const WallTime& time);
// As to_iso writes it; parts of a second, and the offset as Z or +01:00, may be missing (then UTC). Errors:
// Malformed.
Result<WallTime> wall_time_from_iso(std::string_view text);

// On the wall: "2026-11-22", "053710", and "2026-11-22 05:37" for lists.
std::string day_of(const WallTime& time);
std::string clock_of(const WallTime& time);
std::string to_words(const WallTime& time);

// "2026-11-22" and nothing else.
bool is_day(std::string_view text);

}  // namespace posecoach
