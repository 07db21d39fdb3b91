// A file that the build put into the program (posecoach_embed in CMake), as text. Followed by a zero byte
// that does not count.
#pragma once

#include <string_view>

// At namespace scope of a .cpp: defines `std::string_view name()`.
#define POSECOACH_EMBEDDED(name)                                                                            \
  extern "C" const char posecoach_embedded_##name##_begin[];                                                \
  extern "C" const char posecoach_embedded_##name##_end[];                                                  \
  static std::string_view name() {                                                                          \
    return {posecoach_embedded_##name##_begin,                                                              \
            static_cast<std::size_t>(posecoach_embedded_##name##_end - posecoach_embedded_##name##_begin)}; \
  }
