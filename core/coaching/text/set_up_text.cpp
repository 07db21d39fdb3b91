#include "core/coaching/text/set_up_text.h"

#include <array>
#include <cmath>

#include "core/coaching/text/fill.h"

namespace posecoach::text {
namespace {

// In the order of SetUp.
constexpr std::array<std::string_view, 28> kSetUp = {
    "Step into the picture",
    "Only part of you is in the picture: step back",
    "Your feet are cut off: step back or tilt the camera down",
    "Your head is cut off: step back or tilt the camera up",
    "Your hands leave the picture: move to its middle",
    "Your feet are hidden: clear what stands before them",
    "Your body is hidden: clear what stands before it",
    "Whole body in view",
    "Step into the picture to check the light",
    "Too dark: put more light on yourself",
    "The light is behind you: turn the camera or light your front",
    "Rather dark: more light makes the picture steadier",
    "Too bright: less direct light on yourself",
    "Hard to tell you from the background: other clothes or light help",
    "Light is good",
    "Nobody is seen",
    "Somebody else is in the picture: only you should be",
    "Only you in the picture",
    "Stand at address to check the view",
    "Face-on",
    "Down the line",
    "Film putts face-on: put the camera in front of you",
    "Film putts face-on: from here only the tempo of a long putt can be told",
    "The camera sees you at an angle: put it in front of you, or on the target line",
    "Too far away: come closer",
    "Rather far away: come closer",
    "Too close for the club: step back",
    "Distance is good",
};
static_assert(kSetUp.size() == static_cast<std::size_t>(SetUp::DistanceGood) + 1);

constexpr std::array<std::string_view, 5> kMeasure = {
    "Stand upright facing the camera, arms straight out to the sides.",
    "Hold still.",
    "I did not see your whole body long enough. Step into full view, arms and feet, and try again.",
    "Your body is measured.",
    "Your body is measured. Enter your height to make the measures exact.",
};
static_assert(kMeasure.size() == static_cast<std::size_t>(Measure::DoneWithoutHeight) + 1);

struct Aside {
  std::string_view now, afterwards;
};

const Aside& aside(Viewpoint side, bool is_positive) {
  static constexpr Aside kTooFarLeft{"About {angle} off face-on: move the camera to your right",
                                     "The camera stood about {angle} off face-on: move it to your right."};
  static constexpr Aside kTooFarRight{"About {angle} off face-on: move the camera to your left",
                                      "The camera stood about {angle} off face-on: move it to your left."};
  static constexpr Aside kTooFarFront{
      "About {angle} off down the line: move the camera to the side of your heels",
      "The camera stood about {angle} off down the line: move it to the side of your heels."};
  static constexpr Aside kTooFarBack{
      "About {angle} off down the line: move the camera to the side of your toes",
      "The camera stood about {angle} off down the line: move it to the side of your toes."};
  if (side == Viewpoint::DownTheLine) return is_positive ? kTooFarFront : kTooFarBack;
  return is_positive ? kTooFarLeft : kTooFarRight;
}

std::string angle_of(double aside_deg) {
  constexpr double kStep_deg = 5;
  return degrees(kStep_deg * std::round(aside_deg / kStep_deg));
}

}  // namespace

std::string set_up(SetUp what) {
  return std::string(kSetUp[static_cast<std::size_t>(what)]);
}

std::string camera_stands_aside(Viewpoint side, double aside_deg) {
  return filled(aside(side, aside_deg > 0).now, {{"angle", angle_of(aside_deg)}});
}

std::string camera_stood_aside(Viewpoint side, double aside_deg) {
  return filled(aside(side, aside_deg > 0).afterwards, {{"angle", angle_of(aside_deg)}});
}

std::string measure(Measure what) {
  return std::string(kMeasure[static_cast<std::size_t>(what)]);
}

std::string not_measured(const std::string& reason) {
  return filled("Your body could not be measured: {reason}.", {{"reason", reason}});
}

std::string no_picture_from(const std::string& camera) {
  return filled(
      "No picture has come from {camera} for a second. Is it plugged in, and free for this program?",
      {{"camera", camera}});
}

}  // namespace posecoach::text
