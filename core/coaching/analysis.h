// The answer: everything that comparing a student's motion with the coach's (already in the student's own
// body) has to say. Plain values; `to_json` writes the "posecoach.analysis/1" contract, ui/report draws it.
// Frames count the motions as given: student frame = frame of the film, coach frame = frame of the coach's
// motion.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/math.h"
#include "core/base/time.h"
#include "core/body/mirror.h"

namespace posecoach {

// The score of a part of the body, or of a part of the stroke.
struct PartScore {
  std::string name;  // "hips", "trunk", "head", "lead_arm", ...; "backswing", "downswing", "follow_through"
  double mean_joint_error_m = 0;
  double percent = 100;  // the same formula
};

struct Score {
  double raw = 0;  // the paper's §3.4: summed joint position error along the DTW path; lower is better
  double mean_joint_error_m = 0;  // the same per path step and joint
  double percent = 100;           // 0 to 100; formula in docs/SCORE.md
  double plus_minus = 0;          // of percent: what doubt about the student's joints leaves open
  int joints_compared = 0;        // raw = mean_joint_error_m * joints_compared * pairs of the path
  std::vector<PartScore> groups = {}, phases = {};  // phases only where the events are known
};

struct JointError {
  std::string joint;  // canonical name, "left_elbow"
  double mean_m = 0;  // confidence-weighted mean distance along the path
  double max_m = 0;
};

struct SwingEvent {
  std::string name;  // "address", "takeaway", "top", "impact", "finish", ...
  int frame = 0;
  double time_s = 0;  // sub-frame
};

struct TimingAdvice {
  std::string from, to;  // events
  double coach_s = 0, student_s = 0;
  double ratio = 1;  // student_s / coach_s
  std::string advice;
  double plus_minus = 0;   // of the ratio, from frame rates and noise
  double path_ratio = 1;   // student's over coach's time along the path between the same events
  std::string fault = {};  // the name that golfers know for it ("slow_backswing"), if it has one
};

// A joint of both bodies, with the feet at address in one place.
struct JointGap {
  std::string joint;
  Vec3 offset_m;  // as in SpatialAdvice
  double distance_m = 0;
};

// One of the coach's events, and the student's moment that answers it along the path.
struct PoseMatch {
  std::string event;
  int student_frame = 0, coach_frame = 0;
  double student_s = 0, coach_s = 0;  // from each one's takeaway
  double late_s = 0;                  // the difference, at the student's pace; negative is early
  double apart_m = 0;                 // mean joint error then
  std::vector<JointGap> joints;       // that differ most, farthest first; at most three
  std::string advice;
};

struct SpatialAdvice {
  std::string joint, event;
  int student_frame = 0, coach_frame = 0;
  Vec3 offset_m;  // student minus coach, in the coach's facing: +X his left, +Y up, +Z his front
  double distance_m = 0;
  std::string advice;
  double turn_deg = 0;       // where a turn or a bend differs rather than a place: student minus coach
  double share = 0;          // of the joint error at this event that would be gone without it, 0 to 1
  double severity = 0;       // in units of what counts as a clear difference
  std::string measure = {};  // what differs: "hips_to_target", "lead_arm_bend"
  double amount = 0;         // of the measure, student minus coach: metres or degrees
  std::string fault = {};    // the name that golfers know for it ("sway"), if it has one
};

struct Metric {
  std::string name;
  std::string title = {};  // as a heading: "Shoulder turn at the top"
  double value = 0, plus_minus = 0;
  std::string unit;  // "", "deg", "cm", "s", "%"
  bool available = false;
  std::string reason;                                   // why not available
  std::optional<double> coach = {};                     // the same of the coach, in the student's body
  std::string definition = {};                          // one line
  std::optional<std::pair<double, double>> usual = {};  // good golfers', where there are figures
  std::string source = {};                              // of those figures
  std::string words = {};  // what the value says, where it is no quantity: "pelvis, chest, lead arm"
};

// Of a film: where the joints are seen beside the coach's, stage by stage of the stroke, the pelvis in one
// place; leg lengths along a right-hander's left, up and front. Stages: core/coaching/film_error.h.
struct StageGaps {
  Vec3 sight{0, 0, 0};  // where the camera looks, along the same axes
  struct Gap {
    std::string joint;
    int stage = 0;
    Vec3 offset;
  };
  std::vector<Gap> gaps = {};
};

enum class AdviceKind { Timing, Spatial, None };

struct Advice {
  AdviceKind kind = AdviceKind::None;
  std::string text;
  int student_frame = 0, coach_frame = 0;
  double severity = 0;       // in units of what counts as a clear difference
  std::string fault = {};    // the name that golfers know for it, if it has one
  std::string measure = {};  // as in SpatialAdvice; for timing the phase: "backswing"
  std::string event = {};    // where it is told: an event; for timing the one that ends the phase
  double amount = 0;         // as in SpatialAdvice; for timing student's over coach's time, less 1
};

// A frame pair worth looking at, worst first.
struct FramePair {
  int student_frame = 0, coach_frame = 0;
  double mean_error_m = 0;
  std::vector<JointGap> joints = {};  // as in PoseMatch
};

struct MotionSummary {
  std::string source;
  int frames = 0;
  double seconds = 0;
  int joints = 0;
  std::optional<Handedness> hand;
};

struct Analysis {
  MotionSummary coach, student;
  std::string retarget_method;
  double bone_length_error_max = 0;
  bool contacts = false;           // whether grip and feet were closed and planted after retargeting
  double grip_error_p95_m = 0;     // of the wrists' relation on the club, where the arms reach
  double reach_deficit_max_m = 0;  // how far the arms are too short for the coach's hands, worst frame
  Score score;
  std::vector<std::pair<int, int>> path;  // (student frame, coach frame), both never decreasing
  std::vector<double> path_error_m;       // mean joint error of each path step
  std::vector<JointError> joint_errors;   // worst first
  StageGaps stage_gaps = {};              // none of motion capture
  std::vector<FramePair> worst_frames;    // at most 5, apart from each other in time
  std::string stroke;                     // "full swing" or "putt"
  std::vector<SwingEvent> student_events, coach_events;
  double student_takeaway_s = 0, coach_takeaway_s = 0;  // the backswing starts here, not at address
  double coach_yaw = 0;  // turn about +Y, radians, that makes the coach face as the student does
  std::vector<PoseMatch> poses;
  std::vector<TimingAdvice> timing;
  std::vector<SpatialAdvice> spatial;
  std::vector<Metric> metrics;
  std::vector<Advice> advice;      // what matters most first; 1 to 3
  std::vector<std::string> notes;  // quality remarks: view, frame rate, grip out of reach, ...
};

}  // namespace posecoach
