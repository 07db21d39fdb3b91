#include "core/image/curves.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>

#include "core/base/file.h"
#include "tests/support/temporary_folder.h"

namespace posecoach {
namespace {

TEST(Curves, are_read_from_csv_without_the_lines_that_are_no_numbers) {
  const CurveTable table = curves_from_csv("step,loss\n1,0.5\n2\nx,1\n3,1e-3,4\n4,0.25");
  EXPECT_EQ(table.columns, (std::vector<std::string>{"step", "loss"}));
  EXPECT_EQ(table.rows, (std::vector<std::vector<double>>{{1, 0.5}, {4, 0.25}}));
  EXPECT_TRUE(curves_from_csv("").columns.empty());
}

TEST(Curves, that_differ_give_pictures_that_differ) {
  const TemporaryFolder folder;
  const auto drawn = [&](const char* name, double end) {
    const auto path = folder.path() / name;
    EXPECT_TRUE(write_curves(
        path, {{"step", "loss", "error"},
               {{1, 3, 1}, {2, 2, std::numeric_limits<double>::quiet_NaN()}, {3, 2, 1}, {4, end, 1}}}));
    return *read_file(path);
  };
  EXPECT_EQ(drawn("a.png", 1), drawn("b.png", 1));
  EXPECT_NE(drawn("c.png", 1), drawn("d.png", 1.5));
  EXPECT_TRUE(drawn("e.png", 1).starts_with("\x89PNG"));
}

TEST(Curves, of_nothing_are_not_drawn_and_a_folder_that_is_missing_is_told) {
  const TemporaryFolder folder;
  EXPECT_TRUE(write_curves(folder.path() / "a.png", {{"step", "loss"}, {}}));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "a.png"));
  EXPECT_FALSE(write_curves(folder.path() / "no" / "a.png", {{"step", "loss"}, {{1, 2}}}));
}

}  // namespace
}  // namespace posecoach
