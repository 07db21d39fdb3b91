// Folders of motions as the transfer's training and evaluation read them.
#pragma once

#include <filesystem>

#include "core/transfer/paired_data.h"

namespace posecoach {

// Every motion file below the folder but those in folders named `paired`, which are for measuring, and the
// bundled motions. Files that hold no whole body are passed over,
// with a warning. Errors: NotFound, Incomplete (none at all).
Result<std::vector<PoseClip>> read_training_clips(const std::filesystem::path& folder);

// <folder>/<character>/<motion>.*: files of the same name are the same motion. Errors: NotFound, Incomplete
// when no two characters have a motion in common, and those of the readers.
Result<std::vector<Character>> read_characters(const std::filesystem::path& folder);

}  // namespace posecoach
