// The coaches to learn from: those that the program carries inside itself, and those that users made of their
// own swings, of motion files or of pictures. A user's reference is a folder of its own, references/NAME,
// with motion.pose.json, or pictures.pose.json where there are only pictures of the coach, and reference.json
// ("posecoach.reference/1").
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/motion/motion.h"
#include "core/motion/pose_track.h"
#include "core/session/disk.h"
#include "core/session/swing.h"

namespace posecoach {

struct Reference {
  std::string name = {};              // as people say it: "Bundled swing", "Anna's driver"
  std::string source = {};            // as `--coach` takes it: "bundled:swing", "reference:annas_driver"
  std::filesystem::path motion = {};  // its file; empty for bundled ones
  bool is_pictures = false;           // that file is what was seen in a film or a picture, no motion
  std::string stroke = {};            // "full swing", "putt", or empty
  std::optional<Handedness> hand = {};
  std::string origin = {};      // the swing's id or the file's name that it was made of
  std::string unreadable = {};  // why it cannot be used; empty otherwise

  bool is_bundled() const { return motion.empty(); }
};

inline constexpr std::string_view kReferencePrefix = "reference:";

class References {
 public:
  explicit References(std::filesystem::path folder, Disk& disk = system_disk())
      : folder_(std::move(folder)), disk_(disk) {}

  // Bundled ones first, then the user's by name.
  std::vector<Reference> list() const;
  // By source or by name. Errors: NotFound, naming those that there are; those of reading reference.json.
  Result<Reference> find(std::string_view source_or_name) const;

  // `name` empty: the person's and the date's. Errors: Incomplete (the swing has no motion), InvalidArgument
  // (the name is taken), Unreadable.
  Result<Reference> add_swing(const Swing& swing, std::string name = {});
  // Any motion file that core/motion reads. `name` empty: the file's.
  Result<Reference> add_motion_file(const std::filesystem::path& file, std::string name = {});
  // What was seen of the coach in a film or a picture, by its source's name; others of that name stay. The
  // same again is the coach that it made before.
  Result<Reference> add_pictures(PoseTrack pictures);
  // What name, stroke, hand and origin of `facts` say.
  Result<Reference> add_motion(const Motion& motion, Reference facts);
  Result<void> remove(std::string_view source);

 private:
  Result<Reference> add(const std::string& pose_json, const Reference& facts);
  std::filesystem::path folder_;
  Disk& disk_;
};

// The bundled motion or the user's reference. Errors: NotFound, those of reading the motion, Unsupported
// (there are only pictures).
Result<Motion> load_reference(const References& references, std::string_view source);

}  // namespace posecoach
