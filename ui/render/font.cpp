#include "ui/render/font.h"

#include <stb_truetype.h>

#include <array>

#include "core/base/assert.h"
#include "core/base/embedded.h"

namespace posecoach {
namespace {

POSECOACH_EMBEDDED(font_medium)
POSECOACH_EMBEDDED(font_bold)

constexpr char32_t kReplacement = 0xFFFD;

const stbtt_fontinfo& font(FontWeight weight) {
  static const std::array<stbtt_fontinfo, 2> fonts = [] {
    std::array<stbtt_fontinfo, 2> made{};
    for (const FontWeight w : {FontWeight::Medium, FontWeight::Bold}) {
      const auto* bytes = reinterpret_cast<const unsigned char*>(font_file(w).data());
      const int ready = stbtt_InitFont(&made[static_cast<std::size_t>(w)], bytes, 0);
      POSECOACH_ASSERT(ready != 0);
    }
    return made;
  }();
  return fonts[static_cast<std::size_t>(weight)];
}

float scale_of(const stbtt_fontinfo& info, double size_px) {
  return stbtt_ScaleForMappingEmToPixels(&info, static_cast<float>(size_px));
}

// Takes the next character off the front.
char32_t next_character(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  const std::size_t length = first < 0x80         ? 1
                             : (first >> 5) == 6  ? 2
                             : (first >> 4) == 14 ? 3
                             : (first >> 3) == 30 ? 4
                                                  : 0;
  if (length == 0 || length > text.size()) {
    text.remove_prefix(1);
    return kReplacement;
  }
  char32_t character = length == 1 ? first : first & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) {
      text.remove_prefix(i);
      return kReplacement;
    }
    character = character << 6 | (byte(i) & 0x3FU);
  }
  text.remove_prefix(length);
  return character;
}

struct Line {
  std::vector<PlacedGlyph> glyphs;
  double width = 0;
};

Line lay_out_line(std::string_view utf8, FontWeight weight, double size_px) {
  const stbtt_fontinfo& info = font(weight);
  const double scale = static_cast<double>(scale_of(info, size_px));
  Line line;
  int previous = 0;
  while (!utf8.empty()) {
    const int glyph = stbtt_FindGlyphIndex(&info, static_cast<int>(next_character(utf8)));
    if (previous != 0) line.width += scale * stbtt_GetGlyphKernAdvance(&info, previous, glyph);
    line.glyphs.push_back({glyph, {line.width, 0}});
    int advance = 0, bearing = 0;
    stbtt_GetGlyphHMetrics(&info, glyph, &advance, &bearing);
    line.width += scale * advance;
    previous = glyph;
  }
  return line;
}

}  // namespace

std::string_view font_file(FontWeight weight) {
  return weight == FontWeight::Bold ? font_bold() : font_medium();
}

std::vector<PlacedGlyph> lay_out(std::string_view utf8, FontWeight weight, double size_px) {
  return lay_out_line(utf8, weight, size_px).glyphs;
}

double text_width_px(std::string_view utf8, FontWeight weight, double size_px) {
  return lay_out_line(utf8, weight, size_px).width;
}

double cap_height_px(double size_px) {
  const stbtt_fontinfo& info = font(FontWeight::Medium);
  static const int height = [&] {
    int left = 0, bottom = 0, right = 0, top = 0;
    stbtt_GetCodepointBox(&info, 'H', &left, &bottom, &right, &top);
    return top;
  }();
  return static_cast<double>(scale_of(info, size_px)) * height;
}

double line_height_px(double size_px) {
  const stbtt_fontinfo& info = font(FontWeight::Medium);
  int ascent = 0, descent = 0, gap = 0;
  stbtt_GetFontVMetrics(&info, &ascent, &descent, &gap);
  return static_cast<double>(scale_of(info, size_px)) * (ascent - descent);
}

GlyphPicture rasterise(int glyph, FontWeight weight, double size_px, double shift) {
  const stbtt_fontinfo& info = font(weight);
  const float scale = scale_of(info, size_px);
  int left = 0, top = 0, right = 0, bottom = 0;
  const auto shift_x = static_cast<float>(shift);
  stbtt_GetGlyphBitmapBoxSubpixel(&info, glyph, scale, scale, shift_x, 0, &left, &top, &right, &bottom);
  GlyphPicture picture;
  picture.left = left;
  picture.top = top;
  picture.width = right - left;
  picture.height = bottom - top;
  if (picture.width <= 0 || picture.height <= 0) return {};
  picture.coverage.resize(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
  stbtt_MakeGlyphBitmapSubpixel(&info, picture.coverage.data(), picture.width, picture.height, picture.width,
                                scale, scale, shift_x, 0, glyph);
  return picture;
}

std::string shortened(std::string_view utf8, FontWeight weight, double size_px, double width_px) {
  if (text_width_px(utf8, weight, size_px) <= width_px) return std::string(utf8);
  std::string_view kept = utf8;
  while (!kept.empty()) {
    std::size_t end = kept.size() - 1;
    while (end > 0 && (static_cast<unsigned char>(kept[end]) & 0xC0) == 0x80) --end;
    kept = kept.substr(0, end);
    std::string candidate = std::string(kept) + "…";
    if (text_width_px(candidate, weight, size_px) <= width_px) return candidate;
  }
  return {};
}

}  // namespace posecoach
