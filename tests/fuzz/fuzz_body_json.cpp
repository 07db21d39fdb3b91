#include "core/body/body_file.h"
#include "fuzz_target.h"

using namespace posecoach;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto body = body_from_json(text_of(data, size), "a.body.json");
  if (!body) {
    check_error(body.error(), "a.body.json");
    return 0;
  }
  if (const auto again = body_from_json(body_to_json(*body), "b.body.json"); !again)
    check_error(again.error(), "b.body.json");
  return 0;
}
