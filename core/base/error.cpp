#include "core/base/error.h"

namespace posecoach {

std::string one_line(std::string message) {
  for (char& c : message)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7F') c = '?';
  return message;
}

std::string_view to_string(ErrorCode code) {
  switch (code) {
    case ErrorCode::NotFound:
      return "not found";
    case ErrorCode::Unreadable:
      return "unreadable";
    case ErrorCode::Malformed:
      return "malformed";
    case ErrorCode::Unsupported:
      return "unsupported";
    case ErrorCode::InvalidArgument:
      return "invalid argument";
    case ErrorCode::NoPerson:
      return "no person";
    case ErrorCode::Incomplete:
      return "incomplete";
    case ErrorCode::DeviceLost:
      return "device lost";
    case ErrorCode::Cancelled:
      return "cancelled";
    case ErrorCode::Internal:
      return "internal";
  }
  return "unknown";
}

}  // namespace posecoach
