#include "capture/video_writer.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include "capture/bar_code.h"
#include "capture/video_file.h"
#include "tests/capture/numbered_film.h"
#include "tests/capture/sound_film.h"
#include "tests/support/temporary_folder.h"

namespace posecoach {
namespace {

namespace fs = std::filesystem;

struct Film {
  std::vector<double> times;
  std::vector<std::optional<std::uint32_t>> codes;
  Image last;
};

Film read_film(const fs::path& path) {
  Film film;
  const auto source = open_video_file(path);
  EXPECT_TRUE(source);
  if (!source) return film;
  for (auto frame = (*source)->next({}); frame && *frame; frame = (*source)->next({})) {
    film.times.push_back(to_seconds((*frame)->time));
    film.codes.push_back(read_bar_code(*(*frame)->image));
    film.last = *(*frame)->image;
  }
  return film;
}

class VideoWriterTest : public testing::Test {
 protected:
  TemporaryFolder folder_;
  fs::path path_ = folder_.path() / "film.mp4";
};

TEST_F(VideoWriterTest, keeps_every_frame_its_number_and_its_own_time) {
  const std::vector<double> times = {0, 0.0333, 0.0400, 0.1, 0.35, 0.36, 0.40, 0.9, 0.95, 1.0};
  auto writer = VideoWriter::open(path_, {.width = 640, .height = 360}).value();
  for (std::size_t i = 0; i < times.size(); ++i)
    ASSERT_TRUE(writer->write(numbered_picture(640, 360, static_cast<std::uint32_t>(1000 + i)),
                              media_time_from_seconds(times[i])));
  ASSERT_TRUE(writer->finish());
  const Film film = read_film(path_);
  ASSERT_EQ(film.times.size(), times.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    EXPECT_NEAR(film.times[i], times[i], 1e-4);
    EXPECT_EQ(film.codes[i], 1000 + i);
  }
}

TEST_F(VideoWriterTest, colours_come_back) {
  auto writer = VideoWriter::open(path_, {.width = 320, .height = 240}).value();
  const Image image = numbered_picture(320, 240, 1);
  ASSERT_TRUE(writer->write(image, MediaTime()));
  ASSERT_TRUE(writer->finish());
  const Film film = read_film(path_);
  for (const auto& [x, y] : {std::pair(100, 100), std::pair(250, 200), std::pair(300, 60)})
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(film.last.pixel(x, y)[c], image.pixel(x, y)[c], 8) << x << " " << y << " " << c;
}

TEST_F(VideoWriterTest, pads_odd_sizes) {
  auto writer = VideoWriter::open(path_, {.width = 321, .height = 241}).value();
  ASSERT_TRUE(writer->write(numbered_picture(321, 241, 5), MediaTime()));
  ASSERT_TRUE(writer->write(numbered_picture(321, 241, 6), media_time_from_seconds(0.1)));
  ASSERT_TRUE(writer->finish());
  const Film film = read_film(path_);
  EXPECT_EQ(film.times.size(), 2U);
  EXPECT_EQ(film.last.width, 322);
  EXPECT_EQ(film.last.height, 242);
}

TEST_F(VideoWriterTest, unfinished_film_leaves_nothing_behind) {
  {
    auto writer = VideoWriter::open(path_, {.width = 320, .height = 240}).value();
    ASSERT_TRUE(writer->write(numbered_picture(320, 240, 1), MediaTime()));
  }
  EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST_F(VideoWriterTest, old_film_stays_until_the_new_one_is_finished) {
  std::ofstream(path_) << "old";
  auto writer = VideoWriter::open(path_, {.width = 320, .height = 240}).value();
  ASSERT_TRUE(writer->write(numbered_picture(320, 240, 1), MediaTime()));
  EXPECT_EQ(fs::file_size(path_), 3U);
  ASSERT_TRUE(writer->finish());
  EXPECT_GT(fs::file_size(path_), 1000U);
}

TEST_F(VideoWriterTest, refuses_what_it_cannot_write) {
  const auto nowhere = VideoWriter::open(folder_.path() / "none" / "film.mp4", {.width = 320, .height = 240});
  ASSERT_FALSE(nowhere);
  EXPECT_EQ(nowhere.error().code, ErrorCode::NotFound);
  EXPECT_NE(nowhere.error().message.find("film.mp4"), std::string::npos);
  EXPECT_FALSE(VideoWriter::open(path_, {.width = 0, .height = 240}));

  auto writer = VideoWriter::open(path_, {.width = 320, .height = 240}).value();
  EXPECT_FALSE(writer->finish());  // no pictures
  ASSERT_TRUE(writer->write(numbered_picture(320, 240, 1), media_time_from_seconds(1)));
  EXPECT_FALSE(writer->write(numbered_picture(320, 240, 2), media_time_from_seconds(1)));
  EXPECT_FALSE(writer->write(numbered_picture(322, 240, 2), media_time_from_seconds(2)));
}

TEST_F(VideoWriterTest, a_pipe_is_refused_and_stays_a_pipe) {
  ASSERT_EQ(::mkfifo(path_.c_str(), 0600), 0);
  const auto writer = VideoWriter::open(path_, {.width = 320, .height = 240});
  ASSERT_FALSE(writer);
  EXPECT_EQ(writer.error().code, ErrorCode::InvalidArgument);
  EXPECT_TRUE(fs::is_fifo(path_));
}

TEST_F(VideoWriterTest, full_disk_is_an_error_and_leaves_nothing) {
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{20000, before.rlim_max};
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  bool failed = false;
  {
    auto writer = VideoWriter::open(path_, {.width = 640, .height = 360, .quality = 1}).value();
    for (std::uint32_t i = 0; i < 40 && !failed; ++i)
      failed = !writer->write(numbered_picture(640, 360, i * 7919), media_time_from_seconds(i / 30.0));
    failed = failed || !writer->finish();
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, old_handler);
  EXPECT_TRUE(failed);
  EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST_F(VideoWriterTest, copies_the_sound_of_another_film_cut_to_length) {
  const fs::path old = folder_.path() / "old.mp4";
  ASSERT_TRUE(write_sound_film(old, 3.0));
  auto writer = VideoWriter::open(path_, {.width = 320, .height = 240, .sound_from = old}).value();
  for (std::uint32_t i = 0; i < 45; ++i)
    ASSERT_TRUE(writer->write(numbered_picture(320, 240, i), media_time_from_seconds(i / 30.0)));
  ASSERT_TRUE(writer->finish());
  const auto sound = sound_seconds(path_);
  ASSERT_TRUE(sound);
  EXPECT_NEAR(sound->second, 1.5, 0.06);  // 45 pictures, within two packets of sound
  EXPECT_NEAR(sound->first, 0.0, 0.03);
  EXPECT_EQ(read_film(path_).times.size(), 45U);
}

TEST_F(VideoWriterTest, film_without_sound_to_copy_is_no_error) {
  const fs::path silent = folder_.path() / "silent.mp4";
  {
    auto writer = VideoWriter::open(silent, {.width = 320, .height = 240}).value();
    ASSERT_TRUE(writer->write(numbered_picture(320, 240, 1), MediaTime()));
    ASSERT_TRUE(writer->finish());
  }
  auto writer = VideoWriter::open(path_, {.width = 320, .height = 240, .sound_from = silent}).value();
  ASSERT_TRUE(writer->write(numbered_picture(320, 240, 1), MediaTime()));
  ASSERT_TRUE(writer->finish());
  EXPECT_FALSE(sound_seconds(path_));
  EXPECT_FALSE(
      VideoWriter::open(path_, {.width = 320, .height = 240, .sound_from = folder_.path() / "none.mp4"}));
}

}  // namespace
}  // namespace posecoach
