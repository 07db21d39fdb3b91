// What every fuzz target has: its entry, and what must hold of every answer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/base/assert.h"
#include "core/base/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace posecoach {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

// One printable line that names the file.
inline void check_error(const Error& error, std::string_view file_name) {
  POSECOACH_ASSERT(error.message.find(file_name) != std::string::npos);
  for (const char c : error.message) POSECOACH_ASSERT(static_cast<unsigned char>(c) >= ' ');
}

}  // namespace posecoach
