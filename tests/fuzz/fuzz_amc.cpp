#include "core/motion/asf_amc_reader.h"
#include "fuzz_target.h"

using namespace posecoach;

namespace {

constexpr std::string_view kSkeleton =
    ":units\n length 0.45\n angle deg\n:root\n order TX TY TZ RX RY RZ\n axis XYZ\n position 0 0 0\n"
    " orientation 0 0 0\n:bonedata\n begin\n name upper\n direction 0 1 0\n length 10\n axis 0 0 0 XYZ\n"
    " dof rx rz\n end\n begin\n name lower\n direction 0 1 0\n length 20\n axis 0 90 0 XYZ\n dof rx\n end\n"
    ":hierarchy\n begin\n root upper\n upper lower\n end\n";

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const AsfDocument skeleton = parse_asf("a.asf", kSkeleton).value();
  if (const auto file = read_amc("a.amc", text_of(data, size), skeleton, 120); !file)
    check_error(file.error(), "a.amc");
  return 0;
}
