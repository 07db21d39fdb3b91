#include "core/coaching/strictness.h"

#include <charconv>
#include <optional>

#include "core/coaching/text/advice_text.h"
#include "core/coaching/text/name_text.h"
#include "core/coaching/text/refusal_text.h"

namespace posecoach {
namespace {

constexpr std::string_view kAll = "all";

std::optional<JudgedPart> part_from(std::string_view name) {
  for (const JudgedPart part : kJudgedParts)
    if (to_string(part) == name) return part;
  return std::nullopt;
}

tl::unexpected<Error> wrong(std::string_view setting) {
  return fail(ErrorCode::InvalidArgument, text::no_strictness(setting));
}

}  // namespace

std::string_view to_string(JudgedPart part) {
  constexpr std::array<std::string_view, kJudgedParts.size()> kNames = {"hips", "trunk", "head",
                                                                        "arms", "legs",  "timing"};
  return kNames[static_cast<std::size_t>(part)];
}

Result<Strictness> Strictness::parse(std::string_view text) {
  Strictness strictness;
  while (!text.empty()) {
    const std::size_t comma = text.find(',');
    const std::string_view setting = text.substr(0, comma);
    text = comma == std::string_view::npos ? std::string_view() : text.substr(comma + 1);
    const std::size_t equals = setting.find('=');
    if (equals == std::string_view::npos) return wrong(setting);
    const std::string_view name = setting.substr(0, equals), number = setting.substr(equals + 1);
    double factor = 0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), factor);
    if (error != std::errc{} || end != number.data() + number.size() || !(factor >= 0 && factor <= kLargest))
      return wrong(setting);
    const auto part = part_from(name);
    if (!part && name != kAll) return wrong(setting);
    for (const JudgedPart each : kJudgedParts)
      if (name == kAll || each == *part) strictness.set(each, factor);
  }
  return strictness;
}

std::string Strictness::words() const {
  std::string harder, softer, never;
  const auto add = [](std::string& list, JudgedPart part) {
    list += (list.empty() ? "" : ", ") + std::string(text::judged_part(part));
  };
  for (const JudgedPart part : kJudgedParts) {
    if (of(part) == 0)
      add(never, part);
    else if (of(part) > 1)
      add(harder, part);
    else if (of(part) < 1)
      add(softer, part);
  }
  return text::strictness(harder, softer, never);
}

}  // namespace posecoach
