#include "app/window/run_window.h"

#include "app/window/glfw_window.h"
#include "ui/render/picture_texture.h"
#include "ui/screens/screens.h"
#include "ui/widgets/gl_scene_views.h"
#include "ui/widgets/interface.h"

namespace posecoach {
namespace {

// Software drawing keeps up with scenes of about this size.
constexpr double kSoftwarePixels = 0.75e6, kHardwarePixels = 8.3e6;

}  // namespace

Result<void> run_window(const LiveArguments& arguments, const LiveDevices& devices) {
  Result<std::unique_ptr<GlfwWindow>> opened = GlfwWindow::open("Virtual Pose Coach", 1280, 720);
  if (!opened) return tl::unexpected(opened.error());
  GlfwWindow& window = **opened;
  Result<std::unique_ptr<Interface>> interface = Interface::make(Interface::Drawing::OpenGl);
  if (!interface) return tl::unexpected(interface.error());
  window.connect();
  window.appear();
  GlSceneViews views(is_drawn_by_software() ? kSoftwarePixels : kHardwarePixels);
  // Loading the pose networks takes a moment.
  {
    const Theme theme = make_theme(ThemeKind::Dark, Palette::RedGreen);
    std::unique_ptr<Ui> ui = (*interface)->begin(window.next_input(0, 1), theme, views);
    draw_starting(*ui, ui->whole());
    (*interface)->end(std::move(ui));
    window.clear();
    (*interface)->draw();
    window.show();
  }
  Result<std::unique_ptr<WindowProgram>> made = WindowProgram::make(arguments, devices);
  if (!made) {
    window.disconnect();
    return tl::unexpected(made.error());
  }
  WindowProgram& program = **made;
  WindowState state;
  Intents intents;
  double text_size = 1;
  int hurry = 3;  // frames to draw at once after something happened
  while (!window.wants_to_close() && !program.wants_to_quit()) {
    const FrameInput input = window.next_input(hurry > 0 ? 0.004 : program.longest_sleep_s(state), text_size);
    hurry = window.was_touched() || !intents.empty() ? 3 : hurry - 1;
    const WindowModel& model = program.model(input.time_s, state);
    text_size = model.text_size;
    const Theme theme = make_theme(model.theme, model.palette);
    intents.clear();
    std::unique_ptr<Ui> ui = (*interface)->begin(input, theme, views);
    draw_window({*ui, model, state, intents}, ui->whole());
    (*interface)->end(std::move(ui));
    window.clear();
    (*interface)->draw();
    views.end_frame();
    if (const std::optional<Rect> shot = program.takes_shot())
      program.keep_shot(read_window(input.scale * shot->x, input.scale * shot->y, input.scale * shot->width,
                                    input.scale * shot->height));
    window.show();
    program.perform(intents, state);
    if (program.takes_full_screen()) window.toggle_full_screen();
  }
  window.disconnect();
  return {};
}

}  // namespace posecoach
