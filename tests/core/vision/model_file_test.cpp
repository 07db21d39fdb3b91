#include "core/vision/model_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "core/base/file.h"
#include "tests/core/vision/naive_network.h"
#include "tests/core/vision/tflite_builder.h"

namespace posecoach {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

fs::path make_folder(const char* name) {
  const fs::path folder = fs::path(testing::TempDir()) / name;
  fs::create_directories(folder);
  return folder;
}

TEST(ModelFile, a_missing_model_says_how_to_install_it) {
  const auto found = find_model_file("pose_landmark_full.tflite", "/nonexistent");
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::NotFound);
  EXPECT_THAT(found.error().message, HasSubstr("scripts/setup"));
  EXPECT_THAT(found.error().message, HasSubstr("/nonexistent"));
}

TEST(ModelFile, the_given_folder_counts_alone_and_so_does_the_variable_otherwise) {
  const fs::path given = make_folder("posecoach_models_given");
  const fs::path chosen = make_folder("posecoach_models_chosen");
  ASSERT_TRUE(write_file_atomically(chosen / "test_only.tflite", "x"));
  ::setenv("POSECOACH_MODELS", chosen.c_str(), 1);
  EXPECT_EQ(find_model_file("test_only.tflite", std::nullopt).value(), chosen / "test_only.tflite");
  EXPECT_FALSE(find_model_file("test_only.tflite", given));
  ::setenv("POSECOACH_MODELS", "/nonexistent", 1);
  const auto missing = find_model_file(kDetectorFileName, std::nullopt);
  ASSERT_FALSE(missing) << "a wrong folder falls back silently to " << *missing;
  EXPECT_THAT(missing.error().message, HasSubstr("/nonexistent"));
  ::unsetenv("POSECOACH_MODELS");
}

TEST(ModelFile, a_damaged_or_foreign_network_is_named) {
  const fs::path folder = make_folder("posecoach_models_bad");
  std::mt19937 random(30);
  const NetworkGraph graph = make_random_graph(random);
  ASSERT_TRUE(write_file_atomically(folder / "foreign.tflite", tflite_bytes(graph, WeightStorage::Float32)));
  ASSERT_TRUE(write_file_atomically(folder / "text.tflite", "not a network"));
  const auto foreign = load_network(folder / "foreign.tflite", {1, 224, 224, 3}, {{"out0", {1, 1}}});
  ASSERT_FALSE(foreign);
  EXPECT_EQ(foreign.error().code, ErrorCode::Unsupported);
  EXPECT_THAT(foreign.error().message, HasSubstr("foreign.tflite"));
  const auto text = load_network(folder / "text.tflite", {1, 224, 224, 3}, {});
  ASSERT_FALSE(text);
  EXPECT_EQ(text.error().code, ErrorCode::Malformed);
}

TEST(ModelFile, a_network_that_keeps_its_claims_is_built) {
  const fs::path folder = make_folder("posecoach_models_good");
  std::mt19937 random(31);
  const NetworkGraph graph = make_random_graph(random);
  ASSERT_TRUE(write_file_atomically(folder / "good.tflite", tflite_bytes(graph, WeightStorage::Float32)));
  EXPECT_TRUE(load_network(folder / "good.tflite", graph.at(graph.inputs[0]).shape,
                           {{"out1", graph.at(graph.outputs[1]).shape}}));
}

}  // namespace
}  // namespace posecoach
