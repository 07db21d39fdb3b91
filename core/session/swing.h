// A recorded swing as the library keeps it: a plain folder YYYY-MM-DD/swing_HHMMSS_xxx with
//
//   film.mkv           the film as it was recorded (or film.mp4, ... as it was imported)
//   pose.pose.json     what the pose stage saw, frame by frame
//   student.pose.json  the student's motion in the world; or the motion file as it was imported
//   student.body.json  the student's body
//   coach.pose.json    the coach's motion in the student's body, as it was compared
//   analysis.json      the answer ("posecoach.analysis/1")
//   thumb.jpg          a small picture
//   swing.json         everything else ("posecoach.swing/1"), with the length and SHA-256 of each file
//
// Any of them but swing.json may be missing.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/body/mirror.h"
#include "core/session/wall_time.h"

namespace posecoach {

// Of a recording: frames that the camera gave, and what became of them.
struct RecordingCounters {
  std::uint64_t captured = 0, lost_by_camera = 0, lost_by_recorder = 0, skipped_by_pose = 0;
};

struct SwingFacts {
  WallTime recorded_at;
  std::string person;  // name; empty: not known
  std::string coach;   // the reference's source ("bundled:swing") that it was compared with
  std::string view;    // "face-on", "down-the-line", "between", or empty
  std::optional<Handedness> hand;
  std::string stroke;  // "full swing", "putt", or empty
  std::string notes;
  bool star = false;
  double seconds = 0;
  int frames = 0;
  std::optional<double> score_percent;
  double score_plus_minus = 0;
  std::string advice;  // the most important one
  std::string camera;  // name and mode, as people say it
  std::string source;  // what it was imported from
  RecordingCounters counters;
};

struct StoredFile {
  std::uint64_t bytes = 0;
  std::string sha256;  // 64 hexadecimal digits
};

enum class Shelf { Kept, Trash };

struct Swing {
  std::string id;  // "2026-11-22/swing_053710_k3f"
  Shelf shelf = Shelf::Kept;
  std::filesystem::path folder;  // absolute
  SwingFacts facts;
  std::map<std::string, StoredFile> files;  // by name, without swing.json
  // Why the rest could not be read; empty for a good swing. Then only id, shelf and folder count.
  std::string unreadable;

  bool is_readable() const { return unreadable.empty(); }
  // The file of this kind, by the start of its name: "film", "pose", "student", "student.body", "coach",
  // "analysis", "thumb"; nothing where there is none.
  std::optional<std::filesystem::path> file(std::string_view kind) const;
};

inline constexpr const char* kSwingFile = "swing.json";
inline constexpr std::size_t kLargestSwingFile = std::size_t{1} << 22;  // bytes

// Errors: those of files; Malformed with file and line; Unsupported (made by a newer version).
Result<Swing> read_swing(const std::filesystem::path& folder);
// The same from the text of the folder's swing.json.
Result<Swing> swing_from_json(const std::filesystem::path& folder, std::string_view text);
// The text of swing.json; the keys of `old_text` (empty for none) that this version does not know are kept.
std::string swing_to_json(const Swing& swing, std::string_view old_text);

}  // namespace posecoach
