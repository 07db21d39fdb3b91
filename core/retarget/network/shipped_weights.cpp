#include "core/retarget/network/shipped_weights.h"

#include "core/base/embedded.h"

POSECOACH_EMBEDDED(retarget_paper_weights)
POSECOACH_EMBEDDED(retarget_network_weights)

namespace posecoach {

std::string_view shipped_paper_weights() {
  return retarget_paper_weights();
}

std::string_view shipped_network_weights() {
  return retarget_network_weights();
}

}  // namespace posecoach
