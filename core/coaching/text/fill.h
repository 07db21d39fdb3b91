// A sentence with its blanks filled in. Sentences are whole, so that a translation may put their parts in its
// own order: "{When}, your head is {size} too high."
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace posecoach::text {

using Blanks = std::vector<std::pair<std::string_view, std::string>>;
// Asserts that every blank of the sentence is filled.
std::string filled(std::string_view sentence, const Blanks& blanks);

// With `digits` after the point, whatever the locale; sizes without a sign.
std::string number(double value, int digits);
std::string centimetres(double metres);  // "8 cm"
std::string degrees(double value);       // "24°"
std::string percent(double part);        // of 1: "18 %"

}  // namespace posecoach::text
