#include "core/session/plain_json.h"

#include <charconv>
#include <cmath>

#include "core/base/file.h"
#include "core/base/json_text.h"

namespace posecoach {
namespace {

constexpr std::size_t kLargestBytes = std::size_t{1} << 22;
constexpr double kLargestNumber = 1e12;

}  // namespace

Result<PlainJson> read_plain_json(const std::filesystem::path& path) {
  const Result<std::string> text = read_file(path, kLargestBytes);
  if (!text) return tl::unexpected(text.error());
  return parse_plain_json(path.string(), *text);
}

Result<PlainJson> parse_plain_json(std::string_view file_name, std::string_view text) {
  PlainJson json = PlainJson::object();
  JsonHandlers handlers;
  handlers.on_field = [&](const JsonPiece& piece) -> Result<void> {
    json[std::string(piece.key)] = piece.value;
    return {};
  };
  handlers.on_element = [&](const JsonPiece& piece) -> Result<void> {
    json[std::string(piece.key)].push_back(PlainJson(piece.value));
    return {};
  };
  if (const Result<void> walked = walk_json(file_name, text, handlers); !walked)
    return tl::unexpected(walked.error());
  return json;
}

std::string to_text(const PlainJson& json) {
  return json.dump(2, ' ', false, PlainJson::error_handler_t::replace) + "\n";
}

const PlainJson* PlainFields::find(const char* key) const {
  if (!object_.is_object()) return nullptr;
  const auto found = object_.find(key);
  return found == object_.end() || found->is_null() ? nullptr : &*found;
}

void PlainFields::complain(const char* key, const std::string& needs) {
  if (!error_)
    error_ = Error{ErrorCode::Malformed, one_line(file_name_ + ": \"" + key + "\" needs " + needs)};
}

Result<void> PlainFields::checked() const {
  if (error_) return tl::unexpected(*error_);
  return {};
}

void PlainFields::read(const char* key, std::string& out) {
  const PlainJson* value = find(key);
  if (value == nullptr) return;
  if (!value->is_string()) return complain(key, "a text");
  out = value->get<std::string>();
}

void PlainFields::read(const char* key, bool& out) {
  const PlainJson* value = find(key);
  if (value == nullptr) return;
  if (!value->is_boolean()) return complain(key, "true or false");
  out = value->get<bool>();
}

void PlainFields::read(const char* key, double& out) {
  const PlainJson* value = find(key);
  if (value == nullptr) return;
  if (!value->is_number() || !(std::abs(value->get<double>()) <= kLargestNumber))
    return complain(key, "a number");
  out = value->get<double>();
}

void PlainFields::read(const char* key, std::optional<double>& out) {
  if (find(key) == nullptr) return;
  double number = 0;
  read(key, number);
  out = number;
}

void PlainFields::read(const char* key, int& out) {
  if (find(key) == nullptr) return;
  double number = 0;
  read(key, number);
  if (std::abs(number) > 1e9) return complain(key, "a smaller number");
  out = static_cast<int>(std::lround(number));
}

void PlainFields::read(const char* key, std::uint64_t& out) {
  if (find(key) == nullptr) return;
  double number = 0;
  read(key, number);
  if (number < 0) return complain(key, "a number of at least 0");
  out = static_cast<std::uint64_t>(number);
}

std::optional<std::size_t> PlainFields::choice(const char* key,
                                               std::initializer_list<std::string_view> words) {
  if (find(key) == nullptr) return {};
  std::string word, list;
  read(key, word);
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (word == words.begin()[i]) return i;
    list += (i == 0 ? "" : " or ") + std::string(words.begin()[i]);
  }
  complain(key, list);
  return {};
}

PlainJson PlainFields::object(const char* key) {
  const PlainJson* value = find(key);
  if (value == nullptr) return PlainJson::object();
  if (value->is_object()) return *value;
  complain(key, "an object");
  return PlainJson::object();
}

Result<int> schema_version(const PlainJson& json, std::string_view name, int newest,
                           std::string_view file_name) {
  const std::string file(file_name), start = "posecoach." + std::string(name) + "/";
  const auto found = json.find("schema");
  const std::string schema = found != json.end() && found->is_string() ? found->get<std::string>() : "";
  int version = 0;
  const char* end = schema.data() + schema.size();
  if (schema.starts_with(start)) {
    const auto [at, error] = std::from_chars(schema.data() + start.size(), end, version);
    if (error != std::errc{} || at != end) version = 0;
  }
  if (version < 1)
    return fail(ErrorCode::Malformed, file + ": \"schema\" needs " + start + std::to_string(newest));
  if (version > newest)
    return fail(ErrorCode::Unsupported,
                file + ": made by a newer version of this program (" + schema + "); update the program");
  return version;
}

}  // namespace posecoach
