#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <random>

#include "core/base/file.h"
#include "core/session/file_name.h"
#include "core/session/places.h"
#include "core/session/sha256.h"
#include "core/session/wall_time.h"
#include "tests/support/temporary_folder.h"

namespace posecoach {
namespace {

using Variables = std::map<std::string, std::string>;

Places places_with(const Variables& variables) {
  return find_places([&](const char* name) -> std::optional<std::string> {
    const auto found = variables.find(name);
    if (found == variables.end()) return {};
    return found->second;
  });
}

TEST(Places, follow_the_xdg_variables_and_ignore_relative_ones) {
  const Places usual = places_with({{"HOME", "/home/anna"}});
  EXPECT_EQ(usual.config, "/home/anna/.config/virtual-pose-coach");
  EXPECT_EQ(usual.data, "/home/anna/.local/share/virtual-pose-coach");
  EXPECT_EQ(usual.state, "/home/anna/.local/state/virtual-pose-coach");
  EXPECT_EQ(usual.library, "/home/anna/Videos/VirtualPoseCoach");
  const Places set = places_with({{"HOME", "/home/anna"},
                                  {"XDG_CONFIG_HOME", "/c"},
                                  {"XDG_DATA_HOME", "/d"},
                                  {"XDG_STATE_HOME", "/s"},
                                  {"POSECOACH_LIBRARY", "/media/stick"}});
  EXPECT_EQ(set.settings_file(), "/c/virtual-pose-coach/settings.json");
  EXPECT_EQ(set.people(), "/d/virtual-pose-coach/people");
  EXPECT_EQ(set.state, "/s/virtual-pose-coach");
  EXPECT_EQ(set.library, "/media/stick");
  const Places relative = places_with({{"HOME", "/home/anna"},
                                       {"XDG_CONFIG_HOME", "c"},
                                       {"XDG_DATA_HOME", ""},
                                       {"XDG_STATE_HOME", "./s"},
                                       {"POSECOACH_LIBRARY", "stick"}});
  EXPECT_EQ(relative.config, usual.config);
  EXPECT_EQ(relative.data, usual.data);
  EXPECT_EQ(relative.state, usual.state);
  EXPECT_EQ(relative.library, usual.library);
}

TEST(Places, the_library_lies_in_the_user_s_own_folder_of_videos) {
  const struct {
    const char* line;
    const char* library;
  } rows[] = {
      {"XDG_VIDEOS_DIR=\"$HOME/Vidéos de moi\"", "/home/anna/Vidéos de moi/VirtualPoseCoach"},
      {"XDG_VIDEOS_DIR=\"/big/films\"", "/big/films/VirtualPoseCoach"},
      {"  XDG_VIDEOS_DIR=\"$HOME/a\\\"b\"  # mine", "/home/anna/a\"b/VirtualPoseCoach"},
      {"XDG_VIDEOS_DIR=\"$HOME/\"", "/home/anna/VirtualPoseCoach"},
      {"#XDG_VIDEOS_DIR=\"$HOME/Movies\"", "/home/anna/Videos/VirtualPoseCoach"},
      {"XDG_VIDEOS_DIR=\"films\"", "/home/anna/Videos/VirtualPoseCoach"},
      {"XDG_VIDEOS_DIR=\"$HOMEfilms\"", "/home/anna/Videos/VirtualPoseCoach"},
      {"", "/home/anna/Videos/VirtualPoseCoach"},
  };
  const TemporaryFolder config;
  for (const auto& row : rows) {
    ASSERT_TRUE(write_file_atomically(config.path() / "user-dirs.dirs",
                                      std::string("XDG_MUSIC_DIR=\"$HOME/Music\"\n") + row.line + "\n"));
    EXPECT_EQ(places_with({{"HOME", "/home/anna"}, {"XDG_CONFIG_HOME", config.path()}}).library, row.library);
  }
}

TEST(WallTime, text_and_back_is_the_same_moment_in_every_zone) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 500; ++i) {
    WallTime time;
    time.utc += std::chrono::milliseconds(random() % 4'000'000'000'000ULL);
    time.offset = std::chrono::minutes(static_cast<int>(random() % (26 * 60)) - 12 * 60);
    EXPECT_EQ(wall_time_from_iso(to_iso(time)).value(), time) << to_iso(time);
  }
}

TEST(WallTime, says_what_the_clock_on_the_wall_said) {
  const WallTime time = wall_time_from_iso("2026-12-31T23:30:05.5-08:00").value();
  EXPECT_EQ(day_of(time), "2026-12-31");
  EXPECT_EQ(clock_of(time), "233005");
  EXPECT_EQ(to_words(time), "2026-12-31 23:30");
  EXPECT_EQ(time.utc, wall_time_from_iso("2027-01-01T07:30:05.500Z")->utc);
}

TEST(WallTime, anything_else_is_refused) {
  for (const char* text : {"", "2026", "2026-13-01T00:00:00Z", "2026-02-30T00:00:00Z", "2026-01-01T24:00:00Z",
                           "2026-01-01 00:00:00Z", "2026-01-01T00:00:00+1:00", "2026-01-01T00:00:00Zx",
                           "2026-01-01T00:00", "-026-01-01T00:00:00Z", "2026-01-01T00:00:00+99:00"})
    EXPECT_EQ(wall_time_from_iso(text).error().code, ErrorCode::Malformed) << text;
}

TEST(Sha256, gives_the_published_values) {
  const struct {
    std::string text;
    const char* digest;
  } rows[] = {
      {"", "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"},
      {"abc", "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"},
      {"abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq",
       "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1"},
      {std::string(1'000'000, 'a'), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0"},
  };
  for (const auto& row : rows) {
    Sha256 hash;
    for (std::size_t at = 0, step = 1; at < row.text.size(); at += step, step = step % 97 + 1)
      hash.add(std::string_view(row.text).substr(at, step));
    EXPECT_EQ(hash.finish(), row.digest);
  }
}

TEST(FileName, is_good_on_every_disk_and_different_for_different_people) {
  EXPECT_EQ(file_name_from("Søren B. Ek"), "soren_b_ek");
  EXPECT_EQ(file_name_from("  ÉLODIE  "), "elodie");
  EXPECT_EQ(file_name_from("../../etc/passwd"), "etc_passwd");
  EXPECT_EQ(file_name_from("山田 太郎"), "山田_太郎");
  EXPECT_EQ(file_name_from("Иван"), file_name_from("иван"));
  EXPECT_NE(file_name_from("Иван"), file_name_from("Пётр"));
  EXPECT_EQ(file_name_from("..."), "unnamed");
  EXPECT_EQ(file_name_from(std::string(500, 'a')).size(), 40u);
  std::mt19937 random(2);
  for (int i = 0; i < 2000; ++i) {
    std::string text(random() % 60, '\0');
    for (char& c : text) c = static_cast<char>(random());
    const std::string name = file_name_from(text);
    EXPECT_THAT(name, testing::Not(testing::AnyOf("", ".", "..")));
    EXPECT_LE(name.size(), 40u);
    EXPECT_EQ(name.find_first_of(std::string_view("/\\:*?\"<>|. \n\0", 13)), std::string::npos) << name;
    EXPECT_EQ(file_name_from(name), name) << "a name is its own name";
    EXPECT_EQ(folded(folded(text)), folded(text));
  }
}

}  // namespace
}  // namespace posecoach
