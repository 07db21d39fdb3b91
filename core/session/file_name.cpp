#include "core/session/file_name.h"

#include <array>
#include <cstdint>

namespace posecoach {
namespace {

constexpr std::size_t kLongestName = 40;

// U+00C0 to U+017F without accents; '.' keeps the letter as it is.
constexpr std::string_view kPlainLatin =
    "aaaaaaaceeeeiiiidnooooo.ouuuuyts"                                   // U+00C0
    "aaaaaaaceeeeiiiidnooooo.ouuuuyty"                                   // U+00E0
    "aaaaaaccccccccddddeeeeeeeeeegggggggghhhhiiiiiiiiiiiijjkkklllllll"   // U+0100
    "lllnnnnnnnnnoooooooorrrrrrssssssssttttttuuuuuuuuuuuuwwyyyzzzzzzs";  // U+0140
static_assert(kPlainLatin.size() == 0x180 - 0xC0);

// The character that starts at `at`, and how many bytes it takes; 0 where it is no UTF-8 of two bytes.
std::uint32_t two_byte_character(std::string_view text, std::size_t at) {
  if (at + 1 >= text.size()) return 0;
  const auto first = static_cast<unsigned char>(text[at]), second = static_cast<unsigned char>(text[at + 1]);
  if ((first & 0xE0U) != 0xC0U || (second & 0xC0U) != 0x80U) return 0;
  return ((first & 0x1FU) << 6U) | (second & 0x3FU);
}

std::uint32_t small(std::uint32_t character) {
  if (character >= 0x391 && character <= 0x3A9) return character + 0x20;  // Greek
  if (character >= 0x410 && character <= 0x42F) return character + 0x20;  // Cyrillic
  if (character >= 0x400 && character <= 0x40F) return character + 0x50;
  return character;
}

// How many bytes the character at `at` takes; 1 for a byte that is no UTF-8.
std::size_t character_bytes(std::string_view text, std::size_t at) {
  const auto first = static_cast<unsigned char>(text[at]);
  const std::size_t size = first >= 0xF0 && first < 0xF5   ? 4
                           : first >= 0xE0 && first < 0xF0 ? 3
                           : first >= 0xC2 && first < 0xE0 ? 2
                                                           : 1;
  if (at + size > text.size()) return 1;
  for (std::size_t i = 1; i < size; ++i)
    if ((static_cast<unsigned char>(text[at + i]) & 0xC0U) != 0x80U) return 1;
  return size;
}

void append(std::string& out, std::uint32_t character) {
  out += static_cast<char>(0xC0U | (character >> 6U));
  out += static_cast<char>(0x80U | (character & 0x3FU));
}

}  // namespace

std::string folded(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c >= 'A' && c <= 'Z') {
      out += static_cast<char>(c - 'A' + 'a');
      continue;
    }
    const std::uint32_t character = two_byte_character(text, i);
    if (character < 0xC0) {
      out += c;
      continue;
    }
    ++i;
    const char plain = character < 0x180 ? kPlainLatin[character - 0xC0] : '.';
    if (plain != '.')
      out += plain;
    else
      append(out, small(character));
  }
  return out;
}

std::string file_name_from(std::string_view text) {
  const std::string letters = folded(text);
  std::string name;
  for (std::size_t at = 0, size = 0; at < letters.size(); at += size) {
    size = character_bytes(letters, at);
    const char c = letters[at];
    if (name.size() + size > kLongestName) break;
    if (size > 1 || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'))
      name += letters.substr(at, size);
    else if (!name.empty() && name.back() != '_')
      name += '_';
  }
  while (name.ends_with('_')) name.pop_back();
  return name.empty() ? "unnamed" : name;
}

}  // namespace posecoach
