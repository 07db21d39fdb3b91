// Films, motions and swings of other libraries into the library: copied, never moved.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/load_motion.h"
#include "core/session/library.h"

namespace posecoach {

struct ImportOptions {
  std::string person, notes;
  std::string coach;  // to be compared with at once; empty: only kept
  std::optional<Handedness> hand;
  LoadOptions load;  // of the pose stage, for comparing; its progress is also that of copying
};

struct Imported {
  std::vector<Swing> swings;
  // What could not be done although the rest was: a swing that is here already, a film in which no swing was
  // found (it is kept all the same).
  std::vector<std::string> remarks;
};

// `input` is a film, a motion file, a pose file, a swing's folder (swing.json in it), a library's folder, or
// a folder of films, of which each becomes a swing. A swing's folder keeps what it says; person and notes are
// for the others. Errors: those of the first input that cannot be read; Cancelled.
Result<Imported> import_swings(Library& library, const std::filesystem::path& input,
                               const ImportOptions& options);

}  // namespace posecoach
