// What belongs to every screen: the rail to go from one to the other, messages, running work, the key sheet.
#pragma once

#include "ui/panels/panel.h"

namespace posecoach {

void draw_rail(const PanelContext& context, const Rect& area);
// From the area's lower right corner upwards.
void draw_messages(const PanelContext& context, const Rect& area);
// What of the area they cover.
Rect messages_area(const WindowModel& model, const Rect& area);
// What a swing can be exported as.
void draw_export_menu(const PanelContext& context, const Rect& area, const std::string& swing_id);
// Every key, and where the user changes them.
void draw_key_sheet(const PanelContext& context, const Rect& area);
// A file is chosen; it appears when "import" is open.
void draw_import_dialog(const PanelContext& context, const Rect& area);
void open_import_dialog(const PanelContext& context, BrowseFor what);
// What a sudden end left behind: keep it or throw it away.
void draw_leftovers(const PanelContext& context, const Rect& area);

}  // namespace posecoach
