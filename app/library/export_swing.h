// A kept swing as files for other programs and people.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/load_motion.h"
#include "core/session/library.h"
#include "ui/render/figure.h"

namespace posecoach {

struct ExportOptions {
  std::string coach;  // for page and drawn film; empty: the one that it was compared with
  LoadOptions load;
  Palette palette = Palette::RedGreen;  // of page and drawn film
  Library* library = nullptr;           // the page then tells of the golfer's last swings, too
  bool has_drawings = false;            // lines and angles of marks.json are drawn on the film, too
};

// The kind is told by the end of the name:
//   .csv           the student's joints in metres; .picture.csv in pixels of the film
//   .bvh .trc      the student's motion
//   .pose.json     what the pose stage saw, or the motion
//   .body.json     the student's body
//   .analysis.json the answer
//   .html          the report with pictures
//   .overlay.mp4   the film with both skeletons drawn over it
//   any other      the film as it was recorded (its own ending, or the message tells it)
// Each file is written whole or not at all. Errors: InvalidArgument (an ending that is none of these),
// Incomplete (the swing has no such thing), those of writing; Cancelled.
Result<void> export_swing(const Swing& swing, const std::filesystem::path& file,
                          const ExportOptions& options);

// Everything that there is, into a folder (which is made) as swing_053710_k3f.csv, .bvh, ...; returns the
// files.
Result<std::vector<std::filesystem::path>> export_everything(const Swing& swing,
                                                             const std::filesystem::path& folder,
                                                             const ExportOptions& options);

}  // namespace posecoach
