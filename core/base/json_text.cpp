#include "core/base/json_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/base/assert.h"

namespace posecoach {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kDeepest = 16;
constexpr double kLargestNumber = 1e12;

// Feeds the parser and counts the lines that it has seen.
class CountingIterator {
 public:
  using iterator_category = std::forward_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, std::size_t* line) : at_(at), line_(line) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    if (*at_++ == '\n') ++*line_;
    return *this;
  }
  CountingIterator operator++(int) {
    CountingIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const CountingIterator& other) const { return at_ == other.at_; }
  bool operator!=(const CountingIterator& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  std::size_t* line_;
};

// Of the parser's message only what is wrong, as one printable line.
std::string reason_of(const std::exception& error) {
  std::string text = error.what();
  if (const std::size_t start = text.find(" - "); start != std::string::npos) text.erase(0, start + 3);
  constexpr std::size_t kLongest = 160;
  if (text.size() > kLongest) text.resize(kLongest);
  for (char& c : text)
    if (c < ' ' || c > '~') c = '?';
  return text;
}

class Walker : public nlohmann::json_sax<Json> {
 public:
  Walker(std::string_view file_name, const JsonHandlers& handlers)
      : file_name_(file_name), handlers_(handlers) {}

  std::size_t line = 1;
  std::optional<Error> error;

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t&) override { return add(value); }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t&) override { return refuse("binary data"); }
  bool start_object(std::size_t) override {
    if (depth_ == 0) return ++depth_, true;
    return open(Json::object());
  }
  bool end_object() override {
    if (depth_ == 1) return depth_ = 0, true;
    return close();
  }
  bool start_array(std::size_t) override {
    if (depth_ != 1) return open(Json::array());
    depth_ = 2;
    if (!deliver(Json::array())) return false;
    in_list_ = true;
    index_ = 0;
    return true;
  }
  bool end_array() override {
    if (in_list_ && open_.empty()) {
      depth_ = 1;
      in_list_ = false;
      return true;
    }
    return close();
  }
  bool key(string_t& name) override {
    (open_.empty() ? field_ : key_) = name;
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& exception) override {
    return refuse("not valid JSON: " + reason_of(exception));
  }

 private:
  bool refuse(const std::string& message, ErrorCode code = ErrorCode::Malformed) {
    if (!error)
      error = Error{code, std::string(file_name_) + ":" + std::to_string(line) + ": " + one_line(message)};
    return false;
  }
  bool handed_over(const Result<void>& answer) {
    return answer ? true : refuse(answer.error().message, answer.error().code);
  }

  // A finished value goes to its container, or to the handlers when it is a whole piece.
  bool add(Json value) {
    if (depth_ == 0) return refuse("the file is no JSON object");
    if (!open_.empty()) {
      Json& container = *open_.back();
      if (container.is_array())
        container.push_back(std::move(value));
      else
        container[key_] = std::move(value);
      return true;
    }
    return deliver(value);
  }
  bool open(Json container) {
    if (depth_ == 0) return refuse("the file is no JSON object");
    if (depth_ >= kDeepest) return refuse("values are nested more than 16 deep");
    ++depth_;
    if (open_.empty()) {
      piece_ = std::move(container);
      open_.push_back(&piece_);
    } else if (open_.back()->is_array()) {
      open_.back()->push_back(std::move(container));
      open_.push_back(&open_.back()->back());
    } else {
      Json& slot = (*open_.back())[key_];
      slot = std::move(container);
      open_.push_back(&slot);
    }
    return true;
  }
  bool close() {
    POSECOACH_ASSERT(!open_.empty());
    --depth_;
    open_.pop_back();
    return open_.empty() ? deliver(piece_) : true;
  }
  bool deliver(const Json& piece) {
    const auto& handler = in_list_ ? handlers_.on_element : handlers_.on_field;
    return handed_over(handler ? handler({field_, in_list_ ? index_++ : 0, line, piece}) : Result<void>());
  }

  std::string_view file_name_;
  const JsonHandlers& handlers_;
  std::size_t depth_ = 0;  // 1: in the top-level object, 2: in one of its arrays
  bool in_list_ = false;
  std::size_t index_ = 0;
  std::string field_, key_;
  Json piece_;
  std::vector<Json*> open_;
};

tl::unexpected<Error> needs(std::string_view key, const char* what) {
  return fail(ErrorCode::Malformed, "\"" + std::string(key) + "\" needs " + what);
}

bool is_usable(const Json& value) {
  return value.is_number() && std::abs(value.get<double>()) <= kLargestNumber;
}

}  // namespace

Result<void> walk_json(std::string_view file_name, std::string_view text, const JsonHandlers& handlers) {
  Walker walker(file_name, handlers);
  try {
    const CountingIterator begin(text.data(), &walker.line), end(text.data() + text.size(), &walker.line);
    Json::sax_parse(begin, end, &walker);
  } catch (const std::exception& exception) {
    if (!walker.error)
      walker.error = Error{ErrorCode::Malformed, std::string(file_name) + ":" + std::to_string(walker.line) +
                                                     ": " + reason_of(exception)};
  }
  if (walker.error) return tl::unexpected(*walker.error);
  return {};
}

Result<double> json_number(const Json& object, std::string_view key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  if (found == object.end() || !is_usable(*found)) return needs(key, "a number");
  return found->get<double>();
}

Result<std::string> json_string(const Json& object, std::string_view key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  if (found == object.end() || !found->is_string()) return needs(key, "a text");
  return found->get<std::string>();
}

Result<void> json_numbers(const Json& array, double* out, std::size_t size, std::string_view what) {
  if (!array.is_array() || array.size() != size || !std::all_of(array.begin(), array.end(), is_usable))
    return fail(ErrorCode::Malformed, std::string(what) + " needs " + std::to_string(size) + " numbers");
  for (std::size_t i = 0; i < size; ++i) out[i] = array[i].get<double>();
  return {};
}

Result<Vec3> json_vector(const Json& object, std::string_view key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  double values[3];
  if (found == object.end()) return needs(key, "3 numbers");
  if (const auto read = json_numbers(*found, values, 3, "\"" + std::string(key) + "\""); !read)
    return tl::unexpected(read.error());
  return Vec3(values[0], values[1], values[2]);
}

std::string json_quoted(std::string_view text) {
  return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

void append_json_number(std::string& out, double value, int decimals) {
  POSECOACH_ASSERT(std::isfinite(value) && std::abs(value) <= kLargestNumber);
  char text[64];
  const auto [end, error] =
      std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, decimals);
  POSECOACH_ASSERT(error == std::errc{});
  std::string_view number(text, static_cast<std::size_t>(end - text));
  if (decimals > 0) {
    number = number.substr(0, number.find_last_not_of('0') + 1);
    if (number.ends_with('.')) number.remove_suffix(1);
  }
  out += number == "-0" ? "0" : number;
}

}  // namespace posecoach
