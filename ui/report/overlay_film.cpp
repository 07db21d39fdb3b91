#include "ui/report/overlay_film.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/base/index.h"
#include "ui/render/words.h"

namespace posecoach {
namespace {

constexpr double kStillHeight_px = 560;
constexpr double kDrawingStays_s = 0.5;

// What was drawn by hand, in pixels of this picture.
void add_drawing(Scene& scene, const Drawing& drawing, const Vec2& factor, int height_px) {
  const double unit = std::max(1.0, height_px / 480.0);
  const Colour ink = colour_from_hex(0xFFD84D), edge = colour_from_hex(0x0C1016).with_alpha(0.75F);

  std::vector<Vec2> at;
  for (const Vec2& point : drawing.points_px) at.push_back(point * factor);
  for (const bool is_edge : {true, false})
    for (std::size_t i = 1; i < at.size(); ++i)
      scene.add(make_line(at[i - 1], at[i], (is_edge ? 4.0 : 2.0) * unit, is_edge ? edge : ink));
  if (drawing.kind != DrawingKind::Angle || at.size() != 3) return;
  Text words;
  words.utf8 = decimal(angle_deg(drawing), 0) + "°";
  words.size_px = 15 * unit;
  words.colour = ink;
  words.weight = FontWeight::Bold;
  words.baseline = at[1] + Vec2(16, -14) * unit;
  const double width = text_width_px(words.utf8, words.weight, words.size_px);
  scene.add(
      make_box(words.baseline + Vec2(-7, -16) * unit, Vec2(width + 14 * unit, 22 * unit), 11 * unit, edge));
  scene.add(words);
}

}  // namespace

struct OverlayFilm::Bodies {
  double coach_frame = 0;
  std::vector<double> confidence, coach_confidence;
  std::vector<Vec3> coach;
  BodyState student_state, coach_state;  // look into the vectors above, which a move leaves where they are

  Bodies(const Comparison& comparison, const CoachPlacement& placement, int frame, double at_coach_frame)
      : coach_frame(at_coach_frame),
        confidence(index(comparison.student.joint_count())),
        coach_confidence(index(comparison.coach.joint_count())),
        coach(placement.positions(comparison.coach, at_coach_frame, frame)),
        student_state{comparison.student.skeleton(), comparison.student.positions(frame)},
        coach_state{comparison.coach.skeleton(), {}} {
    for (int joint = 0; joint < comparison.student.joint_count(); ++joint)
      confidence[index(joint)] = comparison.student.confidence(frame, joint);
    // A coach carried over from pictures has joints that nothing is known about.
    const int nearest =
        std::clamp(static_cast<int>(std::lround(at_coach_frame)), 0, comparison.coach.frame_count() - 1);
    for (int joint = 0; joint < comparison.coach.joint_count(); ++joint)
      coach_confidence[index(joint)] = comparison.coach.confidence(nearest, joint) > 0 ? 1 : 0;
    student_state.confidence = confidence;
    coach_state.positions = coach;
    coach_state.confidence = coach_confidence;
  }
  Bodies(Bodies&&) = default;

