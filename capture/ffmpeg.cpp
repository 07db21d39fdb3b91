#include "capture/ffmpeg.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/error.h>
#include <libavutil/log.h>
#include <libswscale/swscale.h>
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

void FfmpegFree::operator()(AVCodecContext* context) const {
  avcodec_free_context(&context);
}
void FfmpegFree::operator()(AVFrame* frame) const {
  av_frame_free(&frame);
}
void FfmpegFree::operator()(AVPacket* packet) const {
  av_packet_free(&packet);
}
void FfmpegFree::operator()(SwsContext* context) const {
  sws_freeContext(context);
}
void FfmpegCloseInput::operator()(AVFormatContext* input) const {
  avformat_close_input(&input);
}

}  // namespace posecoach
