#include "capture/video_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "core/base/file.h"
#include "core/base/math.h"
#include "tests/capture/test_film.h"

namespace posecoach {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

fs::path scratch(const std::string& name) {
  const fs::path folder = fs::path(testing::TempDir()) / "posecoach_films";
  fs::create_directories(folder);
  return folder / name;
}

TestFilm make_film(std::vector<std::int64_t> times_ms, int width = 13, int height = 7) {
  TestFilm film;
  for (std::size_t i = 0; i < times_ms.size(); ++i)
    film.pictures.push_back(make_test_picture(width, height, static_cast<unsigned>(i)));
  film.times_ms = std::move(times_ms);
  return film;
}

std::vector<Frame> read_all(FrameSource& source) {
  std::vector<Frame> frames;
  while (true) {
    auto frame = source.next({});
    EXPECT_TRUE(frame) << frame.error().message;
    if (!frame || !*frame) return frames;
    frames.push_back(std::move(**frame));
  }
}

std::vector<std::int64_t> milliseconds(const std::vector<Frame>& frames) {
  std::vector<std::int64_t> times;
  for (const Frame& frame : frames)
    times.push_back(std::chrono::round<std::chrono::milliseconds>(frame.time.time_since_epoch()).count());
  return times;
}

Error open_error(const fs::path& path) {
  auto opened = open_video_file(path);
  EXPECT_FALSE(opened);
  return opened ? Error{} : opened.error();
}

TEST(VideoFile, pictures_come_back_pixel_by_pixel_and_numbered) {
  const TestFilm film = make_film({0, 40, 80, 120});
  write_test_film(scratch("plain.mov"), film);
  auto source = open_video_file(scratch("plain.mov")).value();
  EXPECT_EQ(source->info().width, 13);
  EXPECT_EQ(source->info().height, 7);
  EXPECT_EQ(source->info().frame_count, 4U);
  const auto frames = read_all(*source);
  ASSERT_EQ(frames.size(), 4U);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(frames[i].index, i);
    EXPECT_EQ(frames[i].image->rgb, film.pictures[i].rgb);
  }
  EXPECT_FALSE(source->next({}).value());  // the end stays the end
}

TEST(VideoFile, a_variable_frame_rate_stays_variable) {
  write_test_film(scratch("variable.mkv"), make_film({0, 33, 67, 200, 210, 500}));
  const auto frames = read_all(*open_video_file(scratch("variable.mkv")).value());
  EXPECT_THAT(milliseconds(frames), ElementsAre(0, 33, 67, 200, 210, 500));
}

TEST(VideoFile, times_count_from_the_films_start) {
  write_test_film(scratch("late.mkv"), make_film({5000, 5040, 5080}));
  EXPECT_THAT(milliseconds(read_all(*open_video_file(scratch("late.mkv")).value())), ElementsAre(0, 40, 80));
}

// Where the pixel of a stored picture is to be seen.
struct Turn {
  const char* name;
  std::array<int, 4> matrix;
  bool swaps;
  Vec2 (*shown)(int x, int y, int width, int height);
};

class RotatedFilm : public testing::TestWithParam<Turn> {};