  bool is_student_seen() const {
    return std::any_of(confidence.begin(), confidence.end(), [](double c) { return c > 0; });
  }
};

OverlayFilm::OverlayFilm(const Comparison& comparison, const PinholeCamera& camera, SceneRenderer& renderer)
    : comparison_(comparison),
      camera_(camera),
      renderer_(renderer),
      story_(make_overlay_story(comparison.analysis, comparison.palette)) {
  POSECOACH_ASSERT(!comparison.analysis.path.empty());
  std::vector<std::pair<int, int>> path = comparison.analysis.path;
  for (auto& [student, coach] : path) student -= comparison.first_frame;
  placement_ = stand_on_feet(comparison.student, comparison.coach, path);
  const auto& errors = comparison.analysis.path_error_m;
  std::vector<std::pair<double, int>> sums(index(comparison.first_frame + comparison.student.frame_count()));
  for (std::size_t i = 0; i < std::min(errors.size(), comparison.analysis.path.size()); ++i) {
    const int frame = comparison.analysis.path[i].first;
    if (frame < 0 || index(frame) >= sums.size()) continue;
    sums[index(frame)].first += errors[i];
    ++sums[index(frame)].second;
  }
  apart_m_.resize(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (sums[i].second > 0) apart_m_[i] = sums[i].first / sums[i].second;
}

std::optional<OverlayFilm::Bodies> OverlayFilm::bodies_at(int motion_frame,
                                                          std::optional<int> coach_frame) const {
  if (motion_frame < 0 || motion_frame >= comparison_.student.frame_count()) return std::nullopt;
  const double at = coach_frame ? *coach_frame : placement_.coach_frame[index(motion_frame)];
  return std::optional<Bodies>(std::in_place, comparison_, placement_, motion_frame, at);
}

OverlayMoment OverlayFilm::moment_at(const Frame& frame, const std::optional<Bodies>& bodies) const {
  const Analysis& analysis = comparison_.analysis;
  const auto film_frame = static_cast<double>(frame.index);
  const auto fraction = [](double value, int frames) { return frames > 1 ? value / (frames - 1) : 0.0; };
  OverlayMoment moment;
  moment.film = frame.image;
  moment.time_s = to_seconds(frame.time);
  moment.student_fraction = fraction(film_frame, analysis.student.frames);
  moment.phase = student_phase(analysis, film_frame);
  if (frame.index < apart_m_.size()) moment.apart_m = apart_m_[frame.index];
  if (bodies && bodies->is_student_seen()) {
    moment.student.emplace(bodies->student_state);
    moment.coach.emplace(bodies->coach_state);
    moment.coach_fraction = fraction(bodies->coach_frame, analysis.coach.frames);
  }
  return moment;
}

Image OverlayFilm::draw(const Frame& frame) {
  const std::optional<Bodies> bodies =
      bodies_at(static_cast<int>(frame.index) - comparison_.first_frame, std::nullopt);
  const PinholeCamera camera = scaled_to(camera_, frame.image->width, frame.image->height);
  Scene scene = make_overlay_scene(story_, moment_at(frame, bodies), camera);
  const Vec2 factor = Vec2(camera.width_px, camera.height_px) /
                      Vec2(std::max(1, comparison_.drawn_width_px), std::max(1, comparison_.drawn_height_px));
  for (const Drawing& drawing : comparison_.drawings)
    if (is_drawing_shown(drawing, frame)) add_drawing(scene, drawing, factor, camera.height_px);
  renderer_.render(scene, camera);
  return renderer_.read_image();
}

// From its picture on for half a second.
bool OverlayFilm::is_drawing_shown(const Drawing& drawing, const Frame& frame) {
  const auto begin = static_cast<std::size_t>(std::max(0, drawing.frame));
  if (frame.index == begin) drawn_at_s_[drawing.frame] = to_seconds(frame.time);
  const auto found = drawn_at_s_.find(drawing.frame);
  return frame.index >= begin && found != drawn_at_s_.end() &&
         to_seconds(frame.time) < found->second + kDrawingStays_s;
}

ReportPicture OverlayFilm::draw_still(const Frame& frame, const StillMoment& still) {
  const std::optional<Bodies> bodies =
      bodies_at(static_cast<int>(frame.index) - comparison_.first_frame, still.coach_frame);
  const OverlayMoment moment = moment_at(frame, bodies);
  const PinholeCamera film_camera = scaled_to(camera_, frame.image->width, frame.image->height);
  std::vector<Vec2> points;
  for (const std::optional<BodyState>& body : {moment.student, moment.coach})
    if (body)
      for (const Vec3& p : body->positions)
        if (const std::optional<Vec2> at = film_camera.project(p)) points.push_back(*at);
  PixelCrop crop = crop_around(points, frame.image->width, frame.image->height);

  const double scale = std::clamp(kStillHeight_px / crop.height, 0.05, 4.0);
  const auto larger = [&](int value) { return static_cast<int>(std::lround(value * scale)); };
  const PinholeCamera camera = scaled_to(film_camera, std::max(8, larger(frame.image->width)),
                                         std::max(8, larger(frame.image->height)));
  std::optional<JointApart> apart;
  std::optional<OverlayHighlight> highlight;
  if (moment.student && moment.coach) {
    const Vec3 into_picture = glm::transpose(camera_.rotation_camera_from_world) * Vec3(0, 0, 1);
    apart = joint_apart(*moment.student, *moment.coach, still.joint, into_picture);
  }
  if (apart) highlight = {apart->student, apart->coach};
  renderer_.render(make_bodies_scene(moment, comparison_.palette, camera, highlight), camera);
  crop = {larger(crop.left), larger(crop.top), larger(crop.width), larger(crop.height)};
  crop.width = std::min(crop.width, camera.width_px - crop.left);
  crop.height = std::min(crop.height, camera.height_px - crop.top);
  return {still.student_frame, still.coach_frame, cut_out(renderer_.read_image(), crop),
          still_caption(moment.phase, apart)};
}

Result<std::vector<ReportPicture>> draw_overlay_film(const Comparison& comparison,
                                                     const PinholeCamera& camera, SceneRenderer& renderer,
                                                     const NextFrame& next, const FrameSink& sink,
                                                     const Progress& progress) {
  OverlayFilm overlay(comparison, camera, renderer);
  const std::vector<StillMoment> moments = still_moments(comparison.analysis);
  std::vector<ReportPicture> stills;
  const double frames = std::max(1, comparison.analysis.student.frames);
  while (sink || stills.size() < moments.size()) {
    Result<std::optional<Frame>> frame = next();
    if (!frame) return tl::unexpected(frame.error());
    if (!*frame) break;
    const Frame& now = **frame;
    // In the order of time, as the moments are.
    while (stills.size() < moments.size() &&
           static_cast<std::size_t>(std::max(0, moments[stills.size()].student_frame)) <= now.index)
      stills.push_back(overlay.draw_still(now, moments[stills.size()]));
    if (sink)
      if (const Result<void> taken = sink(overlay.draw(now), now); !taken)
        return tl::unexpected(taken.error());
    if (!report(progress, "drawing", std::min(1.0, (static_cast<double>(now.index) + 1) / frames)))
      return fail(ErrorCode::Cancelled, "interrupted while drawing the film");
  }
  return stills;
}

}  // namespace posecoach
