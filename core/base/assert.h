// A broken invariant of our own code ends the program with the place; on in every build.
#pragma once

namespace posecoach {
[[noreturn]] void assertion_failed(const char* condition, const char* file, int line);
}

#define POSECOACH_ASSERT(condition) \
  ((condition) ? static_cast<void>(0) : ::posecoach::assertion_failed(#condition, __FILE__, __LINE__))