TEST_P(RotatedFilm, is_shown_upright) {
  TestFilm film = make_film({0, 40});
  film.matrix = GetParam().matrix;
  const fs::path path = scratch(std::string(GetParam().name) + ".mov");
  write_test_film(path, film);
  auto source = open_video_file(path).value();
  EXPECT_EQ(source->info().width, GetParam().swaps ? 7 : 13);
  EXPECT_EQ(source->info().height, GetParam().swaps ? 13 : 7);
  const auto frames = read_all(*source);
  ASSERT_EQ(frames.size(), 2U);
  for (int y = 0; y < 7; ++y)
    for (int x = 0; x < 13; ++x) {
      const Vec2 at = GetParam().shown(x, y, 13, 7);
      const std::uint8_t* shown = frames[1].image->pixel(static_cast<int>(at.x), static_cast<int>(at.y));
      const std::uint8_t* stored = film.pictures[1].pixel(x, y);
      ASSERT_TRUE(std::equal(shown, shown + 3, stored)) << x << " " << y;
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, RotatedFilm,
    testing::Values(Turn{"quarter_clockwise",
                         {0, 1, -1, 0},
                         true,
                         [](int x, int y, int, int height) { return Vec2(height - 1 - y, x); }},
                    Turn{"quarter_counterclockwise",
                         {0, -1, 1, 0},
                         true,
                         [](int x, int y, int width, int) { return Vec2(y, width - 1 - x); }},
                    Turn{"half",
                         {-1, 0, 0, -1},
                         false,
                         [](int x, int y, int width, int height) {
                           return Vec2(width - 1 - x, height - 1 - y);
                         }},
                    Turn{"mirrored",
                         {-1, 0, 0, 1},
                         false,
                         [](int x, int y, int width, int) { return Vec2(width - 1 - x, y); }}),
    [](const testing::TestParamInfo<Turn>& turn) { return turn.param.name; });

TEST(VideoFile, a_film_of_three_frames_has_three) {
  write_test_film(scratch("three.mov"), make_film({0, 40, 80}));
  EXPECT_EQ(read_all(*open_video_file(scratch("three.mov")).value()).size(), 3U);
}

TEST(VideoFile, a_cut_off_film_gives_its_beginning_then_one_warning) {
  std::vector<std::int64_t> times;
  for (int i = 0; i < 50; ++i) times.push_back(40 * i);
  const TestFilm film = make_film(times, 64, 48);
  write_test_film(scratch("whole.mkv"), film);
  const std::string bytes = read_file(scratch("whole.mkv")).value();
  ASSERT_TRUE(write_file_atomically(scratch("cut.mkv"), std::string_view(bytes).substr(0, bytes.size() / 2)));
  auto source = open_video_file(scratch("cut.mkv")).value();
  testing::internal::CaptureStderr();
  const auto frames = read_all(*source);
  EXPECT_FALSE(source->next({}).value());
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_GE(frames.size(), 20U);
  EXPECT_LE(frames.size(), 26U);
  // The last may be a half picture; those before it are whole.
  for (std::size_t i = 0; i + 1 < frames.size(); ++i) ASSERT_EQ(frames[i].image->rgb, film.pictures[i].rgb);
  EXPECT_THAT(said, HasSubstr("cut.mkv is cut off: "));
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1);
}

// What the live screen shows where there is no terminal.
TEST(VideoFile, a_cut_off_film_and_one_with_a_broken_picture_say_so_and_what_to_do) {
  std::vector<std::int64_t> times;
  for (int i = 0; i < 50; ++i) times.push_back(40 * i);
  write_test_film(scratch("good.mkv"), make_film(times, 64, 48));
  const std::string bytes = read_file(scratch("good.mkv")).value();
  ASSERT_TRUE(
      write_file_atomically(scratch("short.mkv"), std::string_view(bytes).substr(0, bytes.size() / 2)));
  std::string broken = bytes;
  const std::size_t picture = broken.find("IDAT", bytes.size() / 2);
  ASSERT_NE(picture, std::string::npos);
  for (std::size_t i = picture + 8; i < picture + 60; ++i) broken[i] = static_cast<char>(0x55);
  ASSERT_TRUE(write_file_atomically(scratch("broken.mkv"), broken));
  testing::internal::CaptureStderr();
  const auto read = [](const std::filesystem::path& path) {
    const auto source = open_video_file(path).value();
    EXPECT_TRUE(read_all(*source).size() >= 20);
    return source->damage();
  };
  EXPECT_EQ(read(scratch("good.mkv")), "");
  EXPECT_THAT(read(scratch("short.mkv")), testing::StartsWith("short.mkv is cut off: 2"));
  EXPECT_THAT(read(scratch("broken.mkv")),
              testing::StartsWith("broken.mkv is damaged: some of its pictures"));
  EXPECT_THAT(read(scratch("broken.mkv")), HasSubstr("choose another film"));
  testing::internal::GetCapturedStderr();
}

