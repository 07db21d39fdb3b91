// Small signs drawn from lines, sharp at every size, one stroke width.
#pragma once

#include "ui/widgets/ui.h"

namespace posecoach {

enum class Icon {
  None,
  Play,
  Pause,
  StepBack,
  StepForward,
  ToStart,
  ToEnd,
  Loop,
  Live,
  Review,
  Library,
  SetUp,
  Person,
  Coach,
  Star,
  StarFilled,
  Trash,
  Restore,
  Search,
  Export,
  Import,
  Plus,
  Check,
  Cross,
  Warning,
  Information,
  Camera,
  Record,
  Measure,
  Keyboard,
  SideBySide,
  Superpose,
  Sound,
  SoundOff,
  Mirror,
  ArrowDown,
  ArrowRight,
  Clock,
  Body,
  Note,
  Retry,
  FullScreen,
  Line,
  Angle,
  Bookmark,
  Undo,
  Folder
};

// Within a square of this side around the centre.
void draw_icon(Ui& ui, Icon icon, const Vec2& centre, double size, const Colour& colour);

}  // namespace posecoach
