#include "core/motion/trc.h"
#include "fuzz_target.h"

using namespace posecoach;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  auto track = read_trc("a.trc", text_of(data, size));
  if (!track) {
    check_error(track.error(), "a.trc");
    return 0;
  }
  const auto motion = motion_from_markers("a.trc", *std::move(track));
  if (!motion) {
    check_error(motion.error(), "a.trc");
    return 0;
  }
  const auto again = read_trc("b.trc", trc_from_motion("b.trc", *motion));
  if (!again) check_error(again.error(), "b.trc");
  return 0;
}
