#include "core/coaching/text/refusal_text.h"

#include "core/coaching/text/fill.h"
#include "core/coaching/text/name_text.h"

namespace posecoach::text {

std::string no_such_joints(const std::string& names) {
  return filled("the body has no {joints}, which a swing is judged by", {{"joints", names}});
}

std::string too_few_frames_to_analyse(int frames, int least) {
  return filled("a motion of {frames} frames is too short for a swing; at least {least} are needed",
                {{"frames", std::to_string(frames)}, {"least", std::to_string(least)}});
}

std::string no_stroke_seen() {
  return "the hands neither swing up and down nor back and forth: no stroke is seen";
}

std::string begins_in_the_backswing() {
  return "the motion starts in the middle of the backswing";
}

std::string no_rest_before_the_stroke() {
  return "the hands never rest before the stroke, so its start is not seen";
}

std::string hands_stay_up() {
  return "the hands do not come down again after the top";
}

std::string hands_do_not_come_back() {
  return "the hands do not come back to the ball: impact is not seen";
}

std::string ends_before_impact() {
  return "the motion ends before impact";
}

std::string putt_too_short_from_here() {
  return "no full swing is seen, and along the target line a putt is lost in the tremble of the joints: film "
         "putts "
         "face-on, with the camera in front of you";
}

std::string out_of_order(std::string_view event, std::string_view other) {
  return filled("the moments of the stroke do not follow each other: {event} would come before {other}",
                {{"event", std::string(event)}, {"other", std::string(other)}});
}

std::string strokes_differ(const std::string& student, StrokeKind students, const std::string& coach) {
  return filled(students == StrokeKind::Putt
                    ? "{student} is a putt, {coach} a full swing; choose a coach's motion of the same kind"
                    : "{student} is a full swing, {coach} a putt; choose a coach's motion of the same kind",
                {{"student", student}, {"coach", coach}});
}

std::string no_strictness(std::string_view setting) {
  return filled(
      "\"{setting}\" is no strictness: write hips, trunk, head, arms, legs, timing or all, = and a "
      "number from 0 to 10, as in arms=2,legs=0",
      {{"setting", std::string(setting)}});
}

std::string no_golf_stroke(const std::string& why) {
  return filled("this is no golf stroke: {why}", {{"why", why}});
}

std::string hands_apart(double metres) {
  return filled("the hands are {size} apart, and no two hands on one club are",
                {{"size", centimetres(metres)}});
}

std::string feet_walk(double metres) {
  return filled("the feet move {size} before the ball would be hit", {{"size", centimetres(metres)}});
}

std::string hands_miss_the_ball(double metres) {
  return filled("the hands pass {size} away from where they started, so the ball is missed",
                {{"size", centimetres(metres)}});
}

std::string no_golf_tempo(double backswing_s, double downswing_s) {
  return filled("the hands go back for {back} s and forward for {forward} s",
                {{"back", number(backswing_s, 1)}, {"forward", number(downswing_s, 1)}});
}

std::string chest_does_not_turn(double angle) {
  return filled("the chest turns only {angle}", {{"angle", degrees(angle)}});
}

}  // namespace posecoach::text
