// Pieces of HTML: text made harmless, numbers, pictures inside the page.
#pragma once

#include <string>
#include <string_view>

#include "core/image/frame.h"

namespace posecoach::html {

// For text and for attributes in double quotes; bytes that are not UTF-8 become replacement signs.
std::string escape(std::string_view text);

// A JavaScript string with its quotes, harmless inside a script element.
std::string script_string(std::string_view text);

// "data:image/jpeg;base64,...".
std::string jpeg_uri(const Image& image);

std::string base64(std::string_view bytes);

}  // namespace posecoach::html
