#include "core/motion/bvh_motion.h"
#include "fuzz_target.h"

using namespace posecoach;

// What is read can be written, and what was written reads again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = text_of(data, size);
  if (const auto skeleton = read_bvh_skeleton("a.bvh", text); !skeleton)
    check_error(skeleton.error(), "a.bvh");
  const auto file = read_bvh("a.bvh", text);
  if (!file) {
    check_error(file.error(), "a.bvh");
    return 0;
  }
  const auto written = bvh_from_motion(file->motion, file->provenance);
  if (!written) return 0;
  if (const auto again = read_bvh("b.bvh", *written); !again) check_error(again.error(), "b.bvh");
  return 0;
}
