#include "ui/screens/key_map.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace posecoach {
namespace {

bool has(const Chords& chords, const KeyPress& press) {
  return chords[0] == press || chords[1] == press;
}

void expect_no_key_twice(const KeyMap& keys) {
  for (const KeyBinding& binding : key_bindings())
    for (const KeyPress& press : keys.chords(binding.command))
      if (press.key != Key::None) {
        EXPECT_FALSE(keys.owner(press, binding.command)) << binding.name << ": " << to_text(press);
      }
}

TEST(KeyMap, every_command_has_a_name_a_key_and_words_of_its_own) {
  std::set<std::string_view> names;
  for (const KeyBinding& binding : key_bindings()) {
    EXPECT_TRUE(names.insert(binding.name).second) << binding.name;
    EXPECT_FALSE(binding.words.empty());
    EXPECT_NE(binding.chords[0].key, Key::None) << binding.name;
  }
}

TEST(KeyMap, no_two_commands_of_a_screen_share_a_key) {
  expect_no_key_twice(KeyMap());
}

// What users of Kinovea, mpv and editors arrive with.
TEST(KeyMap, the_keys_that_users_arrive_with_are_there) {
  const KeyMap keys;
  const auto expect = [&](Command command, const char* text) {
    EXPECT_TRUE(has(keys.chords(command), key_press_from_text(text).value())) << text;
  };
  for (const auto& [command, text] : {std::pair(Command::PlayPause, "Space"),
                                      std::pair(Command::PlayPause, "K"),
                                      std::pair(Command::StepBack, "Left"),
                                      std::pair(Command::StepForward, "."),
                                      std::pair(Command::StepBack, ","),
                                      std::pair(Command::JumpBack, "PgUp"),
                                      std::pair(Command::JumpForward, "Shift+Right"),
                                      std::pair(Command::SmallJumpForward, "Shift+PgDn"),
                                      std::pair(Command::PreviousEvent, "Ctrl+Left"),
                                      std::pair(Command::Position1, "1"),
                                      std::pair(Command::Position8, "8"),
                                      std::pair(Command::ToStart, "Home"),
                                      std::pair(Command::ToEnd, "End"),
                                      std::pair(Command::Slower, "Down"),
                                      std::pair(Command::Faster, "]"),
                                      std::pair(Command::NormalSpeed, "Backspace"),
                                      std::pair(Command::ShuttleBack, "J"),
                                      std::pair(Command::ShuttleForward, "L"),
                                      std::pair(Command::MarkIn, "I"),
                                      std::pair(Command::MarkOut, "O"),
                                      std::pair(Command::ToggleLoop, "Shift+L"),
                                      std::pair(Command::SideBySide, "F8"),
                                      std::pair(Command::Superpose, "F9"),
                                      std::pair(Command::Record, "R"),
                                      std::pair(Command::Record, "Ctrl+Enter"),
                                      std::pair(Command::Snapshot, "S"),
                                      std::pair(Command::Snapshot, "Shift+Enter"),
                                      std::pair(Command::KeyImage, "Insert"),
                                      std::pair(Command::ZoomIn, "Ctrl+Plus"),
                                      std::pair(Command::ZoomOut, "Ctrl+Minus"),
                                      std::pair(Command::Mirror, "M"),
                                      std::pair(Command::FullScreen, "F11"),
                                      std::pair(Command::ShowKeys, "F1"),
                                      std::pair(Command::ShowKeys, "?")})
    expect(command, text);
}

TEST(KeyPress, text_and_back_is_the_same_key) {
  for (const KeyBinding& binding : key_bindings())
    for (const KeyPress& press : binding.chords)
      if (press.key != Key::None) {
        EXPECT_EQ(key_press_from_text(to_text(press)), press);
      }
  EXPECT_EQ(key_press_from_text("ctrl+shift+left"), (KeyPress{Key::Left, true, true}));
  for (const char* text : {"", "Ctrl+", "Hyper+K", "Spaces", "F13", "Ctrl+Ctrl+K", " "})
    EXPECT_FALSE(key_press_from_text(text)) << text;
}

TEST(KeyMap, a_chosen_key_leaves_whoever_had_it) {
  KeyMap keys;
  const KeyPress space{Key::Space};
  EXPECT_EQ(keys.owner(space, Command::NextAdvice), Command::PlayPause);
  keys.set(Command::NextAdvice, 0, space);
  EXPECT_TRUE(has(keys.chords(Command::NextAdvice), space));
  EXPECT_FALSE(has(keys.chords(Command::PlayPause), space));
  EXPECT_TRUE(has(keys.chords(Command::PlayPause), {Key::K}));  // the other key stays
  // On another screen the same key means something else.
  EXPECT_TRUE(has(keys.chords(Command::HandsFree), space));
  keys.reset(Command::PlayPause);
  EXPECT_FALSE(has(keys.chords(Command::NextAdvice), space));
  expect_no_key_twice(keys);
}

TEST(KeyMap, saved_and_loaded_is_the_same_whatever_was_chosen) {
  std::mt19937 random(23);
  std::uniform_int_distribution<int> any_command(0, kCommandCount - 1), any_key('A', 'Z'), flag(0, 1);
  for (int round = 0; round < 200; ++round) {
    KeyMap keys;
    for (int change = 0; change < 12; ++change) {
      const auto command = static_cast<Command>(any_command(random));
      if (binding_of(command).is_fixed) continue;
      keys.set(command, static_cast<std::size_t>(flag(random)),
               flag(random) == 0 && flag(random) == 0
                   ? KeyPress()
                   : KeyPress{static_cast<Key>(any_key(random)), flag(random) == 1, flag(random) == 1});
    }
    expect_no_key_twice(keys);
    const SavedKeyMap loaded = key_map_from(keys.saved());
    EXPECT_TRUE(loaded.keys == keys);
    EXPECT_TRUE(loaded.messages.empty());
  }
  EXPECT_TRUE(KeyMap().saved().empty());
}

TEST(KeyMap, a_bad_saved_key_falls_back_with_one_line_that_names_it) {
  const SavedKeyMap loaded =
      key_map_from({{"play_pause", "Ctrl+Banana"}, {"step_back", "Tab"}, {"jump_back", "1"}, {"star", "U"}});
  EXPECT_EQ(loaded.keys.chords(Command::PlayPause), binding_of(Command::PlayPause).chords);
  EXPECT_EQ(loaded.keys.chords(Command::StepBack), binding_of(Command::StepBack).chords);
  EXPECT_EQ(loaded.keys.chords(Command::JumpBack), binding_of(Command::JumpBack).chords);
  EXPECT_TRUE(has(loaded.keys.chords(Command::ToggleStar), {Key::U}));
  ASSERT_EQ(loaded.messages.size(), 3U);
  const std::string all = loaded.messages[0] + loaded.messages[1] + loaded.messages[2];
  for (const char* name : {"play_pause", "step_back", "jump_back", "Ctrl+Banana"})
    EXPECT_NE(all.find(name), std::string::npos) << name;
  for (const std::string& message : loaded.messages) EXPECT_EQ(message.find('\n'), std::string::npos);
  expect_no_key_twice(loaded.keys);
}

TEST(KeyMap, names_of_newer_versions_stay_in_the_file) {
  KeyMap keys;
  keys.set(Command::ToggleStar, 0, {Key::U});
  const auto saved = keys.saved({{"fly", "Ctrl+F"}, {"star", "Y"}, {"search", "U"}});
  EXPECT_EQ(saved, (std::map<std::string, std::string>{{"fly", "Ctrl+F"}, {"star", "U"}}));
}

}  // namespace
}  // namespace posecoach
