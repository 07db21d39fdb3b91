// The paper's network at work, with weights from anywhere.
#pragma once

#include "core/motion/motion.h"
#include "core/retarget/network/paper_trainer.h"

namespace posecoach {

// Errors: Malformed (no weights of the paper's network).
Result<PaperNetwork> load_paper_network(std::string_view bytes, const std::string& name);

// Errors: Incomplete naming the joints that either skeleton lacks. Throws libtorch's exceptions.
Result<Motion> carried_by(PaperNetwork network, const Motion& coach, const Skeleton& body);

}  // namespace posecoach
