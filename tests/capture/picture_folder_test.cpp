#include "capture/picture_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/file.h"
#include "core/image/image_codec.h"
#include "tests/capture/test_film.h"

namespace posecoach {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

fs::path empty_folder(const std::string& name) {
  const fs::path folder = fs::path(testing::TempDir()) / ("posecoach_pictures_" + name);
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

TEST(PictureFolder, numbers_in_names_count_as_numbers) {
  std::vector<std::string> names = {"a10", "a9", "b1", "a", "a010", "a9b", "A2", "a09"};
  std::sort(names.begin(), names.end(), comes_before);
  EXPECT_THAT(names, testing::ElementsAre("A2", "a", "a09", "a9", "a9b", "a010", "a10", "b1"));
  EXPECT_TRUE(comes_before("99999999999999999999998", "99999999999999999999999"));
}

TEST(PictureFolder, the_order_of_names_is_a_strict_order) {
  const std::vector<std::string> names = {"", "0", "00", "01", "1", "a", "a0", "a00b", "a0b", "a1", "b"};
  for (const auto& a : names)
    for (const auto& b : names) {
      EXPECT_FALSE(comes_before(a, b) && comes_before(b, a)) << a << " " << b;
      EXPECT_TRUE(a == b || comes_before(a, b) || comes_before(b, a)) << a << " " << b;
      for (const auto& c : names)
        EXPECT_TRUE(!comes_before(a, b) || !comes_before(b, c) || comes_before(a, c)) << a << b << c;
    }
}

TEST(PictureFolder, pictures_come_in_natural_order_with_even_times) {
  const fs::path folder = empty_folder("order");
  for (const unsigned number : {2U, 10U, 1U})
    ASSERT_TRUE(
        write_png(folder / ("swing" + std::to_string(number) + ".PNG"), make_test_picture(5, 4, number)));
  ASSERT_TRUE(write_file_atomically(folder / "notes.txt", "not a picture"));
  auto source = open_picture_folder(folder, {.pictures_per_second = 25}).value();
  EXPECT_EQ(source->info().frame_count, 3U);
  std::size_t index = 0;
  for (const unsigned number : {1U, 2U, 10U}) {
    const auto frame = source->next({}).value();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->index, index);
    EXPECT_NEAR(to_seconds(frame->time), static_cast<double>(index) / 25, 1e-9);
    EXPECT_EQ(frame->image->rgb, make_test_picture(5, 4, number).rgb);
    ++index;
  }
  EXPECT_FALSE(source->next({}).value());
}

TEST(PictureFolder, a_folder_without_pictures_says_so) {
  const auto opened = open_picture_folder(empty_folder("none"));
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().code, ErrorCode::Incomplete);
  EXPECT_EQ(open_picture_folder("/nonexistent").error().code, ErrorCode::NotFound);
}

TEST(PictureFolder, a_damaged_picture_and_one_of_another_size_are_named) {
  const fs::path folder = empty_folder("bad");
  ASSERT_TRUE(write_png(folder / "1.png", make_test_picture(5, 4, 1)));
  ASSERT_TRUE(write_png(folder / "2.png", make_test_picture(6, 4, 1)));
  auto source = open_picture_folder(folder).value();
  ASSERT_TRUE(source->next({}).value());
  EXPECT_THAT(source->next({}).error().message, HasSubstr("2.png is 6x4 pixels"));
  ASSERT_TRUE(write_file_atomically(folder / "2.png", "half a picture"));
  EXPECT_THAT(source->next({}).error().message, HasSubstr("2.png"));
}

}  // namespace
}  // namespace posecoach
