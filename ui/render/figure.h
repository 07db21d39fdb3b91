// From a body's joints to a figure that can be drawn: bones with thickness, joints, head, hands and feet.
#pragma once

#include <span>

#include "core/body/skeleton.h"
#include "ui/render/scene.h"

namespace posecoach {

// World positions, metres, one a joint. `confidence` in [0, 1] or empty for 1 everywhere.
struct BodyState {
  const Skeleton& skeleton;
  std::span<const Vec3> positions;
  std::span<const double> confidence = {};
};

struct FigureStyle {
  Colour bone = colour_from_hex(0x2FBF71);
  Colour joint = colour_from_hex(0xC9F7DC);
  double thickness = 1;  // factor on the natural one
  Surface surface = Surface::Plain;
  double opacity = 1;
  Colour outline = colour_from_hex(0x0B0F14).with_alpha(0.75F);
  double outline_px = 1.5;
  double least_confidence = 0.3;  // joints below are not drawn, nor the bones that end in them
};

// Colours told apart by most eyes, or by brightness and bands as well.
enum class Palette { RedGreen, ColourBlindSafe };

FigureStyle student_style(Palette palette);
FigureStyle coach_style(Palette palette);

// One capsule a bone and one a bending joint, plus head, hands and heels, which stand for all that a rig
// has in them (eyes, fingers). Nothing for joints that were not seen or are not finite. Asserts that the
// sizes fit the skeleton.
Figure make_figure(const BodyState& body, const FigureStyle& style);

}  // namespace posecoach
