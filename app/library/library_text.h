// Swings of the library as people and as programs read them.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/coaching/block.h"
#include "core/session/library.h"

namespace posecoach {

// One line a swing; unreadable ones say why.
std::string table_of(const std::vector<Swing>& swings);
// Everything about one, line by line.
std::string page_of(const Swing& swing);
// Mean and spread of everything that was measured, as a table.
std::string page_of(const Block& block);

// {"id", "shelf", "folder", "recorded_at", "person", ..., "files": {...}}; "unreadable" where it is.
nlohmann::ordered_json json_of(const Swing& swing);
// {"schema": "posecoach.library/1", "folder", "swings": [...]}
nlohmann::ordered_json json_of(const Library& library, const std::vector<Swing>& swings);

// To a file, or "-" for standard output; nothing where `file` is empty.
Result<void> write_json(const std::string& file, const nlohmann::ordered_json& json);

}  // namespace posecoach
