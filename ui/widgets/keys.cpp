#include "ui/widgets/keys.h"

#include <array>

namespace posecoach {
namespace {

struct NamedKey {
  Key key;
  std::string_view text, words;
};

constexpr std::array kNamedKeys = {NamedKey{Key::Space, "Space", "Space"},
                                   NamedKey{Key::Escape, "Esc", "Esc"},
                                   NamedKey{Key::Enter, "Enter", "Enter"},
                                   NamedKey{Key::Tab, "Tab", "Tab"},
                                   NamedKey{Key::Backspace, "Backspace", "Backspace"},
                                   NamedKey{Key::Insert, "Insert", "Insert"},
                                   NamedKey{Key::Delete, "Delete", "Delete"},
                                   NamedKey{Key::Right, "Right", "→"},
                                   NamedKey{Key::Left, "Left", "←"},
                                   NamedKey{Key::Down, "Down", "↓"},
                                   NamedKey{Key::Up, "Up", "↑"},
                                   NamedKey{Key::PageUp, "PgUp", "PgUp"},
                                   NamedKey{Key::PageDown, "PgDn", "PgDn"},
                                   NamedKey{Key::Home, "Home", "Home"},
                                   NamedKey{Key::End, "End", "End"},
                                   NamedKey{Key::Plus, "Plus", "+"},
                                   NamedKey{Key::Minus, "Minus", "−"}};

constexpr int kFirstPrintable = 33, kLastPrintable = 126;

bool is_function_key(Key key) {
  return key >= Key::F1 && key <= Key::F12;
}

std::string name_of(Key key, std::string_view NamedKey::*as) {
  for (const NamedKey& named : kNamedKeys)
    if (named.key == key) return std::string(named.*as);
  const int code = static_cast<int>(key);
  if (is_function_key(key)) return "F" + std::to_string(code - static_cast<int>(Key::F1) + 1);
  return code >= kFirstPrintable && code <= kLastPrintable ? std::string(1, static_cast<char>(code))
                                                           : std::string();
}

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return result;
}

Key key_from_text(std::string_view text) {
  const std::string wanted = upper(text);
  for (const NamedKey& named : kNamedKeys)
    if (upper(named.text) == wanted) return named.key;
  if (wanted.size() == 1 && wanted[0] >= kFirstPrintable && wanted[0] <= kLastPrintable)
    return static_cast<Key>(wanted[0]);
  for (int i = 1; i <= 12; ++i)
    if (wanted == "F" + std::to_string(i)) return static_cast<Key>(static_cast<int>(Key::F1) + i - 1);
  return Key::None;
}

std::string with_modifiers(const KeyPress& press, std::string_view NamedKey::*as) {
  return std::string(press.control ? "Ctrl+" : "") + (press.shift ? "Shift+" : "") + name_of(press.key, as);
}

}  // namespace

std::string to_words(const KeyPress& press) {
  return with_modifiers(press, &NamedKey::words);
}

std::string to_text(const KeyPress& press) {
  return with_modifiers(press, &NamedKey::text);
}

std::optional<KeyPress> key_press_from_text(std::string_view text) {
  KeyPress press;
  const auto takes = [&](std::string_view prefix) {
    if (text.size() <= prefix.size() || upper(text.substr(0, prefix.size())) != upper(prefix)) return false;
    text.remove_prefix(prefix.size());
    return true;
  };
  for (bool goes_on = true; goes_on;) {
    goes_on = false;
    if (!press.control && takes("Ctrl+")) press.control = goes_on = true;
    if (!press.shift && takes("Shift+")) press.shift = goes_on = true;
  }
  press.key = key_from_text(text);
  if (press.key == Key::None) return std::nullopt;
  return press;
}

}  // namespace posecoach
