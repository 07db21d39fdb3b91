// A golfer who does not exist, filmed by a camera that does not exist: the film of an authored motion in any
// body, with everything about it known. The demo without a camera, the truth of end-to-end tests, and, by the
// number in every picture's corner, the proof that a recording lost nothing.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "capture/golfer_figure.h"
#include "core/body/standard_body.h"
#include "core/motion/authored/authored_motion.h"
#include "core/motion/authored/golf_fault.h"
#include "core/pipeline/frame_source.h"

namespace posecoach {

enum class CameraView { FaceOn, DownTheLine };
std::string_view to_string(CameraView view);

// A view, and how far the camera has gone round the golfer from there: from face-on towards the target, from
// down the line towards the ball.
struct CameraPlace {
  CameraView view = CameraView::FaceOn;
  double turned_deg = 0;
};
std::string to_string(const CameraPlace& place);  // "face-on", "down-the-line+20", "face-on-12.5"
// As to_string writes it. Errors: InvalidArgument.
Result<CameraPlace> camera_place_from_string(std::string_view name);

struct SimulatedStudentOptions {
  std::string name = "simulated:swing";  // as the user wrote it
  std::string motion = "swing";          // of the bundled ones
  std::vector<FaultChoice> faults;
  double length = 1;    // of the stroke: 0.5 goes half as far back and through
  double stands_s = 0;  // longer at address than the bundled motion
  std::string body_name = "average";
  Skeleton body = make_standard_body({.height_m = 1.80});
  Handedness hand = Handedness::Right;
  CameraPlace view;
  double frames_per_second = 60;
  int width = 1280;
  int height = 720;
};

class SimulatedStudent : public FrameSource {
 public:
  // Errors: NotFound (motion), Incomplete (body), InvalidArgument (picture size outside 64 to 8192, frame
  // rate, a fault of the other motion).
  static Result<std::unique_ptr<SimulatedStudent>> make(const SimulatedStudentOptions& options);

  const FrameSourceInfo& info() const override { return info_; }
  Result<std::optional<Frame>> next(std::stop_token stop) override;

  // The truth.
  const AuthoredMotion& authored() const { return authored_; }
  const PinholeCamera& camera() const { return camera_; }
  LandmarkArray<Vec3> landmarks(int frame) const;
  // Any frame's picture, without moving on.
  Image draw(int frame) const;

 private:
  SimulatedStudent(const SimulatedStudentOptions& options, AuthoredMotion authored, bool is_putter);
  GolferFigure::Posed posed(int frame, std::vector<Quat>& rotations) const;
  std::optional<Vec3> ball_at(double time_s) const;

  FrameSourceInfo info_;
  AuthoredMotion authored_;
  PinholeCamera camera_;
  GolferFigure figure_;
  Image background_;
  bool is_putter_ = false;
  double target_ = 1;  // the sign of the target's direction along X
  int next_ = 0;
};

// Where the camera of a view stands: at hand height, square to the target line (face-on) or on it (down the
// line).
PinholeCamera make_view_camera(const CameraPlace& place, Handedness hand, int width_px, int height_px);

}  // namespace posecoach
