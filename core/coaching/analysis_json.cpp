#include "core/coaching/analysis_json.h"

#include <nlohmann/json.hpp>

namespace posecoach {
namespace {

using Json = nlohmann::ordered_json;

Json json_from(const MotionSummary& motion) {
  Json json{{"source", motion.source},
            {"frames", motion.frames},
            {"seconds", motion.seconds},
            {"joints", motion.joints}};
  if (motion.hand) json["hand"] = *motion.hand == Handedness::Left ? "left" : "right";
  return json;
}

Json json_from(const std::vector<SwingEvent>& events) {
  Json json = Json::array();
  for (const SwingEvent& event : events)
    json.push_back({{"name", event.name}, {"frame", event.frame}, {"time_s", event.time_s}});
  return json;
}

const char* to_string(AdviceKind kind) {
  switch (kind) {
    case AdviceKind::Timing:
      return "timing";
    case AdviceKind::Spatial:
      return "spatial";
    case AdviceKind::None:
      break;
  }
  return "none";
}

Json timing_json(const Analysis& analysis) {
  Json json = Json::array();
  for (const TimingAdvice& t : analysis.timing)
    json.push_back({{"from", t.from},
                    {"to", t.to},
                    {"coach_s", t.coach_s},
                    {"student_s", t.student_s},
                    {"ratio", t.ratio},
                    {"plus_minus", t.plus_minus},
                    {"path_ratio", t.path_ratio},
                    {"fault", t.fault},
                    {"advice", t.advice}});
  return json;
}

Json parts_json(const std::vector<PartScore>& parts) {
  Json json = Json::array();
  for (const PartScore& part : parts)
    json.push_back(
        {{"name", part.name}, {"mean_joint_error_m", part.mean_joint_error_m}, {"percent", part.percent}});
  return json;
}

Json gaps_json(const std::vector<JointGap>& gaps) {
  Json json = Json::array();
  for (const JointGap& gap : gaps)
    json.push_back({{"joint", gap.joint},
                    {"offset_m", {gap.offset_m.x, gap.offset_m.y, gap.offset_m.z}},
                    {"distance_m", gap.distance_m}});
  return json;
}

Json poses_json(const Analysis& analysis) {
  Json json = Json::array();
  for (const PoseMatch& match : analysis.poses)
    json.push_back({{"event", match.event},
                    {"student_frame", match.student_frame},
                    {"coach_frame", match.coach_frame},
                    {"student_s", match.student_s},
                    {"coach_s", match.coach_s},
                    {"late_s", match.late_s},
                    {"apart_m", match.apart_m},
                    {"joints", gaps_json(match.joints)},
                    {"advice", match.advice}});
  return json;
}

Json spatial_json(const Analysis& analysis) {
  Json json = Json::array();
  for (const SpatialAdvice& s : analysis.spatial)
    json.push_back({{"joint", s.joint},
                    {"event", s.event},
                    {"student_frame", s.student_frame},
                    {"coach_frame", s.coach_frame},
                    {"offset_m", {s.offset_m.x, s.offset_m.y, s.offset_m.z}},
                    {"distance_m", s.distance_m},
                    {"turn_deg", s.turn_deg},
                    {"share", s.share},
                    {"measure", s.measure},
                    {"amount", s.amount},
                    {"fault", s.fault},
                    {"advice", s.advice}});
  return json;
}

Json metrics_json(const Analysis& analysis) {
  Json json = Json::array();
  for (const Metric& m : analysis.metrics) {
    Json metric{
        {"name", m.name}, {"title", m.title},         {"value", m.value},   {"plus_minus", m.plus_minus},
        {"unit", m.unit}, {"available", m.available}, {"reason", m.reason}, {"definition", m.definition}};
    if (!m.available) metric["value"] = nullptr;
    if (m.coach) metric["coach"] = *m.coach;
    if (m.usual) metric["usual"] = {m.usual->first, m.usual->second};
    if (!m.source.empty()) metric["source"] = m.source;
    if (!m.words.empty()) metric["words"] = m.words;
    json.push_back(std::move(metric));
  }
  return json;
}

}  // namespace

std::string to_json(const Analysis& analysis) {
  Json json;
  json["schema"] = "posecoach.analysis/1";
  json["coach"] = json_from(analysis.coach);
  json["student"] = json_from(analysis.student);
  json["stroke"] = analysis.stroke;
  json["retarget"] = {{"method", analysis.retarget_method},
                      {"bone_length_error_max", analysis.bone_length_error_max},
                      {"contacts", analysis.contacts},
                      {"grip_error_p95_m", analysis.grip_error_p95_m},
                      {"reach_deficit_max_m", analysis.reach_deficit_max_m}};
  json["score"] = {{"raw", analysis.score.raw},
                   {"mean_joint_error_m", analysis.score.mean_joint_error_m},
                   {"percent", analysis.score.percent},
                   {"plus_minus", analysis.score.plus_minus},
                   {"joints_compared", analysis.score.joints_compared},
                   {"groups", parts_json(analysis.score.groups)},
                   {"phases", parts_json(analysis.score.phases)}};
  json["path"] = analysis.path;
  json["path_error_m"] = analysis.path_error_m;
  json["events"] = {{"student", json_from(analysis.student_events)},
                    {"coach", json_from(analysis.coach_events)}};
  json["takeaway_s"] = {{"student", analysis.student_takeaway_s}, {"coach", analysis.coach_takeaway_s}};
  json["poses"] = poses_json(analysis);
  json["timing"] = timing_json(analysis);
  json["spatial"] = spatial_json(analysis);
  json["joint_errors"] = Json::array();
  for (const JointError& e : analysis.joint_errors)
    json["joint_errors"].push_back({{"joint", e.joint}, {"mean_m", e.mean_m}, {"max_m", e.max_m}});
  json["worst_frames"] = Json::array();
  for (const FramePair& p : analysis.worst_frames)
    json["worst_frames"].push_back({{"student_frame", p.student_frame},
                                    {"coach_frame", p.coach_frame},
                                    {"mean_error_m", p.mean_error_m},
                                    {"joints", gaps_json(p.joints)}});
  json["metrics"] = metrics_json(analysis);
  json["advice"] = Json::array();
  for (const Advice& a : analysis.advice)
    json["advice"].push_back({{"kind", to_string(a.kind)},
                              {"text", a.text},
                              {"fault", a.fault},
                              {"measure", a.measure},
                              {"event", a.event},
                              {"amount", a.amount},
                              {"severity", a.severity},
                              {"student_frame", a.student_frame},
                              {"coach_frame", a.coach_frame}});
  json["notes"] = analysis.notes;
  return json.dump(2) + "\n";
}

}  // namespace posecoach
