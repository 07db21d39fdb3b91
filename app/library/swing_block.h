// The last swings of one golfer together: one swing may lie, several tell what is his.
#pragma once

#include <cstddef>

#include "core/coaching/block.h"
#include "core/session/library.h"

namespace posecoach {

inline constexpr std::size_t kBlockSwings = 10;

// `swing` and those before it, at most `most`, of the same person, stroke, view and coach, as they were kept
// with their answers. Swings that were never compared count as none. Errors: those of the library; an answer
// that cannot be read is left out.
Result<Block> block_until(Library& library, const Swing& swing, std::size_t most = kBlockSwings);

}  // namespace posecoach
