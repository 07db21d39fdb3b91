// The transfers that need no training: scale, bones, ratio.
#pragma once

#include "core/transfer/transferer.h"

namespace posecoach {

// Asserts one of Scale, Bones, Ratio.
std::unique_ptr<Transferer> make_closed_form_transferer(TransferMethod method);

}  // namespace posecoach
