// A network ready to run on the CPU (oneDNN), on the calling thread alone: a second OpenMP thread stalls as
// soon as camera or window want its core.
#pragma once

#include <memory>
#include <span>

#include "core/vision/network_graph.h"

namespace posecoach {

class Network {
 public:
  // The graph must have one input; its outputs are what can be read. Its weights are freed one by one as they
  // are taken over. Errors: those of check_graph, Internal when the library cannot build it.
  static Result<Network> make(NetworkGraph graph);

  Network(Network&&) noexcept;
  Network& operator=(Network&&) noexcept;
  ~Network();

  // Fill, then run, then read. The spans stay valid and the outputs unchanged until the next run.
  std::span<float> input();
  Result<void> run();
  std::span<const float> output(std::size_t i) const;

 private:
  class Implementation;
  explicit Network(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace posecoach
