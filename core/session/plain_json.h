// The plain JSON files of the session folder: an object whose unknown keys survive being read and written
// again by this program, so that a newer version's fields are never lost.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace posecoach {

// Keeps the order of the top-level keys.
using PlainJson = nlohmann::ordered_json;

// Errors: those of read_file, Malformed with file and line.
Result<PlainJson> read_plain_json(const std::filesystem::path& path);
Result<PlainJson> parse_plain_json(std::string_view file_name, std::string_view text);
std::string to_text(const PlainJson& json);

// Reads the fields of one object, of which every one may be missing; remembers the first that is there but of
// the wrong kind.
class PlainFields {
 public:
  PlainFields(const PlainJson& object, std::string_view file_name) : object_(object), file_name_(file_name) {}

  void read(const char* key, std::string& out);
  void read(const char* key, bool& out);
  void read(const char* key, double& out);
  void read(const char* key, std::optional<double>& out);
  void read(const char* key, int& out);
  void read(const char* key, std::uint64_t& out);
  // The place among `words`.
  std::optional<std::size_t> choice(const char* key, std::initializer_list<std::string_view> words);
  // A nested object; an empty one where it is missing.
  PlainJson object(const char* key);

  // Malformed: "FILE: "KEY" needs ...".
  Result<void> checked() const;
  void complain(const char* key, const std::string& needs);

 private:
  const PlainJson* find(const char* key) const;

  const PlainJson& object_;
  std::string file_name_;
  std::optional<Error> error_;
};

// "posecoach.NAME/1": 1. Errors: Malformed (another name), Unsupported (made by a newer version).
Result<int> schema_version(const PlainJson& json, std::string_view name, int newest,
                           std::string_view file_name);

}  // namespace posecoach
