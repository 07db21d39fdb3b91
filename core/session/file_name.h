// Names that people type as names of files, and texts as they are searched for.
#pragma once

#include <string>
#include <string_view>

namespace posecoach {

// "Søren B. Ek" -> "soren_b_ek": small letters without accents, digits and single underscores, and letters of
// other scripts as they are; at most 40 bytes, good on every file system; "unnamed" where nothing is left.
std::string file_name_from(std::string_view text);

// Small letters without accents, for comparing: Latin, Greek and Cyrillic. Bytes that are no UTF-8 stay.
std::string folded(std::string_view text);

}  // namespace posecoach
