#include "core/vision/tflite_weights.h"

#include <bit>
#include <cmath>

namespace posecoach {
namespace {

// Slots of the schema's tables.
constexpr int kTensorType = 1;
constexpr int kTensorSparsity = 6;
constexpr int kSparsityOrder = 0;
constexpr int kSparsityBlockMap = 1;
constexpr int kSparsityDimensions = 2;
constexpr int kDimensionFormat = 0;
constexpr int kDimensionDenseSize = 1;
constexpr int kDimensionSegmentsType = 2;
constexpr int kDimensionSegments = 3;
constexpr int kDimensionIndicesType = 4;
constexpr int kDimensionIndices = 5;

Result<std::vector<float>> stored_floats(TfliteType type, std::string_view data) {
  std::vector<float> values;
  if (type == TfliteType::Float32) {
    values.resize(data.size() / sizeof(float));
    if (!values.empty()) std::memcpy(values.data(), data.data(), values.size() * sizeof(float));
    return values;
  }
  if (type != TfliteType::Float16)
    return fail(ErrorCode::Unsupported, "weights of type " + std::to_string(static_cast<int>(type)) +
                                            "; only 16- and 32-bit floats are understood");
  values.reserve(data.size() / 2);
  for (std::size_t i = 0; i + 1 < data.size(); i += 2) {
    std::uint16_t half = 0;
    std::memcpy(&half, data.data() + i, sizeof half);
    values.push_back(float_from_half(half));
  }
  return values;
}

// A union of vectors of three widths; empty for an unknown width.
std::vector<std::size_t> index_list(const FlatTable& dimension, int type_slot, int slot) {
  const auto type = dimension.number<std::uint8_t>(type_slot);
  const FlatTable list = dimension.table(slot);
  std::vector<std::size_t> out;
  const auto copy = [&]<typename T>(T) {
    const FlatVector numbers = list.numbers<T>(0);
    out.reserve(numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i)
      out.push_back(static_cast<std::size_t>(numbers.number<T>(i)));
  };
  if (type == 1) copy(std::int32_t{});
  if (type == 2) copy(std::uint16_t{});
  if (type == 3) copy(std::uint8_t{});
  return out;
}

// Only what the pose networks hold: dimensions in their order, all dense but the last, which lists the
// columns of each row's stored values.
Result<std::vector<float>> dense_from_sparse(const FlatTable& sparsity, const std::vector<float>& stored,
                                             const std::vector<int>& shape, std::size_t element_count) {
  const auto malformed = [] { return fail(ErrorCode::Malformed, "a damaged list of sparse weights"); };
  const FlatVector dimensions = sparsity.tables(kSparsityDimensions);
  const FlatVector order = sparsity.numbers<std::int32_t>(kSparsityOrder);
  bool usual = sparsity.numbers<std::int32_t>(kSparsityBlockMap).size() == 0 && !shape.empty() &&
               dimensions.size() == shape.size() && order.size() == shape.size();
  for (std::size_t i = 0; usual && i < shape.size(); ++i) {
    const FlatTable dimension = dimensions.table(i);
    const bool is_last = i + 1 == shape.size();
    usual = order.number<std::int32_t>(i) == static_cast<std::int32_t>(i) &&
            dimension.number<std::int8_t>(kDimensionFormat) == (is_last ? 1 : 0) &&
            (is_last || dimension.number<std::int32_t>(kDimensionDenseSize) == shape[i]);
  }
  if (!usual) return fail(ErrorCode::Unsupported, "sparse weights of an unknown arrangement");
  const FlatTable last = dimensions.table(shape.size() - 1);
  const auto segments = index_list(last, kDimensionSegmentsType, kDimensionSegments);
  const auto columns = index_list(last, kDimensionIndicesType, kDimensionIndices);
  const auto row_size = static_cast<std::size_t>(shape.back());
  const std::size_t rows = element_count / row_size;
  if (segments.size() != rows + 1 || columns.size() > stored.size()) return malformed();
  std::vector<float> dense(element_count, 0.0F);
  for (std::size_t row = 0; row < rows; ++row) {
    if (segments[row] > segments[row + 1] || segments[row + 1] > columns.size()) return malformed();
    for (std::size_t i = segments[row]; i < segments[row + 1]; ++i) {
      if (columns[i] >= row_size) return malformed();
      dense[row * row_size + columns[i]] = stored[i];
    }
  }
  return dense;
}

}  // namespace

float float_from_half(std::uint16_t half) {
  const std::uint32_t sign = (half & 0x8000U) << 16;
  const std::uint32_t exponent = (half >> 10) & 0x1FU;
  const std::uint32_t fraction = half & 0x3FFU;
  if (exponent == 0) {  // zero and what is too small for an exponent of its own
    const float small = std::ldexp(static_cast<float>(fraction), -24);
    return sign != 0 ? -small : small;
  }
  const std::uint32_t wide_exponent = exponent == 0x1F ? 0xFFU : exponent + 112;
  return std::bit_cast<float>(sign | (wide_exponent << 23) | (fraction << 13));
}

Result<std::vector<float>> tflite_floats(const FlatTable& tensor, std::string_view data,
                                         const std::vector<int>& shape, std::size_t element_count) {
  auto stored = stored_floats(static_cast<TfliteType>(tensor.number<std::int8_t>(kTensorType)), data);
  if (!stored) return stored;
  for (const float value : *stored)
    if (!std::isfinite(value)) return fail(ErrorCode::Malformed, "a weight that is not a finite number");
  if (element_count == 0) return fail(ErrorCode::Malformed, "has weights but no extent");
  if (const FlatTable sparsity = tensor.table(kTensorSparsity))
    return dense_from_sparse(sparsity, *stored, shape, element_count);
  if (stored->size() != element_count)
    return fail(ErrorCode::Malformed, "has " + std::to_string(stored->size()) + " weights instead of " +
                                          std::to_string(element_count));
  return stored;
}

}  // namespace posecoach
