#include "core/base/atomic_file.h"

#include <gtest/gtest.h>

#include "core/base/file.h"

namespace posecoach {
namespace {

TEST(AtomicFile, appears_whole_and_only_after_commit) {
  const auto path = std::filesystem::path(testing::TempDir()) / "posecoach_atomic_file_test.bin";
  std::filesystem::remove(path);
  const std::string block(100'000, 'x');
  {
    AtomicFile file = AtomicFile::create(path).value();
    for (int i = 0; i < 7; ++i) ASSERT_TRUE(file.write(block));
    EXPECT_FALSE(std::filesystem::exists(path));
    ASSERT_TRUE(file.commit());
  }
  EXPECT_EQ(read_file(path)->size(), 700'000u);
}

TEST(AtomicFile, leaves_nothing_when_it_is_given_up) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "posecoach_atomic_file_folder";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  {
    AtomicFile file = AtomicFile::create(folder / "a").value();
    ASSERT_TRUE(file.write("half"));
    AtomicFile moved = std::move(file);
    ASSERT_TRUE(moved.write(" of it"));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST(AtomicFile, a_device_is_written_not_replaced) {
  auto file = AtomicFile::create("/dev/null").value();
  ASSERT_TRUE(file.write("x"));
  ASSERT_TRUE(file.commit());
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(AtomicFile, a_symbolic_link_stays_one_and_its_target_gets_the_bytes) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "posecoach_atomic_file_links";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  ASSERT_TRUE(write_file_atomically(folder / "target", "old"));
  std::filesystem::create_symlink("target", folder / "link");
  ASSERT_TRUE(write_file_atomically(folder / "link", "new"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
  EXPECT_EQ(read_file(folder / "target").value(), "new");
}

}  // namespace
}  // namespace posecoach
