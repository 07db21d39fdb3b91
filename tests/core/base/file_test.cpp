#include "core/base/file.h"

#include <gtest/gtest.h>

namespace posecoach {
namespace {

std::filesystem::path scratch(const char* name) {
  return std::filesystem::path(testing::TempDir()) / name;
}

TEST(File, what_was_written_is_read_back) {
  const auto path = scratch("posecoach_file_test.bin");
  const std::string bytes("\0one\ntwo\xff", 9);
  ASSERT_TRUE(write_file_atomically(path, bytes));
  EXPECT_EQ(read_file(path).value(), bytes);
}

TEST(File, a_missing_file_is_not_found_and_named) {
  const auto read = read_file("/nonexistent/swing.bvh");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::NotFound);
  EXPECT_NE(read.error().message.find("/nonexistent/swing.bvh"), std::string::npos);
}

TEST(File, a_folder_is_not_a_file) {
  EXPECT_EQ(read_file("/tmp").error().code, ErrorCode::Unreadable);
}

TEST(File, a_file_over_the_limit_is_refused) {
  const auto path = scratch("posecoach_file_test_large.bin");
  ASSERT_TRUE(write_file_atomically(path, std::string(100, 'x')));
  EXPECT_EQ(read_file(path, 99).error().code, ErrorCode::Unsupported);
  EXPECT_TRUE(read_file(path, 100));
}

TEST(File, a_failed_write_leaves_the_old_file_and_nothing_beside_it) {
  const auto folder = scratch("posecoach_no_such_folder");
  EXPECT_FALSE(write_file_atomically(folder / "a.json", "x"));
  EXPECT_FALSE(std::filesystem::exists(folder));
  const auto full = write_file_atomically("/dev/full/never", "x");
  EXPECT_FALSE(full);
}

}  // namespace
}  // namespace posecoach
