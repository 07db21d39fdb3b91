// The numbers in a TensorFlow Lite tensor's buffer: half or single floats, dense or sparse.
#pragma once

#include <vector>

#include "core/base/error.h"
#include "core/vision/flatbuffer.h"

namespace posecoach {

enum class TfliteType : std::int8_t { Float32 = 0, Float16 = 1, Int32 = 2 };

float float_from_half(std::uint16_t half);

// `tensor` is a Tensor table, `data` its buffer's bytes, `element_count` the product of its shape. Sparse
// tensors come out dense. Error: Malformed or Unsupported with the reason (without the file's name).
Result<std::vector<float>> tflite_floats(const FlatTable& tensor, std::string_view data,
                                         const std::vector<int>& shape, std::size_t element_count);

}  // namespace posecoach
