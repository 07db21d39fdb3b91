// From where the student was seen, which decides what can be known about him.
#pragma once

#include "core/base/math.h"

namespace posecoach {

enum class Viewpoint {
  AllSides,     // motion capture: every direction is known
  FaceOn,       // one camera in front of him: what happens towards the ball is not seen
  DownTheLine,  // one camera on the target line: what happens towards the target is not seen
  Between       // one camera at an angle: a bit of both
};

// The two that are compared. What a camera shows of a golfer, and what it gets wrong, depends on its side.
struct Viewpoints {
  Viewpoint student = Viewpoint::AllSides;
  Viewpoint coach = Viewpoint::AllSides;
};

// Whether distances along target (x), up (y) and ball (z) can be read at all.
inline bool sees_target_direction(Viewpoint view) {
  return view != Viewpoint::DownTheLine;
}
inline bool sees_ball_direction(Viewpoint view) {
  return view != Viewpoint::FaceOn;
}
inline bool is_one_camera(Viewpoint view) {
  return view != Viewpoint::AllSides;
}
// Whether both were filmed from one side: what a camera gets wrong is the same in both.
inline bool is_filmed_alike(const Viewpoints& views) {
  return views.student == views.coach &&
         (views.coach == Viewpoint::FaceOn || views.coach == Viewpoint::DownTheLine);
}
inline bool is_one_camera(const Viewpoints& views) {
  return is_one_camera(views.student) || is_one_camera(views.coach);
}

}  // namespace posecoach
