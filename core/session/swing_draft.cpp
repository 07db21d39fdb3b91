#include "core/session/swing_draft.h"

#include "core/base/file.h"
#include "core/body/body_file.h"
#include "core/coaching/analysis_json.h"
#include "core/motion/pose_file.h"

namespace posecoach {

SwingDraft::SwingDraft(Disk& disk, DraftFolder folder, SwingFacts facts)
    : disk_(&disk), place_(std::move(folder)), facts_(std::move(facts)) {}

Result<void> SwingDraft::add(std::string_view name, std::string_view bytes) {
  return store_file(*disk_, path(name), bytes);
}

Result<void> SwingDraft::add_copy(std::string_view name, const std::filesystem::path& from,
                                  const Progress& progress) {
  std::error_code failed;
  if (std::filesystem::exists(path(name), failed) && disk_->remove(path(name).c_str()) != 0)
    return tl::unexpected(disk_error("replace", path(name)));
  return copy_file(*disk_, from, path(name), progress);
}

Result<void> SwingDraft::add_track(const PoseTrack& track) {
  return add("pose.pose.json", pose_json_from_track(track));
}

Result<void> SwingDraft::add_student(const Motion& student, std::string_view source) {
  return add("student.pose.json", pose_json_from_motion(student, source));
}

Result<void> SwingDraft::add_body(const Skeleton& body) {
  return add("student.body.json", body_to_json(body));
}

Result<void> SwingDraft::add_coach(const Motion& coach_in_student_body, std::string_view source) {
  return add("coach.pose.json", pose_json_from_motion(coach_in_student_body, source));
}

Result<void> SwingDraft::add_analysis(const Analysis& analysis) {
  facts_.coach = analysis.coach.source;
  facts_.stroke = analysis.stroke;
  if (analysis.student.hand) facts_.hand = analysis.student.hand;
  facts_.seconds = analysis.student.seconds;
  facts_.frames = analysis.student.frames;
  facts_.score_percent = analysis.score.percent;
  facts_.score_plus_minus = analysis.score.plus_minus;
  facts_.advice = analysis.advice.empty() ? "" : analysis.advice.front().text;
  return add("analysis.json", to_json(analysis));
}

Result<void> SwingDraft::add_thumbnail(std::string_view jpeg) {
  return add("thumb.jpg", jpeg);
}

Result<void> SwingDraft::describe(const SwingFacts& facts) {
  facts_ = facts;
  Swing swing;
  swing.facts = facts;
  return add(kSwingFile, swing_to_json(swing, read_file(path(kSwingFile)).value_or("")));
}

}  // namespace posecoach
