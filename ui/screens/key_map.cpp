#include "ui/screens/key_map.h"

#include <algorithm>

namespace posecoach {
namespace {

using enum Command;

constexpr std::string_view kNoKey = "none";

constexpr std::array kPlayer = {
    std::pair(PlayPause, PlaybackCommand::PlayPause),
    std::pair(StepBack, PlaybackCommand::StepBack),
    std::pair(StepForward, PlaybackCommand::StepForward),
    std::pair(JumpBack, PlaybackCommand::JumpBack),
    std::pair(JumpForward, PlaybackCommand::JumpForward),
    std::pair(SmallJumpBack, PlaybackCommand::SmallJumpBack),
    std::pair(SmallJumpForward, PlaybackCommand::SmallJumpForward),
    std::pair(PreviousEvent, PlaybackCommand::PreviousEvent),
    std::pair(NextEvent, PlaybackCommand::NextEvent),
    std::pair(ToStart, PlaybackCommand::ToStart),
    std::pair(ToEnd, PlaybackCommand::ToEnd),
    std::pair(Slower, PlaybackCommand::Slower),
    std::pair(Faster, PlaybackCommand::Faster),
    std::pair(NormalSpeed, PlaybackCommand::NormalSpeed),
    std::pair(ShuttleBack, PlaybackCommand::ShuttleBack),
    std::pair(ShuttleForward, PlaybackCommand::ShuttleForward),
    std::pair(MarkIn, PlaybackCommand::MarkIn),
    std::pair(MarkOut, PlaybackCommand::MarkOut),
    std::pair(ToggleLoop, PlaybackCommand::ToggleLoop),
    std::pair(ClearMarks, PlaybackCommand::ClearMarks),
};

constexpr bool is_set(const KeyPress& press) {
  return press.key != Key::None;
}

// The first place is never the empty one of two.
void close_up(Chords& chords) {
  if (!is_set(chords[0])) std::swap(chords[0], chords[1]);
}

std::string text_of(const Chords& chords) {
  std::string text;
  for (const KeyPress& press : chords)
    if (is_set(press)) text += (text.empty() ? "" : " ") + to_text(press);
  return text.empty() ? std::string(kNoKey) : text;
}

// Up to two keys with spaces between; nothing for what is not.
std::optional<Chords> chords_from(const KeyBinding& binding, std::string_view text) {
  Chords chords = {};
  if (text == kNoKey) return chords;
  std::size_t count = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (word.empty()) continue;
    const std::optional<KeyPress> press = key_press_from_text(word);
    if (!press || count >= chords.size()) return std::nullopt;
    const bool is_usual = *press == binding.chords[0] || *press == binding.chords[1];
    if (!is_usual && !KeyMap::is_free(*press)) return std::nullopt;
    chords[count++] = *press;
  }
  if (count == 0) return std::nullopt;
  return chords;
}

}  // namespace

std::string_view title_of(KeyGroup group) {
  switch (group) {
    case KeyGroup::Everywhere:
      return "Everywhere";
    case KeyGroup::Live:
      return "Live";
    case KeyGroup::Player:
      return "Player";
    case KeyGroup::Review:
      return "Review";
    case KeyGroup::Library:
      return "Library";
  }
  return {};
}

KeyMap::KeyMap() {
  for (const KeyBinding& binding : key_bindings())
    chords_[static_cast<std::size_t>(binding.command)] = binding.chords;
}

bool KeyMap::is_changed(Command command) const {
  return chords(command) != binding_of(command).chords;
}

bool KeyMap::is_changed() const {
  return !(*this == KeyMap());
}

std::optional<Command> KeyMap::owner(const KeyPress& press, Command command) const {
  if (!is_set(press)) return std::nullopt;
  for (const KeyBinding& binding : key_bindings()) {
    if (binding.command == command || (binding.screens & binding_of(command).screens) == 0) continue;
    const Chords& taken = chords(binding.command);
    if (std::find(taken.begin(), taken.end(), press) != taken.end()) return binding.command;
  }
  return std::nullopt;
}

bool KeyMap::is_free(const KeyPress& press) {
  if (press.key == Key::Escape || press.key == Key::Tab) return false;
  return press.key != Key::Enter || press.control || press.shift;
}

