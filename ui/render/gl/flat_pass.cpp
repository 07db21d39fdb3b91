#include "ui/render/gl/flat_pass.h"

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "core/base/embedded.h"

namespace posecoach::gl {
namespace {

POSECOACH_EMBEDDED(shader_flat_vert)
POSECOACH_EMBEDDED(shader_flat_frag)

constexpr int kAtlasSize_px = 2048;

float f(double value) {
  return static_cast<float>(value);
}

}  // namespace

struct FlatPass::Instance {
  float centre_half[4];
  float direction_look[4];
  float fill[4];
  float border[4];
  float glyph[4];
  float softness;
};

Result<FlatPass> FlatPass::make() {
  Result<Program> program = Program::make("flat", shader_flat_vert(), shader_flat_frag());
  if (!program) return tl::unexpected(program.error());
  return FlatPass(std::move(*program));
}

FlatPass::FlatPass(Program program)
    : program_(std::move(program)),
      instances_(make_buffer()),
      array_(make_vertex_array()),
      atlas_(make_coverage_texture(kAtlasSize_px, kAtlasSize_px)) {
  glBindVertexArray(array_.id());
  const Attribute attributes[] = {
      {0, 4, offsetof(Instance, centre_half)}, {1, 4, offsetof(Instance, direction_look)},
      {2, 4, offsetof(Instance, fill)},        {3, 4, offsetof(Instance, border)},
      {4, 4, offsetof(Instance, glyph)},       {5, 1, offsetof(Instance, softness)}};
  describe(instances_, sizeof(Instance), attributes, 1);
  glBindVertexArray(0);
}

const FlatPass::AtlasGlyph* FlatPass::find_glyph(const GlyphKey& key) {
  if (const auto found = glyphs_.find(key); found != glyphs_.end()) return &found->second;
  const auto& [glyph, weight, size_quarters, shift_quarters] = key;
  const GlyphPicture picture = rasterise(glyph, weight, size_quarters / 4.0, shift_quarters / 4.0);
  if (shelf_x_ + picture.width + 1 > kAtlasSize_px) {
    shelf_y_ += shelf_height_ + 1;
    shelf_x_ = 0;
    shelf_height_ = 0;
  }
  if (picture.width > kAtlasSize_px || shelf_y_ + picture.height > kAtlasSize_px) return nullptr;
  const AtlasGlyph placed{shelf_x_, shelf_y_, picture.width, picture.height, picture.left, picture.top};
  if (picture.width > 0) {
    glBindTexture(GL_TEXTURE_2D, atlas_.id());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexSubImage2D(GL_TEXTURE_2D, 0, placed.x, placed.y, picture.width, picture.height, GL_RED,
                    GL_UNSIGNED_BYTE, picture.coverage.data());
    shelf_x_ += picture.width + 1;
    shelf_height_ = std::max(shelf_height_, picture.height);
  }
  return &glyphs_.emplace(key, placed).first->second;
}

// False when the atlas is full.
bool FlatPass::add_text(const Text& text, std::vector<Instance>& to) {
  const int size_quarters = static_cast<int>(std::lround(text.size_px * 4));
  if (size_quarters <= 0) return true;
  const double size_px = size_quarters / 4.0;
  double x = text.baseline.x;
  if (text.align != Align::Left) {
    const double width = text_width_px(text.utf8, text.weight, size_px);
    x -= text.align == Align::Centre ? 0.5 * width : width;
  }
  const double y = std::round(text.baseline.y);
  const Colour& c = text.colour;
  for (const PlacedGlyph& placed : lay_out(text.utf8, text.weight, size_px)) {
    const double quarters = std::round((x + placed.origin.x) * 4);
    const double whole = std::floor(quarters / 4);
    const AtlasGlyph* glyph =
        find_glyph({placed.glyph, text.weight, size_quarters, static_cast<int>(quarters - 4 * whole)});
    if (glyph == nullptr) return false;
    if (glyph->width == 0) continue;
    const double left = whole + glyph->left, top = y + glyph->top;
    to.push_back({{f(left + 0.5 * glyph->width), f(top + 0.5 * glyph->height), f(0.5 * glyph->width),
                   f(0.5 * glyph->height)},
                  {1, 0, 0, 0},
                  {c.red, c.green, c.blue, c.alpha},
                  {0, 0, 0, 0},
                  {f(glyph->x), f(glyph->y), f(glyph->x + glyph->width), f(glyph->y + glyph->height)},
                  0});
  }
  return true;
}

void FlatPass::draw(std::span<const Flat> flats, int width_px, int height_px) {
  std::vector<Instance> instances;
  const auto add_all = [&] {
    instances.clear();
    for (const Flat& flat : flats) {
      if (flat.box) {
        const Box& b = *flat.box;
        instances.push_back(
            {{f(b.centre.x), f(b.centre.y), f(b.half_size.x), f(b.half_size.y)},
             {f(b.direction.x), f(b.direction.y), f(b.corner_radius), f(b.border)},
             {b.fill.red, b.fill.green, b.fill.blue, b.fill.alpha},
             {b.border_colour.red, b.border_colour.green, b.border_colour.blue, b.border_colour.alpha},
             {0, 0, 0, 0},
             f(b.softness)});
      }
      if (flat.text && !add_text(*flat.text, instances)) return false;
    }
    return true;
  };
  if (!add_all()) {  // sizes of earlier pictures fill the atlas: begin a new one
    glyphs_.clear();
    shelf_x_ = shelf_y_ = shelf_height_ = 0;
    add_all();
  }
  if (instances.empty()) return;
  upload(instances_, std::as_bytes(std::span(instances)));
  program_.use();
  glUniform2f(program_.uniform("target_px"), f(width_px), f(height_px));
  glUniform1i(program_.uniform("atlas"), 0);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, atlas_.id());
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glBindVertexArray(array_.id());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(instances.size()));
  glBindVertexArray(0);
}

}  // namespace posecoach::gl
