#include "core/vision/buffer_plan.h"
#include "core/vision/tflite_reader.h"
#include "fuzz_target.h"

using namespace posecoach;

// Whatever is accepted must survive everything that is done with it before it runs.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto graph = read_tflite(text_of(data, size), "a.tflite");
  if (!graph) {
    check_error(graph.error(), "a.tflite");
    return 0;
  }
  POSECOACH_ASSERT(check_graph(*graph));
  const auto simple = simplified_graph(*graph, {graph->at(graph->outputs[0]).name});
  POSECOACH_ASSERT(simple.has_value());
  POSECOACH_ASSERT(check_graph(*simple));
  const BufferPlan plan = plan_buffers(*simple);
  for (const Layer& layer : simple->layers) {
    const std::size_t buffer = plan.buffer_of_tensor[static_cast<std::size_t>(layer.output)];
    POSECOACH_ASSERT(plan.buffer_elements[buffer] >= simple->at(layer.output).element_count());
  }
  return 0;
}
