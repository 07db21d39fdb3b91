// A swing with a fault and all that can be said about it, written down by hand on the authored motions: what
// shows swings is tested with it, whatever the pose stage and the coaching come to say.
#pragma once

#include <memory>
#include <string>

#include "core/pipeline/analyzed_swing.h"

namespace posecoach {

// `faults` as "sway=14,bent_lead_arm=60"; empty for none. The coach in the student's body has none.
std::shared_ptr<const AnalyzedSwing> make_plain_swing(const std::string& faults, double height_m);

}  // namespace posecoach
