#include "core/motion/text_scanner.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace posecoach {
namespace {

constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f' || c == '\0';
}
constexpr bool is_brace(char c) {
  return c == '{' || c == '}';
}
constexpr char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

}  // namespace

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string shown = "\"";
  for (const char c : text.substr(0, kLongest)) shown += c >= ' ' && c <= '~' ? c : '?';
  return shown + (text.size() > kLongest ? "...\"" : "\"");
}

std::optional<double> parse_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<long> parse_integer(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  long value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

bool equals_ignoring_case(std::string_view a, std::string_view b) {
  return to_lower(a) == to_lower(b);
}

std::string to_lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = lower(c);
  return out;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

bool TextScanner::at_newline(std::size_t& length) const {
  if (position_ >= text_.size()) return false;
  if (text_[position_] == '\n') {
    length = 1;
    return true;
  }
  if (text_[position_] != '\r') return false;
  length = position_ + 1 < text_.size() && text_[position_ + 1] == '\n' ? 2 : 1;
  return true;
}

void TextScanner::skip_blanks() {
  while (position_ < text_.size() && is_blank(text_[position_])) {
    std::size_t length = 1;
    if (at_newline(length)) ++line_;
    position_ += length;
  }
}

std::string_view TextScanner::peek() {
  skip_blanks();
  if (position_ < text_.size()) word_line_ = line_;
  std::size_t end = position_;
  if (end < text_.size() && is_brace(text_[end]))
    ++end;
  else
    while (end < text_.size() && !is_blank(text_[end]) && !is_brace(text_[end])) ++end;
  return text_.substr(position_, end - position_);
}

std::string_view TextScanner::next() {
  const std::string_view word = peek();
  position_ += word.size();
  return word;
}

bool TextScanner::next_number(double& value) {
  skip_blanks();
  const char* begin = text_.data() + position_;
  const char* const text_end = text_.data() + text_.size();
  if (begin != text_end && *begin == '+') ++begin;
  const auto [end, error] = std::from_chars(begin, text_end, value);
  if (error != std::errc{} || !(std::abs(value) <= kLargestNumber)) return false;
  if (end != text_end && !is_blank(*end) && !is_brace(*end)) return false;
  position_ = static_cast<std::size_t>(end - text_.data());
  word_line_ = line_;
  return true;
}

std::string_view TextScanner::rest_of_name() {
  const std::size_t end = std::min(text_.find_first_of("\r\n{", position_), text_.size());
  const std::string_view rest = text_.substr(position_, end - position_);
  position_ = end;
  return trimmed(rest);
}

void TextScanner::skip_line() {
  position_ = std::min(text_.find_first_of("\r\n", position_), text_.size());
}

bool TextScanner::at_line_end() {
  const std::size_t next = text_.find_first_not_of(" \t\v\f", position_);
  return next == std::string_view::npos || text_[next] == '\n' || text_[next] == '\r';
}

Error TextScanner::error(const std::string& message, ErrorCode code) const {
  return Error{code, std::string(file_name_) + ":" + std::to_string(word_line_) + ": " + one_line(message)};
}

bool LineReader::next(std::string_view& line) {
  if (position_ >= text_.size()) return false;
  const std::size_t end = std::min(text_.find_first_of("\r\n", position_), text_.size());
  line = text_.substr(position_, end - position_);
  position_ = end;
  if (position_ < text_.size()) position_ += text_.substr(position_, 2) == "\r\n" ? 2u : 1u;
  ++line_;
  return true;
}

Error LineReader::error(const std::string& message, ErrorCode code) const {
  return Error{code, std::string(file_name_) + ":" + std::to_string(line_) + ": " + one_line(message)};
}

}  // namespace posecoach
