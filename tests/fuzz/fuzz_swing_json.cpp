#include "core/session/plain_json.h"
#include "core/session/swing.h"
#include "fuzz_target.h"

using namespace posecoach;

// What reads back is the same swing, and what is not known of it stays.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto swing = swing_from_json("2026-06-01/swing_120000_abc", text_of(data, size));
  if (!swing) {
    check_error(swing.error(), "swing.json");
    return 0;
  }
  const std::string once = swing_to_json(*swing, text_of(data, size));
  const auto again = swing_from_json("2026-06-01/swing_120000_abc", once);
  POSECOACH_ASSERT(again.has_value());
  const std::string twice = swing_to_json(*again, once);
  POSECOACH_ASSERT(parse_plain_json("once", once).value() == parse_plain_json("twice", twice).value());
  for (const auto& [name, stored] : swing->files)
    POSECOACH_ASSERT(name.find('/') == std::string::npos && name != "..");
  return 0;
}
