// Two short motions of one body and an analysis of them, to draw films and reports from in tests.
#pragma once

#include "core/body/standard_body.h"
#include "core/coaching/analysis.h"
#include "core/motion/motion.h"

namespace posecoach {

// The arms go up and down again in two seconds; the student reaches `late` seconds later.
struct ComparedMotions {
  Motion student, coach;
  Analysis analysis;
};

ComparedMotions make_compared_motions(int frames = 60, double late_s = 0.2);

}  // namespace posecoach
