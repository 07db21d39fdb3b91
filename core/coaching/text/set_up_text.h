// What a golfer is told before he swings: where to stand, the light, and how he is measured.
#pragma once

#include <string>

#include "core/coaching/viewpoint.h"

namespace posecoach::text {

enum class SetUp {
  StepIn,
  OnlyPart,
  FeetCut,
  HeadCut,
  HandsCut,
  FeetHidden,
  BodyHidden,
  WholeBody,
  StepInForLight,
  TooDark,
  LightBehind,
  RatherDark,
  TooBright,
  NoContrast,
  LightGood,
  Nobody,
  SomebodyElse,
  OnlyYou,
  AddressForView,
  FaceOn,
  DownTheLine,
  PuttFromBehind,
  ArmedForPuttFromBehind,
  AtAnAngle,
  TooFar,
  RatherFar,
  TooClose,
  DistanceGood
};
std::string set_up(SetUp what);

// The camera stands `aside_deg` beside `side`, face-on (positive towards his left) or down the line (positive
// towards his front), and has to go the other way. In steps of 5 degrees: nobody sets it up finer.
std::string camera_stands_aside(Viewpoint side, double aside_deg);  // during the set-up
std::string camera_stood_aside(Viewpoint side, double aside_deg);   // after the swing

enum class Measure { ArmsOut, HoldStill, NotSeen, Done, DoneWithoutHeight };
std::string measure(Measure what);
std::string not_measured(const std::string& reason);

std::string no_picture_from(const std::string& camera);

}  // namespace posecoach::text
