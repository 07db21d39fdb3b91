#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "ui/render/words.h"
#include "ui/report/html.h"
#include "ui/report/page_pieces.h"
#include "ui/report/report_sections.h"

namespace posecoach::report {
namespace {

constexpr double kWidth = 200, kHeight = 232, kFloor = 220, kAir = 16;
// The moments that are farthest apart carry a word.
constexpr std::size_t kFarthest = 3;
constexpr std::size_t kMostPoses = 10;

struct PosePair {
  int student_frame = 0, coach_frame = 0;
  std::string title, advice;
  double apart_m = 0;
  const std::vector<JointGap>* joints = nullptr;
  bool is_farthest = false;
};

std::string n(double value) {
  return decimal(value, 1);
}

// The stroke's moments, and those of the worst ones that lie between them.
std::vector<PosePair> pose_pairs(const Analysis& analysis) {
  std::vector<PosePair> pairs;
  for (const PoseMatch& match : analysis.poses)
    pairs.push_back({match.student_frame, match.coach_frame, title_from_name(match.event), match.advice,
                     match.apart_m, &match.joints, false});
  const double near =
      analysis.path.empty() ? 1 : 0.05 * (analysis.path.back().first - analysis.path.front().first);
  for (const FramePair& pair : analysis.worst_frames) {
    const bool is_new = std::none_of(pairs.begin(), pairs.end(), [&](const PosePair& other) {
      return std::abs(other.student_frame - pair.student_frame) < near;
    });
    if (is_new && pairs.size() < kMostPoses)
      pairs.push_back({pair.student_frame, pair.coach_frame, student_phase(analysis, pair.student_frame), "",
                       pair.mean_error_m, &pair.joints, false});
  }
  std::vector<double> apart;
  for (const PosePair& pair : pairs) apart.push_back(pair.apart_m);
  std::sort(apart.rbegin(), apart.rend());
  for (PosePair& pair : pairs) pair.is_farthest = apart.size() > kFarthest && pair.apart_m > apart[kFarthest];
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const PosePair& a, const PosePair& b) { return a.student_frame < b.student_frame; });
  return pairs;
}

// Both bodies before one another, from the front or from the side.
class PoseDrawing {
 public:
  PoseDrawing(const Replay& replay, const ReplayStep& step, bool is_side, double scale)
      : replay_(replay), step_(step), is_side_(is_side), scale_(scale) {
    double low = 1e9, high = -1e9;
    for (const std::vector<Vec3>* body : {&step.student, &step.coach})
      for (const Vec3& p : *body) {
        low = std::min(low, across(p));
        high = std::max(high, across(p));
      }
    middle_ = 0.5 * (low + high);
  }

  std::string body(const std::vector<Vec3>& joints, std::string_view look) const {
    std::string path;
    for (const auto& [a, b] : replay_.bones) path += "M" + at(joints[index(a)]) + "L" + at(joints[index(b)]);
    std::string head;
    const auto found = std::find(replay_.joints.begin(), replay_.joints.end(), HumanoidJoint::Head);
    if (found != replay_.joints.end()) {
      const Vec3& p = joints[static_cast<std::size_t>(found - replay_.joints.begin())];
      head = "<circle cx=\"" + n(x(p)) + "\" cy=\"" + n(y(p)) + "\" r=\"" + n(0.085 * scale_) + "\"/>";
    }
    return "<g class=\"body " + std::string(look) + "\"><path d=\"" + path + "\"/>" + head + "</g>";
  }

