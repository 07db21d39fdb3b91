// Draws flat shapes and text over the bound frame buffer.
#pragma once

#include <map>
#include <span>
#include <tuple>

#include "ui/render/gl/objects.h"
#include "ui/render/scene.h"

namespace posecoach::gl {

class FlatPass {
 public:
  static Result<FlatPass> make();
  void draw(std::span<const Flat> flats, int width_px, int height_px);

 private:
  struct Instance;
  struct AtlasGlyph {
    int x = 0, y = 0;  // in the atlas
    int width = 0, height = 0, left = 0, top = 0;
  };
  // Glyph, weight, size and sideways shift in quarters of a pixel.
  using GlyphKey = std::tuple<int, FontWeight, int, int>;

  explicit FlatPass(Program program);
  bool add_text(const Text& text, std::vector<Instance>& to);
  const AtlasGlyph* find_glyph(const GlyphKey& key);

  Program program_;
  Handle instances_, array_, atlas_;
  std::map<GlyphKey, AtlasGlyph> glyphs_;
  int shelf_x_ = 0, shelf_y_ = 0, shelf_height_ = 0;
};

}  // namespace posecoach::gl
