#include "core/session/wall_time.h"

#include <ctime>
#include <optional>

namespace posecoach {
namespace {

using std::chrono::milliseconds;
using std::chrono::minutes;
using std::chrono::year_month_day;

struct OnTheWall {
  int year, month, day, hour, minute, second, millisecond;
};

OnTheWall on_the_wall(const WallTime& time) {
  const auto local = time.utc + time.offset;
  const auto day = std::chrono::floor<std::chrono::days>(local);
  const year_month_day date(day);
  const std::chrono::hh_mm_ss<milliseconds> clock(local - day);
  return {static_cast<int>(date.year()),
          static_cast<int>(static_cast<unsigned>(date.month())),
          static_cast<int>(static_cast<unsigned>(date.day())),
          static_cast<int>(clock.hours().count()),
          static_cast<int>(clock.minutes().count()),
          static_cast<int>(clock.seconds().count()),
          static_cast<int>(clock.subseconds().count())};
}

std::string padded(int number, std::size_t digits) {
  const std::string text = std::to_string(number);
  return text.size() < digits ? std::string(digits - text.size(), '0') + text : text;
}

// Takes digits from the front of the text.
class Digits {
 public:
  explicit Digits(std::string_view text) : rest(text) {}

  bool skip(char wanted) {
    if (rest.empty() || rest.front() != wanted) return false;
    rest.remove_prefix(1);
    return true;
  }
  // Exactly `count` digits.
  std::optional<int> number(std::size_t count) {
    if (rest.size() < count) return {};
    int value = 0;
    for (const char c : rest.substr(0, count)) {
      if (c < '0' || c > '9') return {};
      value = 10 * value + (c - '0');
    }
    rest.remove_prefix(count);
    return value;
  }

  std::string_view rest;
};

std::optional<year_month_day> take_day(Digits& digits) {
  const auto year = digits.number(4);
  const bool first = digits.skip('-');
  const auto month = digits.number(2);
  const bool second = digits.skip('-');
  const auto day = digits.number(2);
  if (!year || !first || !month || !second || !day) return {};
  const year_month_day date(std::chrono::year{*year}, std::chrono::month{static_cast<unsigned>(*month)},
                            std::chrono::day{static_cast<unsigned>(*day)});
  return date.ok() ? std::optional(date) : std::nullopt;
}

std::optional<milliseconds> take_clock(Digits& digits) {
  const auto hour = digits.number(2);
  const bool first = digits.skip(':');
  const auto minute = digits.number(2);
  const bool second_follows = digits.skip(':');
  const auto second = digits.number(2);
  if (!hour || !first || !minute || !second_follows || !second || *hour > 23 || *minute > 59 || *second > 59)
    return {};
  milliseconds clock = std::chrono::hours(*hour) + minutes(*minute) + std::chrono::seconds(*second);
  if (!digits.skip('.')) return clock;
  for (int weight = 100; !digits.rest.empty() && digits.rest.front() >= '0' && digits.rest.front() <= '9';
       weight /= 10)
    clock += milliseconds(weight * *digits.number(1));
  return clock;
}

std::optional<minutes> take_offset(Digits& digits) {
  if (digits.rest.empty() || digits.skip('Z')) return minutes(0);
  const bool is_behind = digits.skip('-');
  if (!is_behind && !digits.skip('+')) return {};
  const auto hour = digits.number(2);
  digits.skip(':');
  const auto minute = digits.number(2);
  if (!hour || !minute || *hour > 14 || *minute > 59) return {};
  const minutes offset = std::chrono::hours(*hour) + minutes(*minute);
  return is_behind ? -offset : offset;
}

}  // namespace

WallTime wall_time_now() {
  return wall_time_at(std::chrono::floor<milliseconds>(std::chrono::system_clock::now()));
}

WallTime wall_time_at(std::chrono::sys_time<milliseconds> utc) {
  const std::time_t seconds = std::chrono::floor<std::chrono::seconds>(utc).time_since_epoch().count();
  std::tm local = {};
  if (::localtime_r(&seconds, &local) == nullptr) return {utc, {}};
  return {utc, std::chrono::floor<minutes>(std::chrono::seconds(local.tm_gmtoff))};
}

std::string to_iso(const WallTime& time) {
  const OnTheWall wall = on_the_wall(time);
  const auto ahead = static_cast<int>(time.offset.count());
  const int size = ahead < 0 ? -ahead : ahead;
  return day_of(time) + "T" + padded(wall.hour, 2) + ":" + padded(wall.minute, 2) + ":" +
         padded(wall.second, 2) + "." + padded(wall.millisecond, 3) + (ahead < 0 ? "-" : "+") +
         padded(size / 60, 2) + ":" + padded(size % 60, 2);
}

Result<WallTime> wall_time_from_iso(std::string_view text) {
  Digits digits(text);
  const auto date = take_day(digits);
  const bool has_clock = date && digits.skip('T');
  const auto clock = has_clock ? take_clock(digits) : std::nullopt;
  const auto offset = clock ? take_offset(digits) : std::nullopt;
  if (!offset || !digits.rest.empty())
    return fail(ErrorCode::Malformed,
                "\"" + std::string(text) + "\" is no date like 2026-11-22T05:37:10+01:00");
  return WallTime{std::chrono::sys_days(*date) + *clock - *offset, *offset};
}

std::string day_of(const WallTime& time) {
  const OnTheWall wall = on_the_wall(time);
  return padded(wall.year, 4) + "-" + padded(wall.month, 2) + "-" + padded(wall.day, 2);
}

std::string clock_of(const WallTime& time) {
  const OnTheWall wall = on_the_wall(time);
  return padded(wall.hour, 2) + padded(wall.minute, 2) + padded(wall.second, 2);
}

std::string to_words(const WallTime& time) {
  const OnTheWall wall = on_the_wall(time);
  return day_of(time) + " " + padded(wall.hour, 2) + ":" + padded(wall.minute, 2);
}

bool is_day(std::string_view text) {
  Digits digits(text);
  return take_day(digits) && digits.rest.empty();
}

}  // namespace posecoach
