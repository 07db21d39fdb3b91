// Names in an error message that has to fit on one line.
#pragma once

#include <algorithm>
#include <span>
#include <string>

namespace posecoach {

// "a, b, c"; of more than `most` names the first ones and how many there are besides: "a, b and 52 more".
inline std::string short_list(std::span<const std::string> names, std::size_t most) {
  std::string text;
  const std::size_t listed = std::min(most, names.size());
  for (std::size_t i = 0; i < listed; ++i) text += (i == 0 ? "" : ", ") + names[i];
  if (listed < names.size()) text += " and " + std::to_string(names.size() - listed) + " more";
  return text;
}

}  // namespace posecoach
