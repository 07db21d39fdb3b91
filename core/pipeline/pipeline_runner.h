// The live loop on its threads:
//
//   capture thread:  source -> tap (recorder) -> newest frame wins
//   pose thread:     requests, then CoachPipeline::step -> newest snapshot
//   work thread:     retargeting, compressing, analysing
//
// A source that fails is opened again and again, more and more slowly; the rest goes on meanwhile. The
// destructor ends everything; a source must return from next() soon after its stop token asks.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/base/error.h"
#include "core/pipeline/coach_pipeline.h"
#include "core/pipeline/frame_pump.h"

namespace posecoach {

struct PipelineRunnerOptions {
  CoachPipelineOptions pipeline = {};
  FramePumpOptions pump = {};
};

class PipelineRunner {
 public:
  PipelineRunner(std::unique_ptr<PoseEstimator> estimator, SourceOpener open,
                 PipelineRunnerOptions options = {});
  ~PipelineRunner();

  // At any time, from any thread; the old source is closed before the new one is opened. Frames without
  // stamps of capture (films, the simulated student) come at the pace of their times.
  void set_source(SourceChoice choice);
  // Runs between two steps, on the pose thread; in the order in which they were asked for.
  void request(std::function<void(CoachPipeline&)> action);
  // Sees every frame that the source gives, on the capture thread, before anybody else; must be quick. An
  // empty function ends it; after the return the old one is not called any more.
  void set_tap(std::function<void(const Frame&)> tap);

  // Never null; the same object until there is a newer one. Any thread.
  std::shared_ptr<const CoachSnapshot> snapshot() const;
  // The newest picture of all, which may be younger than the snapshot's when the pose stage is slow.
  std::optional<Frame> newest_frame() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace posecoach
