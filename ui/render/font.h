// The program's typeface (Inter), carried inside the program: measuring text and turning it into coverage
// pictures. No OpenGL here.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/math.h"

namespace posecoach {

enum class FontWeight { Medium, Bold };

// One glyph at its place, in pixels from the start of the base line (+Y down).
struct PlacedGlyph {
  int glyph = 0;
  Vec2 origin;  // on the base line
};

// Coverage 0 to 255, rows top to bottom; `left` and `top` from the glyph's origin to the first pixel.
struct GlyphPicture {
  int width = 0, height = 0;
  int left = 0, top = 0;
  std::vector<std::uint8_t> coverage;
};

// The font file, for other drawing libraries.
std::string_view font_file(FontWeight weight);

// Kerned; bytes that are not UTF-8 become a replacement sign. `size_px` is the em.
std::vector<PlacedGlyph> lay_out(std::string_view utf8, FontWeight weight, double size_px);
double text_width_px(std::string_view utf8, FontWeight weight, double size_px);
// Height of a capital letter: what to centre.
double cap_height_px(double size_px);
// From the highest to the lowest stroke of the typeface, which is what some libraries call its size.
double line_height_px(double size_px);

// `shift` in [0, 1): the part of a pixel by which the glyph stands right of the pixel grid.
GlyphPicture rasterise(int glyph, FontWeight weight, double size_px, double shift);

// The text, cut at its end with an ellipsis so that it is no wider than `width_px`.
std::string shortened(std::string_view utf8, FontWeight weight, double size_px, double width_px);

}  // namespace posecoach
