// Reads a TensorFlow Lite file (schema version 3) into a NetworkGraph. Understood is what the pose networks
// use: one subgraph of float activations; weights as 16- or 32-bit floats, dense or sparse (they become dense
// 32-bit constants, so DEQUANTIZE and DENSIFY vanish). Files are untrusted: every offset, size and shape is
// checked.
#pragma once

#include <string>
#include <string_view>

#include "core/vision/network_graph.h"

namespace posecoach {

// `name` is for error messages. Errors: Malformed (damaged; names the byte or the layer), Unsupported (a
// healthy network that needs what we cannot compute).
Result<NetworkGraph> read_tflite(std::string_view bytes, const std::string& name);

}  // namespace posecoach
