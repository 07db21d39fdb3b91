// The trained methods, seen from outside: weights come with the program. Without libtorch's types, so that
// anyone may include this.
#pragma once

#include <filesystem>

#include "core/motion/motion.h"

namespace posecoach {

// `network`: a filmed motion without the camera's errors, on the same skeleton, with rotations and exact
// bones. A motion beyond doubt (core/retarget/doubt.h) comes back as it is. Errors: Internal (libtorch).
Result<Motion> corrected_motion(const Motion& motion);

// `paper`: the coach's motion on another body, by the paper's network; `weights` as `posecoach train
// retarget` writes them, empty for the program's own. With the coach's times and rotations. Errors:
// Incomplete naming the joints that either skeleton lacks, those of reading weights, Internal.
Result<Motion> carried_by_paper_network(const Motion& coach, const Skeleton& body,
                                        const std::filesystem::path& weights = {});

}  // namespace posecoach
