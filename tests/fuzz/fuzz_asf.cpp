#include "core/motion/asf_amc_reader.h"
#include "fuzz_target.h"

using namespace posecoach;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (const auto skeleton = read_asf_skeleton("a.asf", text_of(data, size)); !skeleton)
    check_error(skeleton.error(), "a.asf");
  return 0;
}
