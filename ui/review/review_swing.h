// A swing made ready for looking at: everything that the review draws at a moment, worked out once. A pure
// function of the analysed swing; pictures are somebody else's.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/pipeline/analyzed_swing.h"
#include "ui/render/coach_placement.h"
#include "ui/render/figure.h"
#include "ui/report/replay.h"

namespace posecoach {

// A part of the student's film with one tempo against the coach's.
enum class Tempo { MuchSlower, Slower, Same, Faster, MuchFaster };
struct TempoPart {
  double begin_s = 0, end_s = 0;  // of the film
  Tempo tempo = Tempo::Same;
};

struct ReviewSwing {
  std::shared_ptr<const AnalyzedSwing> swing;  // never null
  std::vector<double> times_s;                 // of each picture of the film
  std::vector<int> events;                     // pictures
  std::vector<double> coach_times_s;           // of each frame of the coach
  CoachPlacement placement;                    // frames of the student's motion
  Replay replay;
  std::vector<TempoPart> tempo;
  std::vector<std::optional<double>> apart_m;  // mean joint error, one a picture
  // The part of the film, in its pixels, in which the golfer swings, with room for the club; nothing where he
  // was not seen.
  std::optional<std::pair<Vec2, Vec2>> golfer_px;
  double front = 0;  // angle about +Y of the student's front at address, from +Z

  const Analysis& analysis() const { return swing->pair.analysis; }
  int picture_count() const { return static_cast<int>(times_s.size()); }
};

std::shared_ptr<const ReviewSwing> make_review_swing(std::shared_ptr<const AnalyzedSwing> swing);

struct PosedBody {
  const Skeleton* skeleton = nullptr;
  std::vector<Vec3> positions;
  std::vector<double> confidence;

  BodyState state() const { return {*skeleton, positions, confidence}; }
};

// Both bodies in the world of the film's camera. Nothing where nobody was seen.
struct BodiesAtPicture {
  std::optional<PosedBody> student, coach;
  double coach_frame = 0;
};
BodiesAtPicture bodies_at(const ReviewSwing& review, int picture);

// Where the coach is along the alignment while this picture is shown: his frame, and his time.
double coach_frame_at(const ReviewSwing& review, int picture);
double coach_time_at(const ReviewSwing& review, int picture);
// The picture during which the coach is nearest to this time of his.
int picture_of_coach_time(const ReviewSwing& review, double coach_s);

// Two swings beside each other: the picture of `second` that shows the same moment of the stroke as a picture
// of `first`, between the events that both have.
int matching_picture(const ReviewSwing& first, const ReviewSwing& second, int picture);

}  // namespace posecoach
