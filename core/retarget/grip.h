// The club is the same for coach and student: where the coach's hands hold it, the student's wrists stand to
// each other as the coach's do, in metres.
#pragma once

#include <span>
#include <vector>

#include "core/motion/motion.h"
#include "core/retarget/posed_motion.h"
#include "core/retarget/retarget.h"

namespace posecoach {

// How far each frame's hands hold something together, 0 to 1: 1 while the wrists are within 20 cm (35 cm in
// doubt), 0 beyond 30 cm (50 cm) and where they only meet for less than half a second (a clap), with smooth
// flanks.
std::vector<double> grip_weights(const Motion& coach, std::span<const double> doubt = {});

// Left wrist from right wrist, metres.
Vec3 wrist_relation(const Skeleton& skeleton, std::span<const Vec3> positions);

// Both arms give way alike and as little as possible; the collar bones help only where the arms are too
// short. Fills the report's grip fields.
void close_grip(const Motion& coach, std::span<const double> doubt, PosedMotion& student,
                ContactReport& report);

}  // namespace posecoach
