#include <algorithm>
#include <cctype>
#include <map>

#include "core/motion/rig.h"

namespace posecoach {
namespace {

using Words = std::vector<std::string>;

bool is_upper(char c) {
  return c >= 'A' && c <= 'Z';
}
bool is_lower(char c) {
  return c >= 'a' && c <= 'z';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// "LHipJoint" -> l hip joint; "thigh_l" -> thigh l; "Spine1" -> spine 1.
Words split_into_words(std::string_view name) {
  Words words;
  char previous = '\0';
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    const bool alphanumeric = is_upper(c) || is_lower(c) || is_digit(c);
    if (alphanumeric) {
      const char next = i + 1 < name.size() ? name[i + 1] : '\0';
      const bool begins = previous == '\0' || is_digit(c) != is_digit(previous) ||
                          (is_upper(c) && (is_lower(previous) || (is_upper(previous) && is_lower(next))));
      if (begins) words.emplace_back();
      words.back() += is_upper(c) ? static_cast<char>(c - 'A' + 'a') : c;
    }
    previous = alphanumeric ? c : '\0';
  }
  return words;
}

std::optional<Side> side_from_word(std::string_view word) {
  if (word == "left" || word == "l" || word == "lft" || word == "lt") return Side::Left;
  if (word == "right" || word == "r" || word == "rgt" || word == "rt") return Side::Right;
  return std::nullopt;
}

std::string_view without_namespace(std::string_view name) {
  const std::size_t colon = name.find_last_of(":|");
  return colon == std::string_view::npos || colon + 1 == name.size() ? name : name.substr(colon + 1);
}

void drop_common_prefix(std::vector<Words>& names) {
  constexpr int kLongestPrefix = 3;
  for (int round = 0; round < kLongestPrefix && names.size() >= 5; ++round) {
    std::map<std::string, std::size_t> firsts;
    for (const Words& words : names)
      if (words.size() > 1) ++firsts[words.front()];
    const auto common = std::max_element(firsts.begin(), firsts.end(),
                                         [](const auto& a, const auto& b) { return a.second < b.second; });
    if (common == firsts.end() || common->second * 5 < names.size() * 4 || side_from_word(common->first))
      return;
    const std::string prefix = common->first;
    for (Words& words : names)
      if (words.size() > 1 && words.front() == prefix) words.erase(words.begin());
  }
}

RigName rig_name_from_words(const Words& words) {
  RigName name;
  for (const std::string& word : words) {
    const auto side = side_from_word(word);
    if (side && name.side == Side::Middle && words.size() > 1)
      name.side = *side;
    else
      name.base += word;
  }
  return name;
}

}  // namespace

std::vector<RigName> parse_rig_names(std::span<const std::string_view> names) {
  std::vector<Words> words;
  for (const std::string_view name : names) words.push_back(split_into_words(without_namespace(name)));
  drop_common_prefix(words);
  std::vector<RigName> parsed;
  for (const Words& of_one : words) parsed.push_back(rig_name_from_words(of_one));
  return parsed;
}

}  // namespace posecoach
