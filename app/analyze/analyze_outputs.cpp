#include "app/analyze/analyze_outputs.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#include "app/output_check.h"
#include "capture/open_source.h"
#include "capture/video_writer.h"
#include "core/base/atomic_file.h"
#include "core/base/file.h"
#include "core/coaching/analysis_json.h"
#include "core/coaching/body_axes.h"
#include "core/coaching/posture.h"
#include "core/image/image_codec.h"
#include "ui/render/egl_context.h"
#include "ui/report/motion_stills.h"
#include "ui/report/overlay_film.h"
#include "ui/report/report_page.h"

namespace posecoach {
namespace {

// Where there is no film, the bodies are filmed on a plain ground.
constexpr int kPlainWidth_px = 960, kPlainHeight_px = 960;
constexpr double kPlainFrames_hz = 60;
constexpr std::uint8_t kPlainGrey = 235;
constexpr double kCameraDistance_m = 4.4, kCameraHeight_m = 1.15, kAimHeight_m = 0.95;
constexpr double kViewAngle_deg = 30;
// Films are drawn at most this large: larger ones cost gigabytes to encode and show no more of a swing.
constexpr int kLongestSide_px = 1920;

// The pictures to draw over: the student's film again, or plain ones at the motion's times.
struct Pictures {
  PinholeCamera camera;
  NextFrame next;
  double frames_per_second = 30;
  std::optional<std::filesystem::path> sound_from;
};

Result<Pictures> film_pictures(const LoadedMotion& student) {
  Result<std::unique_ptr<FrameSource>> opened = open_source(student.source);
  if (!opened) return tl::unexpected(opened.error());
  const std::shared_ptr<FrameSource> film = *std::move(opened);
  const PinholeCamera& camera = student.student->lifted.camera;
  const double factor =
      std::min(1.0, static_cast<double>(kLongestSide_px) / std::max(camera.width_px, camera.height_px));
  const PinholeCamera drawn = scaled(camera, factor);
  const NextFrame next = [film, drawn]() -> Result<std::optional<Frame>> {
    Result<std::optional<Frame>> frame = film->next({});
    if (frame && *frame &&
        ((*frame)->image->width > drawn.width_px || (*frame)->image->height > drawn.height_px))
      (*frame)->image = std::make_shared<Image>(resized(*(*frame)->image, drawn.width_px, drawn.height_px));
    return frame;
  };
  Pictures pictures{drawn, next, film->info().nominal_fps, {}};
  if (std::filesystem::is_regular_file(student.source)) pictures.sound_from = student.source;
  return pictures;
}

PinholeCamera plain_camera(const Motion& motion, double address_s) {
  const JointTrack track = JointTrack::from_motion(motion).value();
  const BodyAxes axes = body_axes(track, address_s, address_s);
  const int frame = track.nearest_frame(address_s);
  Vec3 feet = middle_of(track, frame, HumanoidJoint::LeftAnkle, HumanoidJoint::RightAnkle);
  const double scale = glm::distance(middle_of_shoulders(track, frame), feet) / 1.3;
  feet.y = std::min(track.position(frame, HumanoidJoint::LeftAnkle).y,
                    track.position(frame, HumanoidJoint::RightAnkle).y);
  const Vec3 eye = feet + scale * (kCameraDistance_m * axes.front + kCameraHeight_m * axes.up);
  return make_camera_looking_at(eye, feet + scale * kAimHeight_m * axes.up,
                                radians_from_degrees(kViewAngle_deg), kPlainWidth_px, kPlainHeight_px);
}

Pictures plain_pictures(const Motion& motion, const Analysis& analysis) {
  auto image = std::make_shared<Image>(Image::black(kPlainWidth_px, kPlainHeight_px));
  std::fill(image->rgb.begin(), image->rgb.end(), kPlainGrey);
  const int step = std::max(1, static_cast<int>(std::lround(motion.frame_rate() / kPlainFrames_hz)));
  auto frame = std::make_shared<int>(0);
  // Lives as long as the motion that it reads from, which the caller keeps.
  const NextFrame next = [&motion, image, step, frame]() -> Result<std::optional<Frame>> {
    if (*frame >= motion.frame_count()) return std::optional<Frame>();
    const Frame now{static_cast<std::size_t>(*frame), motion.time(*frame), {}, image};
    *frame += step;
    return std::optional<Frame>(now);
  };
  const double address_s = analysis.student_events.empty() ? 0 : analysis.student_events.front().time_s;
  return {plain_camera(motion, address_s), next, motion.frame_rate() / step, {}};
}

// The films and the report's stills come from one pass over the pictures.
Result<std::vector<ReportPicture>> draw(const AnalyzeOutputs& outputs, const LoadedMotion& student,
                                        const Comparison& comparison, const Progress& progress) {
  Result<std::unique_ptr<OffscreenContext>> context = make_egl_context();
  if (!context) return tl::unexpected(context.error());
  Result<SceneRenderer> renderer = SceneRenderer::make();
  if (!renderer) return tl::unexpected(renderer.error());
  // A pose file is a student without pictures.
  const bool has_film = student.student && !student.source.ends_with(".json");
  Result<Pictures> pictures =
      has_film ? film_pictures(student) : plain_pictures(student.motion, comparison.analysis);
  if (!pictures) return tl::unexpected(pictures.error());
  if (outputs.video.empty())
    return has_film ? draw_overlay_film(comparison, pictures->camera, *renderer, pictures->next, {}, progress)
                    : draw_motion_stills(comparison, *renderer);

  std::unique_ptr<VideoWriter> writer;
  const FrameSink sink = [&](const Image& image, const Frame& frame) -> Result<void> {
    if (!writer) {
      Result<std::unique_ptr<VideoWriter>> opened =
          VideoWriter::open(outputs.video, {.width = image.width,
                                            .height = image.height,
                                            .nominal_fps = pictures->frames_per_second,
                                            .sound_from = pictures->sound_from});
      if (!opened) return tl::unexpected(opened.error());
      writer = *std::move(opened);
    }
    return writer->write(image, frame.time);
  };
  Result<std::vector<ReportPicture>> stills =
      draw_overlay_film(comparison, pictures->camera, *renderer, pictures->next, sink, progress);
  if (!stills) return stills;
  if (writer)
    if (const Result<void> finished = writer->finish(); !finished) return tl::unexpected(finished.error());
  return has_film ? std::move(stills) : draw_motion_stills(comparison, *renderer);
}

}  // namespace

Result<void> check_outputs(const AnalyzeOutputs& outputs, const std::vector<std::string>& inputs) {
  if (outputs.video == "-" || is_special_file(outputs.video))
    return fail(ErrorCode::InvalidArgument, "--video " + outputs.video + ": a film needs a file");
  return check_output_files({outputs.json, outputs.report, outputs.video}, inputs);
}

Result<void> write_outputs(const AnalyzeOutputs& outputs, const LoadedMotion& student,
                           const AnalyzedPair& pair, const Progress& progress) {
  Comparison comparison{pair.analysis, student.motion, student.first_frame, pair.coach, outputs.palette};
  if (student.student) {
    comparison.drawings = outputs.drawings;
    comparison.drawn_width_px = student.student->track.width;
    comparison.drawn_height_px = student.student->track.height;
  }
  if (!outputs.report.empty() || !outputs.video.empty()) {
    const Result<std::vector<ReportPicture>> pictures = draw(outputs, student, comparison, progress);
    if (!pictures) return tl::unexpected(pictures.error());
    if (!outputs.report.empty())
      if (const Result<void> written =
              write_file_atomically(outputs.report, make_report_page(comparison, *pictures, outputs.block));
          !written)
        return written;
  }
  if (outputs.json.empty()) return {};
  return write_file_atomically(outputs.json, to_json(pair.analysis));
}

}  // namespace posecoach
