#include <cmath>

#include "ui/render/font.h"
#include "ui/widgets/imgui_values.h"
#include "ui/widgets/interface_state.h"
#include "ui/widgets/ui.h"

namespace posecoach {
namespace {

constexpr double kLineSpacing = 1.42;  // of the em
constexpr std::string_view kEllipsis = "…";

struct Type {
  ImFont* font;
  float size;  // points, as Dear ImGui counts
};

Type type_of(const InterfaceState& state, TextStyle style) {
  ImFont* const font = state.fonts[static_cast<std::size_t>(style)];
  return {font, static_cast<float>(static_cast<double>(font->FontSize) / state.scale)};
}

double width_of(const Type& type, std::string_view words) {
  const ImVec2 size = type.font->CalcTextSizeA(type.size, 1e9F, 0, words.data(), words.data() + words.size());
  return static_cast<double>(size.x);
}

// As much of the words as fits, whole characters.
std::string_view fitting(const Type& type, std::string_view words, double width) {
  const char* rest = nullptr;
  const auto room = static_cast<float>(std::max(0.0, width));
  (void)type.font->CalcTextSizeA(type.size, room, 0, words.data(), words.data() + words.size(), &rest);
  return words.substr(0, static_cast<std::size_t>(rest - words.data()));
}

std::string shortened(const Type& type, std::string_view words, double width) {
  if (width_of(type, words) <= width + 0.01) return std::string(words);
  std::string_view kept = fitting(type, words, width - width_of(type, kEllipsis));
  while (!kept.empty() && kept.back() == ' ') kept.remove_suffix(1);
  return std::string(kept) + std::string(kEllipsis);
}

}  // namespace

double Ui::line_height(TextStyle style) const {
  return std::round(kLineSpacing * type_size(style));
}

double Ui::cap_height(TextStyle style) const {
  return cap_height_px(type_size(style));
}

double Ui::text_width(TextStyle style, std::string_view words) const {
  return width_of(type_of(state_, style), words);
}

void Ui::text(TextStyle style, const Vec2& at, std::string_view words, const Colour& colour, Align align) {
  if (words.empty()) return;
  const Type type = type_of(state_, style);
  const double share = align == Align::Left ? 0 : align == Align::Centre ? 0.5 : 1;
  const double ascent = static_cast<double>(type.font->Ascent) / state_.scale;
  const Vec2 corner(at.x - (share > 0 ? share * width_of(type, words) : 0), at.y - ascent);
  // On whole pixels: glyphs stay sharp.
  const Vec2 snapped = glm::round(corner * state_.scale) / state_.scale;
  draw_list().AddText(type.font, type.size, im(snapped), im(colour), words.data(),
                      words.data() + words.size());
}

void Ui::text_in(TextStyle style, const Rect& rect, std::string_view words, const Colour& colour,
                 Align align) {
  const std::string cut = shortened(type_of(state_, style), words, rect.width);
  const double x = align == Align::Left ? rect.x : align == Align::Centre ? rect.centre().x : rect.right();
  text(style, {x, rect.centre().y + 0.5 * cap_height(style)}, cut, colour, align);
}

std::vector<Ui::Line> Ui::broken(TextStyle style, double width, std::string_view words,
                                 int most_lines) const {
  const Type type = type_of(state_, style);
  std::vector<Line> lines;
  const auto last = [&] { return static_cast<int>(lines.size()) + 1 >= most_lines; };
  while (!words.empty()) {
    const std::size_t end = std::min(words.find('\n'), words.size());
    std::string_view rest = words.substr(0, end);
    words.remove_prefix(std::min(end + 1, words.size()));
    do {
      std::string_view line = rest;
      if (!last() && width_of(type, rest) > width) {
        line = fitting(type, rest, width);
        if (line.size() < rest.size() && rest[line.size()] != ' ')
          if (const std::size_t space = line.rfind(' '); space != std::string_view::npos && space > 0)
            line = line.substr(0, space);
        if (line.empty()) line = rest.substr(0, 1);
      }
      lines.push_back({line, width_of(type, line)});
      if (static_cast<int>(lines.size()) >= most_lines) return lines;
      rest.remove_prefix(line.size());
      while (!rest.empty() && rest.front() == ' ') rest.remove_prefix(1);
    } while (!rest.empty());
  }
  return lines;
}

double Ui::paragraph(TextStyle style, const Rect& rect, std::string_view words, const Colour& colour,
                     int most_lines, Align align) {
  const double height = line_height(style);
  double y = rect.y;
  for (const Line& line : broken(style, rect.width, words, most_lines)) {
    text_in(style, {rect.x, y, rect.width, height}, line.words, colour, align);
    y += height;
  }
  return y - rect.y;
}

double Ui::paragraph_height(TextStyle style, double width, std::string_view words, int most_lines) const {
  return line_height(style) * static_cast<double>(broken(style, width, words, most_lines).size());
}

}  // namespace posecoach
