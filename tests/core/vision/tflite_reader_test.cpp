#include "core/vision/tflite_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/vision/tflite_weights.h"
#include "tests/core/vision/naive_network.h"
#include "tests/core/vision/tflite_builder.h"

namespace posecoach {
namespace {

using testing::HasSubstr;

// Weights that half precision holds exactly, half of them zero.
NetworkGraph make_packable_graph(std::mt19937& random) {
  NetworkGraph graph = make_random_graph(random);
  for (Tensor& tensor : graph.tensors)
    for (float& value : tensor.values) value = random() % 2 == 0 ? 0.0F : std::round(value * 64) / 64;
  return graph;
}

class TfliteStorage : public testing::TestWithParam<WeightStorage> {};

TEST_P(TfliteStorage, a_written_network_is_read_back_and_computes_the_same) {
  std::mt19937 random(20);
  for (int round = 0; round < 20; ++round) {
    SCOPED_TRACE(round);
    const NetworkGraph graph = make_packable_graph(random);
    const auto read = read_tflite(tflite_bytes(graph, GetParam()), "small.tflite");
    ASSERT_TRUE(read) << read.error().message;
    std::vector<float> input(graph.at(graph.inputs[0]).element_count());
    for (float& value : input) value = static_cast<float>(random() % 100) / 50 - 1;
    const auto ours = run_naively(*read, input);
    const auto theirs = run_naively(graph, input);
    ASSERT_EQ(ours.size(), theirs.size());
    for (std::size_t i = 0; i < ours.size(); ++i) EXPECT_EQ(ours[i], theirs[i]);
    for (const int output : read->outputs) EXPECT_THAT(read->at(output).name, testing::StartsWith("out"));
  }
}

INSTANTIATE_TEST_SUITE_P(All, TfliteStorage,
                         testing::Values(WeightStorage::Float32, WeightStorage::Float16,
                                         WeightStorage::SparseFloat16));

TEST(TfliteReader, every_cut_off_file_ends_in_one_line_that_names_it) {
  std::mt19937 random(21);
  const std::string bytes = tflite_bytes(make_packable_graph(random), WeightStorage::SparseFloat16);
  std::size_t last_needed = 0;
  for (std::size_t size = 0; size < bytes.size(); size += 1 + size / 64) {
    const auto read = read_tflite(bytes.substr(0, size), "cut.tflite");
    if (read) continue;
    last_needed = size;
    EXPECT_THAT(read.error().message, HasSubstr("cut.tflite"));
    EXPECT_EQ(read.error().message.find('\n'), std::string::npos);
  }
  EXPECT_GT(last_needed, bytes.size() / 2);
}

TEST(TfliteReader, damaged_files_are_refused_or_read_but_never_followed_outside) {
  std::mt19937 random(22);
  const std::string good = tflite_bytes(make_packable_graph(random), WeightStorage::SparseFloat16);
  std::size_t refused = 0;
  constexpr std::size_t kRounds = 3000;
  for (std::size_t round = 0; round < kRounds; ++round) {
    std::string bytes = good;
    for (std::size_t k = 0; k <= random() % 4; ++k)
      bytes[random() % bytes.size()] = static_cast<char>(random() & 255U);
    if (!read_tflite(bytes, "damaged.tflite")) ++refused;
  }
  EXPECT_GT(refused, kRounds / 4);
}

TEST(TfliteReader, another_kind_of_file_is_named_as_such) {
  const auto read = read_tflite("HIERARCHY ROOT hips", "swing.tflite");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::Malformed);
  EXPECT_THAT(read.error().message, HasSubstr("swing.tflite is not a TensorFlow Lite network"));
}

// One convolution over a 1 x 6 x 5 x 2 picture.
NetworkGraph make_convolution_graph() {
  NetworkGraph graph;
  graph.tensors = {{"in", {1, 6, 5, 2}, {}},
                   {"filter", {1, 3, 3, 2}, std::vector<float>(18, 0.5F)},
                   {"out", {1, 3, 3, 1}, {}}};
  graph.inputs = {0};
  graph.outputs = {2};
  graph.layers = {{.kind = LayerKind::Convolution,
                   .inputs = {0},
                   .output = 2,
                   .filter = 1,
                   .stride_x = 2,
                   .stride_y = 2}};
  return graph;
}

FlatNode& options_of_first_operator(FlatNode& model) {
  return model.children[2].elements[0].children[3].elements[0].children[4];
}

TEST(TfliteReader, same_padding_puts_the_odd_pixel_behind) {
  FlatNode model = tflite_model(make_convolution_graph(), WeightStorage::Float32);
  options_of_first_operator(model).numbers[0] = raw_bytes(std::int8_t{0});
  const auto read = read_tflite(flatbuffer_bytes(model, "TFL3"), "same.tflite");
  ASSERT_TRUE(read) << read.error().message;
  // 5 columns, stride 2, window 3: one pixel on either side; 6 rows: one behind.
  EXPECT_EQ(read->layers[0].padding, (Padding{1, 1, 0, 1, 0}));
}

TEST(TfliteReader, what_cannot_be_computed_is_unsupported) {
  struct Case {
    const char* what;
    int slot;
    std::string bytes;
  };
  const std::string same = raw_bytes(std::int8_t{0});
  for (const Case& wrong :
       {Case{"tanh activation", 3, raw_bytes(std::int8_t{4})},
        Case{"dilation", 4, raw_bytes(std::int32_t{2})}, Case{"no stride", 1, raw_bytes(std::int32_t{0})},
        Case{"huge stride", 2, raw_bytes(std::int32_t{1 << 30})}}) {
    FlatNode model = tflite_model(make_convolution_graph(), WeightStorage::Float32);
    options_of_first_operator(model).numbers[0] = same;
    options_of_first_operator(model).numbers[wrong.slot] = wrong.bytes;
    const auto read = read_tflite(flatbuffer_bytes(model, "TFL3"), "odd.tflite");
    ASSERT_FALSE(read) << wrong.what;
    EXPECT_EQ(read.error().code, ErrorCode::Unsupported) << wrong.what;
  }
}

TEST(TfliteReader, weights_that_are_no_numbers_are_refused) {
  NetworkGraph graph = make_convolution_graph();
  graph.tensors[1].values[3] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(read_tflite(tflite_bytes(graph, WeightStorage::Float32), "x").error().code, ErrorCode::Malformed);
}

TEST(TfliteWeights, half_floats_keep_their_value) {
  EXPECT_EQ(float_from_half(0x3C00), 1.0F);
  EXPECT_EQ(float_from_half(0xC500), -5.0F);
  EXPECT_EQ(float_from_half(0x7BFF), 65504.0F);
  EXPECT_EQ(float_from_half(0x0001), std::ldexp(1.0F, -24));
  EXPECT_EQ(float_from_half(0x8400), -std::ldexp(1.0F, -14));
  EXPECT_TRUE(std::isinf(float_from_half(0x7C00)));
  EXPECT_TRUE(std::isnan(float_from_half(0x7E00)));
}

}  // namespace
}  // namespace posecoach
