// Reads JSON files piece by piece: the fields of the top-level object and the elements of its arrays come one
// at a time and are forgotten again, so that a long file takes little memory, and every complaint about one
// of them names file and line.
#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/base/math.h"

namespace posecoach {

// A field of the top-level object, or an element of an array that is such a field.
struct JsonPiece {
  std::string_view key;   // of the field
  std::size_t index = 0;  // of the element
  std::size_t line = 0;   // where the piece ends, from 1
  const nlohmann::json& value;
};

// What the handlers return as an error gets "file:line: " in front.
struct JsonHandlers {
  std::function<Result<void>(const JsonPiece&)> on_field;  // an array comes empty, before its elements
  std::function<Result<void>(const JsonPiece&)> on_element;
};

// Errors: Malformed (no JSON, no object at the top, nested more than 16 deep), those of the handlers.
Result<void> walk_json(std::string_view file_name, std::string_view text, const JsonHandlers& handlers);

// Values of a piece; errors (Malformed) name the key. Numbers are finite and below 1e12 in size.
Result<double> json_number(const nlohmann::json& object, std::string_view key);
Result<std::string> json_string(const nlohmann::json& object, std::string_view key);
// An array of `size` numbers.
Result<void> json_numbers(const nlohmann::json& array, double* out, std::size_t size, std::string_view what);
Result<Vec3> json_vector(const nlohmann::json& object, std::string_view key);

// Text as a JSON string in quotation marks; bytes that are no UTF-8 are replaced.
std::string json_quoted(std::string_view text);
// Up to `decimals` digits after the point, without trailing zeros.
void append_json_number(std::string& out, double value, int decimals);

}  // namespace posecoach
