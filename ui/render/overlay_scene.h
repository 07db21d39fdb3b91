// The film with what the program has to say drawn over it: the student's skeleton, the coach in the student's
// body, the score, the part of the swing, and below how far both are along the alignment. A pure function of
// plain values; sizes follow the picture, from a small portrait film to 4K.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/coaching/analysis.h"
#include "core/image/camera.h"
#include "ui/render/figure.h"
#include "ui/render/scene.h"

namespace posecoach {

// Whose skeletons lie over a film.
enum class FigureShow { Both, Student, None };

// What stays the same over the film. Fractions in [0, 1] of the student's film and of the coach's motion.
struct OverlayStory {
  Palette palette = Palette::RedGreen;
  double score_percent = 0;
  double mean_apart_m = 0;  // over the whole alignment
  std::vector<double> student_events, coach_events;
  std::vector<std::pair<double, double>> links;  // along the alignment: student, coach
};

struct OverlayMoment {
  std::shared_ptr<const Image> film;
  std::optional<BodyState> student, coach;  // in the camera's world
  double student_fraction = 0;
  std::optional<double> coach_fraction;
  std::string phase;  // "Backswing"; may be empty
  double time_s = 0;
  std::optional<double> apart_m;  // mean joint error of this moment, if the alignment has it
};

// A joint that the picture is about: both bodies' joints ringed and joined by a line.
struct OverlayHighlight {
  Vec3 student, coach;  // world
};

OverlayStory make_overlay_story(const Analysis& analysis, Palette palette);

// `camera` may be made for another size of the same film.
Scene make_overlay_scene(const OverlayStory& story, const OverlayMoment& moment, const PinholeCamera& camera);

// Only the bodies, for still pictures.
Scene make_bodies_scene(const OverlayMoment& moment, Palette palette, const PinholeCamera& camera,
                        const std::optional<OverlayHighlight>& highlight = {});

// The same view in another size.
PinholeCamera scaled_to(const PinholeCamera& camera, int width_px, int height_px);
// What it sees of this part of its picture, in a picture of this size.
PinholeCamera cropped_to(const PinholeCamera& camera, const PicturePart& part, int width_px, int height_px);

}  // namespace posecoach
