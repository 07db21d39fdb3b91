#include "ui/widgets/keys.h"

namespace posecoach {
namespace {

std::string key_name(Key key) {
  switch (key) {
    case Key::Space:
      return "Space";
    case Key::Escape:
      return "Esc";
    case Key::Enter:
      return "Enter";
    case Key::Tab:
      return "Tab";
    case Key::Backspace:
      return "Backspace";
    case Key::Insert:
      return "Insert";
    case Key::Delete:
      return "Delete";
    case Key::Right:
      return "→";
    case Key::Left:
      return "←";
    case Key::Down:
      return "↓";
    case Key::Up:
      return "↑";
    case Key::PageUp:
      return "PgUp";
    case Key::PageDown:
      return "PgDn";
    case Key::Home:
      return "Home";
    case Key::End:
      return "End";
    case Key::F1:
      return "F1";
    case Key::F8:
      return "F8";
    case Key::F9:
      return "F9";
    case Key::F11:
      return "F11";
    default:
      break;
  }
  const int code = static_cast<int>(key);
  return code > 32 && code < 127 ? std::string(1, static_cast<char>(code)) : std::string();
}

}  // namespace

std::string to_words(const KeyPress& press) {
  return std::string(press.control ? "Ctrl+" : "") + (press.shift ? "Shift+" : "") + key_name(press.key);
}

}  // namespace posecoach