void KeyMap::set(Command command, std::size_t place, const KeyPress& press) {
  while (const std::optional<Command> other = owner(press, command)) {
    Chords& taken = chords_[static_cast<std::size_t>(*other)];
    std::replace(taken.begin(), taken.end(), press, KeyPress());
    close_up(taken);
  }
  Chords& mine = chords_[static_cast<std::size_t>(command)];
  // The same key twice is one key.
  if (is_set(press)) std::replace(mine.begin(), mine.end(), press, KeyPress());
  mine[std::min(place, mine.size() - 1)] = press;
  close_up(mine);
}

void KeyMap::reset(Command command) {
  const Chords& usual = binding_of(command).chords;
  for (std::size_t place = usual.size(); place-- > 0;) set(command, place, KeyPress());
  for (std::size_t place = 0; place < usual.size(); ++place)
    if (is_set(usual[place])) set(command, place, usual[place]);
}

std::map<std::string, std::string> KeyMap::saved(const std::map<std::string, std::string>& before) const {
  std::map<std::string, std::string> words = before;
  for (const KeyBinding& binding : key_bindings()) {
    const std::string name(binding.name);
    words.erase(name);
    if (is_changed(binding.command)) words[name] = text_of(chords(binding.command));
  }
  return words;
}

SavedKeyMap key_map_from(const std::map<std::string, std::string>& saved) {
  SavedKeyMap loaded;
  const auto tell = [&](const KeyBinding& binding, const std::string& what) {
    loaded.messages.push_back("settings.json, keys: \"" + std::string(binding.name) + "\": " + what + "; " +
                              text_of(loaded.keys.chords(binding.command)) + " counts");
  };
  // All that wish for other keys let go of theirs first.
  std::vector<std::pair<Command, Chords>> wishes;
  for (const KeyBinding& binding : key_bindings()) {
    const auto found = saved.find(std::string(binding.name));
    if (found == saved.end() || binding.is_fixed) continue;
    if (const std::optional<Chords> chords = chords_from(binding, found->second))
      wishes.emplace_back(binding.command, *chords);
    else
      tell(binding, "\"" + found->second + "\" is no key that can be chosen");
  }
  for (const auto& [command, chords] : wishes)
    for (std::size_t place = chords.size(); place-- > 0;) loaded.keys.set(command, place, KeyPress());
  for (const auto& [command, chords] : wishes)
    for (std::size_t place = 0; place < chords.size(); ++place) {
      if (!is_set(chords[place])) continue;
      if (const std::optional<Command> other = loaded.keys.owner(chords[place], command)) {
        for (std::size_t usual = 0; usual < chords.size(); ++usual) {
          const KeyPress& press = binding_of(command).chords[usual];
          loaded.keys.set(command, usual, loaded.keys.owner(press, command) ? KeyPress() : press);
        }
        tell(binding_of(command), "\"" + to_text(chords[place]) + "\" is \"" +
                                      std::string(binding_of(*other).words) + "\" already");
        break;
      }
      loaded.keys.set(command, place, chords[place]);
    }
  return loaded;
}

bool was_pressed(Ui& ui, const KeyMap& keys, Command command) {
  const Repeats repeats = binding_of(command).is_repeated ? Repeats::Count : Repeats::Ignored;
  for (const KeyPress& press : keys.chords(command))
    if (is_set(press) && ui.take_key(press, repeats)) return true;
  return false;
}

std::string key_words(const KeyMap& keys, Command command) {
  std::string words;
  for (const KeyPress& press : keys.chords(command))
    if (is_set(press)) words += (words.empty() ? "" : "  or  ") + to_words(press);
  return words.empty() ? "no key" : words;
}

std::string with_key(const KeyMap& keys, std::string_view words, Command command) {
  const KeyPress& first = keys.chords(command)[0];
  return std::string(words) + (is_set(first) ? " (" + to_words(first) + ")" : "");
}

Playback played_by_keys(Ui& ui, const KeyMap& keys, Playback playback, const FilmMarks& film) {
  for (const auto& [command, deed] : kPlayer)
    while (was_pressed(ui, keys, command)) playback = applied(playback, deed, film);
  for (std::size_t i = 0; i < 8; ++i)
    if (was_pressed(ui, keys, static_cast<Command>(static_cast<std::size_t>(Position1) + i)) &&
        i < film.events.size())
      playback = moved_to(playback, film.events[i], film);
  return playback;
}

}  // namespace posecoach
