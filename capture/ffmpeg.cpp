#include "capture/ffmpeg.h"

extern "C" {
#include <libavutil/error.h>
#include <libavutil/log.h>
}

#include <cstdarg>

namespace posecoach {

void keep_ffmpeg_quiet() {
  av_log_set_callback([](void*, int, const char*, std::va_list) {});
}

std::string ffmpeg_reason(int error) {
  char text[AV_ERROR_MAX_STRING_SIZE] = {};
  return av_strerror(error, text, sizeof text) == 0 ? text : "error " + std::to_string(error);
}

}  // namespace posecoach
