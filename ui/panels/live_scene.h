// The live picture as a scene: the camera's frame, the student's skeleton, the coach's ghost, and how close
// each joint is. Pure functions of the snapshot.
#pragma once

#include "core/pipeline/coach_snapshot.h"
#include "ui/render/overlay_scene.h"
#include "ui/widgets/scene_views.h"

namespace posecoach {

struct LiveSceneStyle {
  Palette palette = Palette::RedGreen;
  Colour close, near, far;  // of the joints' marks
  FigureShow figures = FigureShow::Both;
};

// This part of the frame in a picture of this size, whose shape should be the part's.
SceneView make_live_scene(const CoachSnapshot& snapshot, const LiveSceneStyle& style, int width_px,
                          int height_px, const PicturePart& part = {});

}  // namespace posecoach
