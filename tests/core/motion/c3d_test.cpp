#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <limits>

#include "c3d_sample.h"
#include "core/motion/c3d_reader.h"

namespace posecoach {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const Vec3 kHidden(std::numeric_limits<double>::quiet_NaN());

samples::C3dSample two_markers() {
  return {.labels = {"LASI", "sub:RASI"}, .positions = {{1, 2.5, -3}, {100, 0, 50}, {1.5, 2, -3.5}, kHidden}};
}

class C3dKind : public testing::TestWithParam<std::tuple<int, bool>> {};

TEST_P(C3dKind, of_numbers_reads_the_same_points) {
  samples::C3dSample sample = two_markers();
  std::tie(sample.processor, sample.as_integers) = GetParam();
  sample.analog_samples = 3;
  const auto track = read_c3d("a.c3d", samples::c3d_bytes(sample));
  ASSERT_TRUE(track) << track.error().message;
  EXPECT_EQ(track->labels, (std::vector<std::string>{"LASI", "sub:RASI"}));
  EXPECT_EQ(track->metres_per_unit, 0.001);
  EXPECT_EQ(track->seen, (std::vector<char>{1, 1, 1, 0}));
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_LT(glm::distance(track->positions[i], sample.positions[i]), 1e-6);
  EXPECT_NEAR(to_seconds(track->times[1]), 0.01, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(IntelDecMipsRealInteger, C3dKind,
                         testing::Combine(testing::Values(84, 85, 86), testing::Bool()));

void expect_bad(const std::string& bytes, const std::string& start, const std::string& what,
                ErrorCode code = ErrorCode::Malformed) {
  const auto read = read_c3d("a.c3d", bytes);
  ASSERT_FALSE(read) << what;
  EXPECT_EQ(read.error().code, code);
  EXPECT_THAT(read.error().message, StartsWith("a.c3d: byte " + start + ": "));
  EXPECT_THAT(read.error().message, HasSubstr(what));
}

std::string with_byte(std::size_t at, int value) {
  std::string bytes = samples::c3d_bytes(two_markers());
  bytes[at] = static_cast<char>(value);
  return bytes;
}

TEST(C3d, every_mistake_is_one_line_that_names_file_and_byte) {
  const std::string whole = samples::c3d_bytes(two_markers());
  expect_bad("", "0", "not a C3D file");
  expect_bad(std::string(600, 'x'), "0", "not a C3D file");
  expect_bad(with_byte(0, 100), "0", "beyond the end of the file");
  expect_bad(with_byte(512 + 3, 7), "515", "processor type 7 is not known");
  expect_bad(with_byte(2, 0), "2", "no points", ErrorCode::Incomplete);
  expect_bad(with_byte(8, 0), "6", "no frames", ErrorCode::Incomplete);
  expect_bad(with_byte(16, 99), "16", "data lie beyond");
  expect_bad(whole.substr(0, whole.size() - 40), std::to_string(whole.size() - 40),
             "ends too early, in frame 1 of 2");
  expect_bad(with_byte(8, 9), std::to_string(whole.size()), "ends too early, in frame 3 of 9");
  samples::C3dSample still = two_markers();
  still.rate = 0;
  expect_bad(samples::c3d_bytes(still), "20", "frame rate is not between");
  still.rate = 100;
  still.scale = 0;
  expect_bad(samples::c3d_bytes(still), "12", "scale of the points");
}

TEST(C3d, a_parameter_that_runs_over_the_end_is_named) {
  std::string bytes = samples::c3d_bytes(two_markers());
  const std::size_t name = bytes.find("LABELS");
  bytes[name + 6 + 2 + 2] = '\xFF';  // first dimension
  bytes[name + 6 + 2 + 3] = '\xFF';
  expect_bad(bytes, std::to_string(name + 6 + 2), "\"labels\" runs over the end");
}

}  // namespace
}  // namespace posecoach
