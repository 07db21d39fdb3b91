// Walks through a text file word by word and knows the line, so that every reader can say where a file is
// broken. Words are separated by blanks, tabs and any kind of line end; braces are words of their own.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace posecoach {

// At most 40 printable characters of foreign text in quotation marks, fit for a message of one line.
std::string in_quotes(std::string_view text);

// Beyond it a number in a motion file is a mistake, whatever the unit.
inline constexpr double kLargestNumber = 1e7;

// The whole of `text` as a finite number; a leading plus and exponents are fine.
std::optional<double> parse_number(std::string_view text);
std::optional<long> parse_integer(std::string_view text);

bool equals_ignoring_case(std::string_view a, std::string_view b);
std::string to_lower(std::string_view text);
std::string_view trimmed(std::string_view text);

class TextScanner {
 public:
  // Both must outlive the scanner. `file_name` is what messages call the file.
  TextScanner(std::string_view file_name, std::string_view text) : file_name_(file_name), text_(text) {}

  // The next word, empty at the end.
  std::string_view next();
  std::string_view peek();
  bool at_end() { return peek().empty(); }
  // The next word as a finite number of at most kLargestNumber, either sign; when it is none, false and the
  // word is still there to be looked at.
  bool next_number(double& value);
  // What remains of the line after the last word, up to an opening brace, without blanks at its ends.
  std::string_view rest_of_name();
  // Leaves out what remains of the line.
  void skip_line();
  // True when only blanks follow on this line.
  bool at_line_end();

  // The line of the last word, from 1.
  std::size_t line() const { return word_line_; }
  // "walk.bvh:12: ...", for the line of the last word.
  Error error(const std::string& message, ErrorCode code = ErrorCode::Malformed) const;
  tl::unexpected<Error> failure(const std::string& message, ErrorCode code = ErrorCode::Malformed) const {
    return tl::unexpected<Error>(error(message, code));
  }

 private:
  void skip_blanks();
  bool at_newline(std::size_t& length) const;

  std::string_view file_name_;
  std::string_view text_;
  std::size_t position_ = 0;
  std::size_t line_ = 1;       // of the position
  std::size_t word_line_ = 1;  // of the last word
};

// Walks through a text file line by line; for formats in which an empty cell means something.
class LineReader {
 public:
  LineReader(std::string_view file_name, std::string_view text) : file_name_(file_name), text_(text) {}

  // The next line without its end; false after the last one.
  bool next(std::string_view& line);
  // Of the line that was read last, from 1.
  std::size_t line() const { return line_; }
  Error error(const std::string& message, ErrorCode code = ErrorCode::Malformed) const;
  tl::unexpected<Error> failure(const std::string& message, ErrorCode code = ErrorCode::Malformed) const {
    return tl::unexpected<Error>(error(message, code));
  }

 private:
  std::string_view file_name_;
  std::string_view text_;
  std::size_t position_ = 0;
  std::size_t line_ = 0;
};

}  // namespace posecoach
