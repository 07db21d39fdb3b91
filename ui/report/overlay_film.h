// The student's film with both skeletons and the score drawn over it, and still pictures of its worst
// moments. Frames come from and go to whoever the caller names: no film reader or writer is known here.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/image/camera.h"
#include "ui/render/coach_placement.h"
#include "ui/render/overlay_scene.h"
#include "ui/render/scene_renderer.h"
#include "ui/report/comparison.h"
#include "ui/report/report_picture.h"
#include "ui/report/stills.h"

namespace posecoach {

class OverlayFilm {
 public:
  // `camera` stands still over the film; the student's motion is in its world. A context must be current now
  // and while drawing.
  OverlayFilm(const Comparison& comparison, const PinholeCamera& camera, SceneRenderer& renderer);

  // A frame of the film, in its own size.
  Image draw(const Frame& frame);
  // The same moment without score and timeline, cut out around both bodies, with the joint ringed that it is
  // about.
  ReportPicture draw_still(const Frame& frame, const StillMoment& still);

 private:
  struct Bodies;
  // The coach in the pose of one of its frames, or as it follows the path evenly.
  std::optional<Bodies> bodies_at(int motion_frame, std::optional<int> coach_frame) const;
  OverlayMoment moment_at(const Frame& frame, const std::optional<Bodies>& bodies) const;
  bool is_drawing_shown(const Drawing& drawing, const Frame& frame);

  Comparison comparison_;
  PinholeCamera camera_;
  SceneRenderer& renderer_;
  OverlayStory story_;
  CoachPlacement placement_;
  std::vector<std::optional<double>> apart_m_;  // a frame of the film
  std::map<int, double> drawn_at_s_;            // when the frames came that something is drawn on
};

using NextFrame = std::function<Result<std::optional<Frame>>()>;
using FrameSink = std::function<Result<void>(const Image& image, const Frame& frame)>;

// Reads the film to its end and gives every drawn frame to `sink`, which may be empty: then only the stills
// are drawn and the film is read no further than they need. Returns the analysis' stills in the order of
// time. Errors: those of `next` and `sink`; Cancelled.
Result<std::vector<ReportPicture>> draw_overlay_film(const Comparison& comparison,
                                                     const PinholeCamera& camera, SceneRenderer& renderer,
                                                     const NextFrame& next, const FrameSink& sink,
                                                     const Progress& progress = {});

}  // namespace posecoach
