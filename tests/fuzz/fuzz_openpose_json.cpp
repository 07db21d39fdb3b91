#include "core/motion/openpose_reader.h"
#include "fuzz_target.h"

using namespace posecoach;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (const auto people = read_openpose_json("a.json", text_of(data, size)); !people)
    check_error(people.error(), "a.json");
  return 0;
}