TEST(VideoFile, a_whole_film_is_read_without_a_word) {
  write_test_film(scratch("quiet.mkv"), make_film({0, 40, 80, 120, 500}));
  write_test_film(scratch("quiet_late.mkv"), make_film({5000, 5040}));
  testing::internal::CaptureStderr();
  read_all(*open_video_file(scratch("quiet.mkv")).value());
  read_all(*open_video_file(scratch("quiet_late.mkv")).value());
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(VideoFile, a_film_without_its_index_is_named_so) {
  write_test_film(scratch("index.mov"), make_film({0, 40, 80}, 64, 48));
  const std::string bytes = read_file(scratch("index.mov")).value();
  ASSERT_TRUE(write_file_atomically(scratch("cut.mov"), std::string_view(bytes).substr(0, bytes.size() / 2)));
  const Error error = open_error(scratch("cut.mov"));
  EXPECT_EQ(error.code, ErrorCode::Malformed);
  EXPECT_THAT(error.message, HasSubstr("without its index"));
}

TEST(VideoFile, damaged_films_end_in_frames_or_one_clear_line) {
  write_test_film(scratch("healthy.mov"), make_film({0, 40, 80, 120}, 32, 24));
  const std::string good = read_file(scratch("healthy.mov")).value();
  std::mt19937 random(40);
  testing::internal::CaptureStderr();
  for (int round = 0; round < 150; ++round) {
    std::string bytes = good;
    for (int k = 0; k < 10; ++k) bytes[random() % bytes.size()] = static_cast<char>(random() & 255U);
    ASSERT_TRUE(write_file_atomically(scratch("damaged.mov"), bytes));
    auto source = open_video_file(scratch("damaged.mov"));
    if (!source) {
      EXPECT_THAT(source.error().message, HasSubstr("damaged.mov"));
      continue;
    }
    std::optional<MediaTime> last;
    while (true) {
      const auto frame = (*source)->next({});
      if (!frame || !*frame) break;
      EXPECT_EQ((*frame)->image->width, (*source)->info().width);
      EXPECT_TRUE(!last || (*frame)->time > *last);
      last = (*frame)->time;
    }
  }
  testing::internal::GetCapturedStderr();
}

TEST(VideoFile, what_is_not_a_film_ends_in_one_line_that_names_it) {
  ASSERT_TRUE(write_file_atomically(scratch("empty.mp4"), ""));
  ASSERT_TRUE(write_file_atomically(scratch("text.mp4"), std::string(5000, 'x') + "\nnot a film\n"));
  ASSERT_TRUE(write_file_atomically(scratch("text.txt"), "Keep your head still.\n"));
  write_silence(scratch("sound.mp4"));
  EXPECT_THAT(open_error(scratch("empty.mp4")).message, HasSubstr("empty.mp4 is empty"));
  EXPECT_THAT(open_error(scratch("text.mp4")).message, HasSubstr("text.mp4 is not a film"));
  EXPECT_THAT(open_error(scratch("text.txt")).message, HasSubstr("text.txt is not a film"));
  EXPECT_THAT(open_error(scratch("sound.mp4")).message, HasSubstr("sound.mp4 holds sound but no pictures"));
  EXPECT_EQ(open_error(scratch("sound.mp4")).code, ErrorCode::Unsupported);
  EXPECT_EQ(open_error(scratch("missing.mp4")).code, ErrorCode::NotFound);
  EXPECT_EQ(open_error(testing::TempDir()).code, ErrorCode::Unreadable);
}

TEST(VideoFile, a_request_to_stop_is_heard) {
  write_test_film(scratch("stop.mov"), make_film({0, 40}));
  std::stop_source stop;
  auto source = open_video_file(scratch("stop.mov")).value();
  ASSERT_TRUE(source->next(stop.get_token()).value());
  stop.request_stop();
  EXPECT_EQ(source->next(stop.get_token()).error().code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace posecoach
