// Makes small TensorFlow Lite files for tests of their reader.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/vision/network_graph.h"

namespace posecoach {

// One table, vector or text of a FlatBuffers file.
struct FlatNode {
  std::map<int, std::string> numbers;  // table: slot to raw bytes
  std::map<int, FlatNode> children;    // table: slot to what its offset leads to
  std::vector<FlatNode> elements;      // vector of tables
  std::string raw;                     // vector of numbers, text
  std::uint32_t raw_count = 0;
  enum class Kind { Table, Tables, Raw } kind = Kind::Table;
};

template <typename T>
std::string raw_bytes(T value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}
template <typename T>
FlatNode flat_numbers(const std::vector<T>& values) {
  FlatNode node;
  node.kind = FlatNode::Kind::Raw;
  node.raw_count = static_cast<std::uint32_t>(values.size());
  for (const T value : values) node.raw += raw_bytes(value);
  return node;
}
FlatNode flat_text(const std::string& text);
FlatNode flat_tables(std::vector<FlatNode> elements);
std::string flatbuffer_bytes(const FlatNode& root, const std::string& identifier);

enum class WeightStorage { Float32, Float16, SparseFloat16 };

// The graph as a file: paddings of convolutions become PAD operations, packed weights are unpacked by
// DEQUANTIZE and DENSIFY.
FlatNode tflite_model(const NetworkGraph& graph, WeightStorage storage);
std::string tflite_bytes(const NetworkGraph& graph, WeightStorage storage);

}  // namespace posecoach