  // Both places of a joint ringed and joined; empty for joints that the replay does not have.
  std::string mark(std::string_view joint) const {
    const auto role = humanoid_joint_from_string(joint);
    const auto found =
        role ? std::find(replay_.joints.begin(), replay_.joints.end(), *role) : replay_.joints.end();
    if (found == replay_.joints.end()) return {};
    const auto k = static_cast<std::size_t>(found - replay_.joints.begin());
    const Vec3 &his = step_.student[k], &coachs = step_.coach[k];
    return "<path d=\"M" + at(coachs) + "L" + at(his) + "\"/><circle cx=\"" + n(x(coachs)) + "\" cy=\"" +
           n(y(coachs)) + "\" r=\"6\"/><circle cx=\"" + n(x(his)) + "\" cy=\"" + n(y(his)) + "\" r=\"6\"/>";
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  double across(const Vec3& p) const { return is_side_ ? p.z : p.x; }
  double x(const Vec3& p) const { return 0.5 * kWidth + scale_ * (across(p) - middle_); }
  double y(const Vec3& p) const { return kFloor - scale_ * p.y; }
  std::string at(const Vec3& p) const { return n(x(p)) + " " + n(y(p)); }

  const Replay& replay_;
  const ReplayStep& step_;
  bool is_side_ = false;
  double scale_ = 1, middle_ = 0;
};

// One scale for all, so that bodies stay as large as they are.
double scale_of(const Replay& replay, bool is_side) {
  double tall = 1, wide = 0.5;
  for (const ReplayStep& step : replay.steps) {
    double low = 1e9, high = -1e9;
    for (const std::vector<Vec3>* body : {&step.student, &step.coach})
      for (const Vec3& p : *body) {
        tall = std::max(tall, p.y);
        low = std::min(low, is_side ? p.z : p.x);
        high = std::max(high, is_side ? p.z : p.x);
      }
    wide = std::max(wide, high - low);
  }
  return std::min((kFloor - kAir) / tall, (kWidth - 2 * kAir) / wide);
}

// Where more of what differs can be seen.
bool is_seen_better_from_the_side(const std::vector<JointGap>& joints) {
  double front = 0, side = 0;
  for (const JointGap& gap : joints) {
    front += std::abs(gap.offset_m.x);
    side += std::abs(gap.offset_m.z);
  }
  return side > front;
}

std::string caption(const PosePair& pair) {
  std::string words;
  for (const JointGap& gap : *pair.joints) {
    std::string joint = title_from_name(gap.joint);
    words += (words.empty() ? "" : ", ") + html::escape(joint) + "&nbsp;" + centimetres(gap.distance_m, 0);
  }
  return words.empty() ? "No joint clearly apart" : words;
}

}  // namespace

std::string poses_section(const Analysis& analysis, const Replay& replay) {
  if (replay.steps.empty()) return {};
  const std::vector<PosePair> pairs = pose_pairs(analysis);
  const auto from_the_side = std::count_if(pairs.begin(), pairs.end(), [](const PosePair& pair) {
    return is_seen_better_from_the_side(*pair.joints);
  });
  // One view for all of them, so that they can be compared.
  const bool is_side = 2 * from_the_side > static_cast<std::ptrdiff_t>(pairs.size());
  const double scale = scale_of(replay, is_side);
  std::string cards;
  for (const PosePair& pair : pairs) {
    const ReplayStep& step =
        replay.steps[static_cast<std::size_t>(step_at(replay, pair.student_frame, pair.coach_frame))];
    const PoseDrawing drawing(replay, step, is_side, scale);
    std::string marks;
    for (const JointGap& gap : *pair.joints) marks += drawing.mark(gap.joint);
    cards += "<figure class=\"pose\"><svg viewBox=\"0 0 " + n(kWidth) + " " + n(kHeight) +
             "\" role=\"img\" aria-label=\"" + html::escape(pair.title) +
             "\"><line class=\"floor\" x1=\"16\" y1=\"" + n(kFloor + 4) + "\" x2=\"" + n(kWidth - 16) +
             "\" y2=\"" + n(kFloor + 4) + "\"/>" + drawing.body(step.coach, "coach") +
             drawing.body(step.student, "student") + "<g class=\"marks\">" + marks +
             "</g></svg><figcaption><b>" + html::escape(pair.title) + "</b>" +
             (pair.is_farthest ? "<span class=\"chip\">farthest apart</span>" : "") +
             (pair.advice.empty() ? "" : "<span>" + html::escape(pair.advice) + "</span>") +
             "<span class=\"quiet\">" + caption(pair) + "</span>" +
             moment_button(replay, pair.student_frame, pair.coach_frame) + "</figcaption></figure>";
  }
  if (!cards.empty()) cards = "<div class=\"poses\">" + cards + "</div>";
  return section(
      "poses", "Pose by pose", cards,
      std::string("<span class=\"student\">You</span> over <span class=\"coach\">the coach in your "
                  "body</span>, feet together, seen from the ") +
          (is_side ? "side" : "front") +
          ": your moment that answers each of his, and when it comes. Rings mark the joints that are "
          "farthest apart.");
}

}  // namespace posecoach::report
