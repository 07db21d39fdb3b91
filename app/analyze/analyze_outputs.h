// What `analyze` writes: the JSON contract, the report page and the film with both skeletons drawn over it.
#pragma once

#include <string>
#include <vector>

#include "app/load_motion.h"
#include "core/base/progress.h"
#include "core/coaching/block.h"
#include "core/pipeline/analyze.h"
#include "core/session/marks.h"
#include "ui/render/figure.h"

namespace posecoach {

struct AnalyzeOutputs {
  std::string json, report, video;  // file names; empty for none; json or report may be "-"
  Palette palette = Palette::RedGreen;
  Block block = {};                    // of the page: the golfer's last swings, this one among them
  std::vector<Drawing> drawings = {};  // on the film
};

// As check_output_files (app/output_check.h); a film goes to a file only.
Result<void> check_outputs(const AnalyzeOutputs& outputs, const std::vector<std::string>& inputs);

// Each file is written whole or not at all; the film and the report come before the JSON.
Result<void> write_outputs(const AnalyzeOutputs& outputs, const LoadedMotion& student,
                           const AnalyzedPair& pair, const Progress& progress);

}  // namespace posecoach
