// What a pose stage would see of a known golfer before a known camera, and the pieces from which the live
// loop is tested without one: frames, an estimator that knows the answers, sources that follow a script.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/image/camera.h"
#include "core/motion/motion.h"
#include "core/pipeline/frame_source.h"
#include "core/pipeline/pose_estimator.h"

namespace posecoach {

struct PoseNoise {
  double image_px = 0;
  double world_m = 0;
  double depth_m = 0;  // of the 3D joints along the line of sight
};
// Far rougher than what the pose stage's filters let through (measured on films: wrists at 0.02 to 0.2 px and
// 0.1 to 1 mm from frame to frame), and about that.
inline constexpr PoseNoise kWebcamNoise{1.5, 0.006, 0.02};
inline constexpr PoseNoise kFilteredNoise{0.1, 0.0005, 0.0015};

// A golfer on the webcam body, in the world.
struct GolferPart {
  enum class Kind {
    Stand,     // the pose of the stroke's start, without moving
    Stroke,    // the bundled stroke, once
    Finish,    // the pose of the stroke's end, without moving
    Rehearse,  // the stroke's first seconds, there and back
    Waggle,    // hands a little to and fro, and back
    Walk,      // about the place, arms swinging
    TPose,
    Away  // nobody there
  };
  Kind kind = Kind::Stand;
  double seconds = 1;  // of a stroke: not counted
};

struct GolferScript {
  std::string stroke = "swing";  // of the bundled ones
  bool is_left_handed = false;
  double fps = 30;
  std::vector<GolferPart> parts;
  double size = 1;    // of the body
  double slower = 1;  // the stroke takes so many times its time
  double length = 1;  // the stroke has so much of its way
};

struct GolferFilm {
  std::vector<MediaTime> times;
  std::vector<std::optional<SeenPerson>> people;
  // Of the webcam body, world; where nobody is there, anything.
  std::vector<std::vector<Vec3>> truth;
  std::vector<double> stroke_begin_s, stroke_end_s;  // first and last moment of each stroke's own motion
  PinholeCamera camera;
  std::shared_ptr<const Image> picture;  // of the camera's size, grey

  std::size_t count() const { return times.size(); }
  Frame frame(std::size_t index) const { return {index, times[index], {}, picture}; }
};

// Cameras as the simulated student's: at hand height, 1280 x 720.
PinholeCamera face_on_camera();
PinholeCamera down_the_line_camera(bool is_left_handed);

GolferFilm film_golfer(const GolferScript& script, const PinholeCamera& camera, const PoseNoise& noise = {},
                       unsigned seed = 11);

// Answers by the frame's number.
class KnowingEstimator : public PoseEstimator {
 public:
  explicit KnowingEstimator(std::shared_ptr<const GolferFilm> film) : film_(std::move(film)) {}
  Result<PoseObservation> estimate(const Frame& frame) override;
  void reset() override {}

 private:
  std::shared_ptr<const GolferFilm> film_;
};

}  // namespace posecoach
