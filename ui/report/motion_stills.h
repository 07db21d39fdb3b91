// Still pictures of an analysis where there is no film: both bodies on a floor, seen from the student's
// front.
#pragma once

#include <vector>

#include "ui/render/scene_renderer.h"
#include "ui/report/comparison.h"
#include "ui/report/report_picture.h"

namespace posecoach {

// In the order of time. A context must be current.
std::vector<ReportPicture> draw_motion_stills(const Comparison& comparison, SceneRenderer& renderer);

}  // namespace posecoach
