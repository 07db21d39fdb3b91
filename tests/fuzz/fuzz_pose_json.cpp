#include "core/motion/pose_file.h"
#include "fuzz_target.h"

using namespace posecoach;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto content = read_pose_json("a.pose.json", text_of(data, size));
  if (!content) {
    check_error(content.error(), "a.pose.json");
    return 0;
  }
  if (const auto* motion = std::get_if<Motion>(&*content)) {
    const auto again = read_pose_json("b.pose.json", pose_json_from_motion(*motion, "a"));
    if (!again) check_error(again.error(), "b.pose.json");
  }
  return 0;
}
