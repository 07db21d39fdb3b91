#include "ui/panels/panel_registry.h"

#include <array>

#include "ui/panels/common_panels.h"
#include "ui/panels/library_panels.h"
#include "ui/panels/live_panels.h"
#include "ui/panels/review_panels.h"
#include "ui/panels/set_up_panels.h"

namespace posecoach {

std::span<const RegisteredPanel> registered_panels() {
  static constexpr std::array kPanels = {
      RegisteredPanel{"live_picture", 640, 360, draw_live_picture},
      RegisteredPanel{"state_banner", 320, 420, draw_state_banner, true},
      RegisteredPanel{"state_frame", 640, 360, draw_state_frame, true},
      RegisteredPanel{"set_up_checks", 290, 320, draw_set_up_checks, true},
      RegisteredPanel{"address_advice", 290, 220, draw_address_advice, true},
      RegisteredPanel{"first_steps", 320, 330, draw_first_steps, true},
      RegisteredPanel{"measuring", 520, 340, draw_measuring, true},
      RegisteredPanel{"status_line", 1190, 28, draw_status_line},
      RegisteredPanel{"live_controls", 1096, 58, draw_live_controls, true},
      RegisteredPanel{"source_message", 520, 340, draw_source_message, true},
      RegisteredPanel{"replay", 430, 600, draw_replay, true},
      RegisteredPanel{"review_header", 1160, 36, draw_review_header},
      RegisteredPanel{"films", 640, 360, draw_films},
      RegisteredPanel{"bodies", 260, 360, draw_bodies},
      RegisteredPanel{"advice", 300, 380, draw_advice},
      RegisteredPanel{"transport", 1160, 42, draw_transport},
      RegisteredPanel{"timeline", 1160, 230, draw_timeline},
      RegisteredPanel{"library_bar", 1160, 38, draw_library_bar},
      RegisteredPanel{"swing_cards", 860, 560, draw_swing_cards},
      RegisteredPanel{"swing_details", 300, 600, draw_swing_details},
      RegisteredPanel{"camera_choice", 570, 330, draw_camera_choice},
      RegisteredPanel{"person", 570, 300, draw_person},
      RegisteredPanel{"coach_list", 570, 330, draw_coach_list},
      RegisteredPanel{"looks", 570, 300, draw_looks},
      RegisteredPanel{"rail", 84, 720, draw_rail},
      RegisteredPanel{"messages", 480, 360, draw_messages},
      RegisteredPanel{"key_sheet", 1280, 720, draw_key_sheet},
      RegisteredPanel{"import_dialog", 900, 600, draw_import_dialog},
      RegisteredPanel{"leftovers", 660, 420, draw_leftovers},
  };
  return kPanels;
}

}  // namespace posecoach
