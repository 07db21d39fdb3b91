#include "core/base/json_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <vector>

namespace posecoach {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

std::vector<std::string> pieces_of(std::string_view text) {
  std::vector<std::string> pieces;
  JsonHandlers handlers;
  handlers.on_field = [&](const JsonPiece& piece) -> Result<void> {
    pieces.push_back(std::string(piece.key) + "=" + piece.value.dump());
    return {};
  };
  handlers.on_element = [&](const JsonPiece& piece) -> Result<void> {
    pieces.push_back(std::string(piece.key) + "[" + std::to_string(piece.index) + "]@" +
                     std::to_string(piece.line) + "=" + piece.value.dump());
    return {};
  };
  EXPECT_TRUE(walk_json("a.json", text, handlers));
  return pieces;
}

void expect_refused(std::string_view text, const std::string& where, const std::string& what) {
  const auto walked = walk_json("a.json", text, {});
  ASSERT_FALSE(walked);
  EXPECT_EQ(walked.error().code, ErrorCode::Malformed);
  EXPECT_THAT(walked.error().message, StartsWith("a.json:" + where));
  EXPECT_THAT(walked.error().message, HasSubstr(what));
  EXPECT_EQ(walked.error().message.find('\n'), std::string::npos);
}

TEST(JsonText, fields_and_elements_come_one_by_one) {
  EXPECT_THAT(pieces_of("{\"a\": 1, \"b\": {\"c\": [1, {\"d\": null}]},\n \"list\": [1,\n [2, 3],\n {\"x\": "
                        "[]}], \"z\": true}"),
              ElementsAre("a=1", "b={\"c\":[1,{\"d\":null}]}", "list=[]", "list[0]@2=1", "list[1]@3=[2,3]",
                          "list[2]@4={\"x\":[]}", "z=true"));
}

TEST(JsonText, broken_text_is_one_line_with_file_and_line) {
  expect_refused("", "1", "not valid JSON");
  expect_refused("[1, 2]", "1", "no JSON object");
  expect_refused("7", "1", "no JSON object");
  expect_refused("{\"a\": 1,\n\"b\": }", "2", "not valid JSON");
  expect_refused("{\"a\": 1}\n\nrest", "3", "not valid JSON");
  expect_refused("{\"a\": 1e999}", "1", "");
  expect_refused("{\"a\": \"\xff\"}", "1", "not valid JSON");
  expect_refused("{\"a\": " + std::string(40, '[') + "}", "1", "nested more than 16 deep");
  expect_refused("{\"a\": " + std::string(100000, '['), "1", "nested more than 16 deep");
}

TEST(JsonText, a_handler_s_complaint_gets_file_and_line) {
  JsonHandlers handlers;
  handlers.on_element = [](const JsonPiece& piece) -> Result<void> {
    double numbers[2];
    return json_numbers(piece.value, numbers, 2, "a point");
  };
  const auto walked = walk_json("a.json", "{\"points\": [\n[1, 2],\n[1, \"x\"],\n[3, 4]]}", handlers);
  ASSERT_FALSE(walked);
  EXPECT_EQ(walked.error().message, "a.json:3: a point needs 2 numbers");
}

TEST(JsonText, numbers_are_written_short_and_exact) {
  std::string out;
  for (const double value : {1.5, 0.0, -0.00001, 100.0, -12.3456789}) {
    append_json_number(out, value, 4);
    out += ' ';
  }
  EXPECT_EQ(out, "1.5 0 0 100 -12.3457 ");
}

TEST(JsonText, foreign_bytes_are_quoted_as_valid_text) {
  EXPECT_TRUE(nlohmann::json::accept(json_quoted("caf\xe9 \"\n")));
}

}  // namespace
}  // namespace posecoach
