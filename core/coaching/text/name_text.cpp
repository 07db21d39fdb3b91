#include "core/coaching/text/name_text.h"

#include <algorithm>
#include <array>

namespace posecoach::text {
namespace {

struct Name {
  std::string_view key, words;
};

constexpr std::array kMoments = {Name{"address", "At address"},
                                 Name{"toe_up", "Early in the backswing"},
                                 Name{"mid_backswing", "Halfway back"},
                                 Name{"top", "At the top"},
                                 Name{"mid_downswing", "Halfway down"},
                                 Name{"impact", "At impact"},
                                 Name{"mid_follow_through", "After impact"},
                                 Name{"finish", "At the finish"},
                                 Name{"end", "At the end of the stroke"}};

}  // namespace

std::string_view moment(std::string_view event) {
  for (const Name& name : kMoments)
    if (name.key == event) return name.words;
  return event;
}

std::string_view judged_part(JudgedPart part) {
  constexpr std::array<std::string_view, kJudgedParts.size()> kWords = {"hips", "trunk", "head",
                                                                        "arms", "legs",  "timing"};
  return kWords[static_cast<std::size_t>(part)];
}

std::string joint(HumanoidJoint joint) {
  std::string name(to_string(joint));
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

std::string_view stroke(std::string_view stroke, bool is_left_handed) {
  if (stroke == to_string(StrokeKind::Putt)) return is_left_handed ? "left-handed putt" : "right-handed putt";
  return is_left_handed ? "left-handed full swing" : "right-handed full swing";
}

}  // namespace posecoach::text
