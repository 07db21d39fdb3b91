// Keys as the keyboard's user sees them. Printable keys have their capital letter's code; the values are
// those of GLFW, so that the window passes them on as they are.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace posecoach {

enum class Key : int {
  None = 0,
  Space = 32,
  Plus = '+',
  Comma = ',',
  Minus = '-',
  Period = '.',
  Slash = '/',
  Digit0 = '0',
  Digit1 = '1',
  Digit2 = '2',
  Digit3 = '3',
  Digit4 = '4',
  Digit5 = '5',
  Digit6 = '6',
  Digit7 = '7',
  Digit8 = '8',
  Digit9 = '9',
  Equal = '=',
  Question = '?',
  A = 'A',
  B = 'B',
  C = 'C',
  D = 'D',
  E = 'E',
  F = 'F',
  G = 'G',
  H = 'H',
  I = 'I',
  J = 'J',
  K = 'K',
  L = 'L',
  M = 'M',
  N = 'N',
  O = 'O',
  P = 'P',
  Q = 'Q',
  R = 'R',
  S = 'S',
  T = 'T',
  U = 'U',
  V = 'V',
  W = 'W',
  X = 'X',
  Y = 'Y',
  Z = 'Z',
  LeftBracket = '[',
  RightBracket = ']',
  Escape = 256,
  Enter = 257,
  Tab = 258,
  Backspace = 259,
  Insert = 260,
  Delete = 261,
  Right = 262,
  Left = 263,
  Down = 264,
  Up = 265,
  PageUp = 266,
  PageDown = 267,
  Home = 268,
  End = 269,
  F1 = 290,
  F8 = 297,
  F9 = 298,
  F11 = 300,
  F12 = 301
};

struct KeyPress {
  Key key = Key::None;
  bool shift = false;
  bool control = false;

  bool operator==(const KeyPress&) const = default;
};

// For people: "Ctrl+←", "Shift+L", "Space".
std::string to_words(const KeyPress& press);
// For files: "Ctrl+Left", "Shift+L", "Space"; without spaces in it.
std::string to_text(const KeyPress& press);
// As to_text writes it, letter case aside; nothing for what is no key.
std::optional<KeyPress> key_press_from_text(std::string_view text);

}  // namespace posecoach
