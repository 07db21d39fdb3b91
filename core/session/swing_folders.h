// The swings of a library's folder as they lie on the disk: YYYY-MM-DD/NAME and Trash/YYYY-MM-DD/NAME.
#pragma once

#include <filesystem>
#include <vector>

#include "core/session/swing.h"
#include "core/session/swing_index.h"

namespace posecoach {

std::filesystem::path shelf_folder(const std::filesystem::path& library, Shelf shelf);

// Of both shelves, oldest first. Errors: Unreadable.
Result<std::vector<FoundSwing>> find_swings(const std::filesystem::path& library);

// The swings that `id` may mean: the whole id, the folder's own name, or the end of that.
std::vector<FoundSwing> matching(const std::vector<FoundSwing>& swings, std::string_view id);

}  // namespace posecoach
