#include "core/motion/c3d_reader.h"
#include "fuzz_target.h"

using namespace posecoach;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  auto track = read_c3d("a.c3d", text_of(data, size));
  if (!track) {
    check_error(track.error(), "a.c3d");
    return 0;
  }
  if (const auto motion = motion_from_markers("a.c3d", *std::move(track)); !motion)
    check_error(motion.error(), "a.c3d");
  return 0;
}
