// What is to be seen, as plain values: bodies of lit capsules in the world, a floor, a picture behind them,
// and flat shapes and text over them. Made by pure functions, drawn by SceneRenderer; no OpenGL here.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "core/image/frame.h"
#include "ui/render/colour.h"
#include "ui/render/font.h"

namespace posecoach {

// A tapered rod with round ends, in world metres; a sphere when both ends are the same point.
struct Capsule {
  Vec3 from, to;
  double from_radius_m = 0.01, to_radius_m = 0.01;
  Colour colour;
};

enum class Surface {
  Plain,
  Banded  // bright and dark bands along each capsule: told apart without colour
};

// A body: opaque within itself, so that a see-through one shows no bones through bones.
struct Figure {
  std::vector<Capsule> capsules;
  Surface surface = Surface::Plain;
  double opacity = 1;
  Colour outline{0, 0, 0, 0};  // around the whole silhouette; alpha 0 for none
  double outline_px = 0;
};

// Lines on the plane y = height, fading out towards the edge; soft shadows below the figures.
struct Floor {
  Vec3 centre;
  double half_extent_m = 2;
  double spacing_m = 0.25;
  Colour line = colour_from_hex(0x8A94A6).with_alpha(0.5F);
  bool shadows = true;
};

// Flat shapes, in pixels of the drawn picture, origin top left, +Y down. A rounded box: of zero radius a
// rectangle, of full radius a pill or disc.
struct Box {
  Vec2 centre, half_size;
  double corner_radius = 0;
  Vec2 direction{1, 0};  // of its first axis, unit length
  Colour fill;
  double border = 0;  // inwards
  Colour border_colour{0, 0, 0, 0};
  double softness = 0;  // width of a blurred edge: shadows and glows
};

enum class Align { Left, Centre, Right };

struct Text {
  std::string utf8;
  Vec2 baseline;  // left end, middle or right end of the base line, by `align`
  double size_px = 16;
  FontWeight weight = FontWeight::Medium;
  Colour colour = colour_from_hex(0xFFFFFF);
  Align align = Align::Left;
};

// Drawn in the order of the list.
struct Flat {
  std::optional<Box> box;
  std::optional<Text> text;
};

// A part of a picture, as fractions of its width and height.
struct PicturePart {
  Vec2 begin{0, 0}, end{1, 1};
  Vec2 size() const { return end - begin; }
  bool operator==(const PicturePart&) const = default;
};

struct Scene {
  Colour background_top = colour_from_hex(0x20242C), background_bottom = colour_from_hex(0x14171C);
  std::shared_ptr<const Image> picture;  // its part fills the whole; the background where there is none
  PicturePart part;
  std::optional<Floor> floor;
  std::vector<Figure> figures;  // later ones over earlier ones
  std::vector<Flat> flats;

  void add(Box box) { flats.push_back({std::move(box), std::nullopt}); }
  void add(Text text) { flats.push_back({std::nullopt, std::move(text)}); }
};

// A box from its corner.
Box make_box(Vec2 top_left, Vec2 size, double corner_radius, Colour fill);
// A straight line with round ends.
Box make_line(Vec2 from, Vec2 to, double width, Colour colour);
Box make_disc(Vec2 centre, double radius, Colour fill);

}  // namespace posecoach
