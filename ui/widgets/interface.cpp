#include "ui/widgets/interface.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>

#include "core/base/assert.h"
#include "ui/render/font.h"
#include "ui/widgets/interface_state.h"

namespace posecoach {
namespace {

constexpr float kDoubleClick_s = 0.3F;
// Latin, Greek, Cyrillic, punctuation, arrows and signs: what names and sentences in the window are made of.
constexpr ImWchar kTextGlyphs[] = {0x0020, 0x017F, 0x0218, 0x021B, 0x0370, 0x03FF, 0x0400, 0x04FF, 0x1E80,
                                   0x1E85, 0x2010, 0x2027, 0x2030, 0x203A, 0x20AC, 0x20AC, 0x2190, 0x2193,
                                   0x2212, 0x2212, 0x2260, 0x2265, 0xFFFD, 0xFFFD, 0};
constexpr ImWchar kLargeGlyphs[] = {0x0020, 0x017F, 0x2013, 0x2026, 0x2212, 0x2212, 0};

ImFont* add_font(ImFontAtlas& atlas, TextStyle style, double scale) {
  const std::string_view file = font_file(type_weight(style));
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;
  const bool is_large = style == TextStyle::Display || style == TextStyle::Giant;
  config.OversampleH = is_large ? 1 : 2;
  config.OversampleV = 1;
  config.GlyphRanges = is_large ? kLargeGlyphs : kTextGlyphs;
  const double size = line_height_px(type_size(style) * scale);
  // The atlas only reads the bytes.
  return atlas.AddFontFromMemoryTTF(const_cast<char*>(file.data()), static_cast<int>(file.size()),
                                    static_cast<float>(size), &config);
}

}  // namespace

Interface::Interface(Drawing drawing) : drawing_(drawing), state_(std::make_unique<InterfaceState>()) {
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.ConfigInputTextCursorBlink = true;
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowPadding = style.FramePadding = style.ItemSpacing = style.ItemInnerSpacing = ImVec2(0, 0);
  style.WindowBorderSize = style.FrameBorderSize = style.ChildBorderSize = style.PopupBorderSize = 0;
  style.WindowRounding = style.ChildRounding = 0;
  style.WindowMinSize = ImVec2(1, 1);
  style.ScrollbarSize = 10;
  style.ScrollbarRounding = 5;
}

Interface::~Interface() {
  if (drawing_ == Drawing::OpenGl && ImGui::GetIO().BackendRendererUserData != nullptr)
    ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext();
}

Result<std::unique_ptr<Interface>> Interface::make(Drawing drawing) {
  POSECOACH_ASSERT(ImGui::GetCurrentContext() == nullptr);
  std::unique_ptr<Interface> made(new Interface(drawing));
  if (drawing == Drawing::OpenGl && !ImGui_ImplOpenGL3_Init("#version 330 core"))
    return fail(ErrorCode::Unsupported, "the window cannot be drawn: OpenGL could not be loaded");
  return made;
}

void Interface::load_fonts(double scale) {
  ImGuiIO& io = ImGui::GetIO();
  io.Fonts->Clear();
  io.Fonts->Flags |= ImFontAtlasFlags_NoMouseCursors;
  io.Fonts->TexGlyphPadding = 2;
  for (int i = 0; i < kTextStyleCount; ++i)
    state_->fonts[static_cast<std::size_t>(i)] = add_font(*io.Fonts, static_cast<TextStyle>(i), scale);
  io.FontDefault = state_->fonts[static_cast<std::size_t>(TextStyle::Body)];
  io.FontGlobalScale = static_cast<float>(1 / scale);
  const bool is_built = io.Fonts->Build();
  POSECOACH_ASSERT(is_built);
  if (drawing_ == Drawing::OpenGl) {
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
  }
  ImGuiStyle& style = ImGui::GetStyle();
  style.CircleTessellationMaxError = static_cast<float>(0.2 / scale);
  style.CurveTessellationTol = static_cast<float>(1.0 / scale);
  state_->scale = scale;
}

std::unique_ptr<Ui> Interface::begin(const FrameInput& input, const Theme& theme, SceneViews& views) {
  if (state_->scale != input.scale) load_fonts(input.scale);
  if (drawing_ == Drawing::OpenGl) ImGui_ImplOpenGL3_NewFrame();
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = ImVec2(static_cast<float>(input.size.x), static_cast<float>(input.size.y));
  io.DisplayFramebufferScale = ImVec2(static_cast<float>(input.scale), static_cast<float>(input.scale));
  const float last_frame_s = io.DeltaTime;
  io.DeltaTime = static_cast<float>(std::clamp(input.elapsed_s, 1e-4, 1.0));
  // Presses and releases are seen one a frame: the second of two quick clicks two frames late.
  io.MouseDoubleClickTime = kDoubleClick_s + last_frame_s + io.DeltaTime;
  ImGui::NewFrame();
  return std::make_unique<Ui>(*state_, theme, views, input);
}

void Interface::end(std::unique_ptr<Ui> ui) {
  POSECOACH_ASSERT(ui != nullptr);
  ui->walk_by_arrows();
  ui.reset();
  ImGui::End();
  state_->places_before.swap(state_->places);
  state_->places.clear();
  state_->top_layer_before = state_->top_layer;
  ImGui::Render();
}

void Interface::draw() {
  if (drawing_ == Drawing::OpenGl) ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void Interface::set_mouse(const Vec2& at, bool pressed, double wheel) {
  ImGuiIO& io = ImGui::GetIO();
  io.MousePos = ImVec2(static_cast<float>(at.x), static_cast<float>(at.y));
  io.MouseDown[0] = pressed;
  io.MouseWheel = static_cast<float>(wheel);
}

}  // namespace posecoach
