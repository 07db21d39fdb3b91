#include <cmath>

#include "core/coaching/text/advice_text.h"
#include "core/coaching/text/fill.h"
#include "core/coaching/text/name_text.h"

namespace posecoach::text {

std::string no_clear_difference(double percent) {
  // At a low score there must be something, and the golfer is owed to know that it was not found.
  constexpr double kMuchIsDifferent = 80;
  if (percent < kMuchIsDifferent)
    return "No clear difference from the coach was found: many small ones, none that stands out.";
  return "No clear difference from the coach was found.";
}

std::string seen_from(Viewpoint view, StrokeKind kind) {
  switch (view) {
    case Viewpoint::AllSides:
      return {};
    case Viewpoint::FaceOn:
      return "Filmed face-on: turns, and what happens towards the ball, are not judged.";
    case Viewpoint::DownTheLine:
      if (kind == StrokeKind::Putt)
        return "Filmed down the line: of a putt only the way from the top to the ball is judged; film putts "
               "face-on.";
      return "Filmed down the line: turns, the lead arm, and what happens along the target line are not "
             "judged.";
    case Viewpoint::Between:
      break;
  }
  return "Filmed from an angle: only the timing and the height of the head are judged; stand square to the "
         "camera for more.";
}

std::string coach_seen_elsewhere() {
  return "The coach was filmed from another side: only the timing is judged; film yourself from his side for "
         "more.";
}

std::string out_of_reach(double metres) {
  return filled("The coach's grip is up to {size} out of reach of your arms; there the drawn hands are open.",
                {{"size", centimetres(metres)}});
}

std::string moved_by_hand(bool count) {
  return count ? "Positions of this swing were moved by hand."
               : "The positions moved by hand do not follow each other; the found ones count.";
}

std::string strictness(const std::string& harder, const std::string& milder, const std::string& never) {
  std::string words;
  const auto add = [&words](std::string_view sentence, const std::string& parts) {
    if (parts.empty()) return;
    words += (words.empty() ? "" : " ") + filled(sentence, {{"parts", parts}});
  };
  add("Judged harder than usual: {parts}.", harder);
  add("Judged more mildly than usual: {parts}.", milder);
  add("Not judged: {parts}.", never);
  return words;
}

std::string only_the_score(const std::string& reason) {
  return filled("The swing could not be divided into its parts, so there is only a score: {reason}.",
                {{"reason", reason}});
}

std::string block(int swings, double mean, double deviation, const std::string& advice, int times) {
  if (swings == 1) return filled("One swing: {mean} of 100.", {{"mean", number(mean, 0)}});
  std::string words = filled(
      "{swings} swings: {mean} ± {deviation} of 100.",
      {{"swings", std::to_string(swings)}, {"mean", number(mean, 0)}, {"deviation", number(deviation, 0)}});
  if (!advice.empty())
    words +=
        " " + filled("In {times} of them: {advice}", {{"times", std::to_string(times)}, {"advice", advice}});
  return words;
}

std::string address(Posture what, double amount) {
  const bool is_more = amount > 0;
  std::string_view words;
  switch (what) {
    case Posture::Stance:
      words = is_more ? "Narrow your stance by {size}." : "Widen your stance by {size}.";
      break;
    case Posture::Spine:
      words = is_more ? "Stand up {angle} more: you bend too far forward."
                      : "Bend forward {angle} more from the hips.";
      break;
    case Posture::Side:
      words = is_more ? "Tilt your spine {angle} less away from the target."
                      : "Tilt your spine {angle} more away from the target.";
      break;
    case Posture::Knees:
      words = is_more ? "Straighten your knees by {angle}." : "Bend your knees {angle} more.";
      break;
    case Posture::Hands:
      words = is_more ? "Let your hands hang {size} closer to your feet."
                      : "Let your hands hang {size} farther from your feet.";
      break;
  }
  return filled(words, {{"size", centimetres(amount)}, {"angle", degrees(amount)}});
}

std::string summary_title(const Analysis& analysis) {
  const bool is_left = analysis.student.hand == Handedness::Left;
  return filled("{student}: a {stroke}, {seconds} s, against {coach}.",
                {{"student", analysis.student.source},
                 {"stroke", std::string(stroke(analysis.stroke, is_left))},
                 {"seconds", number(analysis.student.seconds, 1)},
                 {"coach", analysis.coach.source}});
}

std::string summary_score(const Score& score) {
  constexpr double kWorthTelling = 0.5;
  return filled(
      score.plus_minus >= kWorthTelling
          ? "Score {percent} ± {doubt} of 100: on average a joint is {distance} cm from the coach's "
            "(raw {raw}, lower is better)."
          : "Score {percent} of 100: on average a joint is {distance} cm from the coach's (raw {raw}, "
            "lower is better).",
      {{"percent", number(score.percent, 0)},
       {"doubt", number(score.plus_minus, 0)},
       {"distance", number(100 * score.mean_joint_error_m, 1)},
       {"raw", number(score.raw, 2)}});
}

std::string summary_tempo(const Metric& tempo) {
  return filled("Tempo {value} ± {doubt} to 1, the coach's {coach} to 1.",
                {{"value", number(tempo.value, 1)},
                 {"doubt", number(tempo.plus_minus, 1)},
                 {"coach", number(tempo.coach.value_or(0), 1)}});
}

std::string summary_advice(int at, const Advice& advice) {
  return filled("{number}. {advice} (frame {frame}, coach {coach})",
                {{"number", std::to_string(at)},
                 {"advice", advice.text},
                 {"frame", std::to_string(advice.student_frame)},
                 {"coach", std::to_string(advice.coach_frame)}});
}

std::string summary_note(const std::string& note) {
  return filled("Note: {note}", {{"note", note}});
}

}  // namespace posecoach::text
