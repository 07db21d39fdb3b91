// What went wrong outside the program, as a value. One line that people read; tests check the code.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace posecoach {

enum class ErrorCode {
  NotFound,         // no such file, device, bundled motion
  Unreadable,       // exists, but the system does not let us read or write it
  Malformed,        // contents break the format; the message names file and line or byte
  Unsupported,      // valid, but of a kind that we do not handle
  InvalidArgument,  // an option or value out of its range
  NoPerson,         // nobody is seen in the film
  Incomplete,       // too little in it: no frames, missing joints
  DeviceLost,       // a camera or display vanished
  Cancelled,        // the user interrupted
  Internal          // a library failed in a way that we cannot name better
};

// `message` is one plain sentence without a final newline: what is wrong, where (file and line or byte), and
// what the user can do about it.
struct Error {
  ErrorCode code = ErrorCode::Internal;
  std::string message;
};

template <typename T>
using Result = tl::expected<T, Error>;

// The message with every control character as '?': names from foreign files must not break the line.
std::string one_line(std::string message);

// Usage: `return fail(ErrorCode::Malformed, "swing.bvh:12: a joint needs an OFFSET");`
inline tl::unexpected<Error> fail(ErrorCode code, std::string message) {
  return tl::unexpected<Error>(Error{code, one_line(std::move(message))});
}

std::string_view to_string(ErrorCode code);

}  // namespace posecoach
