// What the user wants done beyond the screen itself. Panels say it, the program does it.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/body/mirror.h"
#include "core/pipeline/coach_snapshot.h"
#include "core/session/marks.h"
#include "ui/screens/key_map.h"
#include "ui/theme/theme.h"

namespace posecoach {

enum class ExportKind { OverlayFilm, DrawnFilm, Report, Csv, Bvh, Trc };

struct PictureMode {
  int width = 0, height = 0;
  double fps = 0;
  std::string format;  // "MJPG", "YUYV"
  bool operator==(const PictureMode&) const = default;
};

namespace intent {

struct ArmHandsFree {};
struct DisarmHandsFree {};
struct MeasureBody {};
struct StopMeasuring {};
struct SetPace {
  Pace pace = Pace::Follow;
};
struct SetGhostSpeed {
  double speed = 1;
};
struct LeaveReplay {};
struct OpenLastSwing {};
struct StartRecording {};
struct StopRecording {};
struct TakeSnapshot {};
struct ChooseSource {
  std::string source;  // as on the command line
  std::optional<PictureMode> mode;
};
struct RetrySource {};
struct RefreshCameras {};
struct ChooseCoach {
  std::string id;
};
struct ChoosePerson {
  std::string id;
};
struct AddPerson {
  std::string name;
};
struct SetHand {
  Handedness hand = Handedness::Right;
};
struct SetHeight {
  std::optional<double> height_m;
};
struct OpenSwing {
  std::string id;
};
struct CompareWith {
  std::string id;
};
struct StopComparing {};
struct SetStar {
  std::string id;
  bool is_starred = false;
};
struct SetNotes {
  std::string id, notes;
};
struct TrashSwing {
  std::string id;
};
struct RestoreSwing {
  std::string id;
};
struct MakeReference {
  std::string id;
};
struct ExportSwing {
  std::string id;
  ExportKind kind = ExportKind::OverlayFilm;
};
struct ImportFile {
  std::string path;
};
// Keeps what was marked beside the swing; moved positions are analysed anew.
struct SetMarks {
  std::string id;
  Marks marks;
};
// What is seen in this part of the window, as a picture.
struct KeepShown {
  Rect area;
};
// Lists a folder for choosing a file; empty: the one of films.
struct ListFolder {
  std::string path;
};
// In the desktop's own file manager.
struct ShowFolder {
  std::string path;
};
struct KeepLeftover {
  std::string folder;
};
struct TrashLeftover {
  std::string folder;
};
struct SetKeys {
  KeyMap keys;
};
struct CancelJob {
  int id = 0;
};
struct DismissToast {
  int id = 0;
};
struct SetLook {
  ThemeKind kind = ThemeKind::Dark;
  Palette palette = Palette::RedGreen;
};
struct SetTextSize {
  double factor = 1;
};
struct SetSound {
  bool is_on = true;
};
struct ToggleFullScreen {};
struct Quit {};

}  // namespace intent

using Intent =
    std::variant<intent::ArmHandsFree, intent::DisarmHandsFree, intent::MeasureBody, intent::StopMeasuring,
                 intent::SetPace, intent::SetGhostSpeed, intent::LeaveReplay, intent::OpenLastSwing,
                 intent::StartRecording, intent::StopRecording, intent::TakeSnapshot, intent::ChooseSource,
                 intent::RetrySource, intent::RefreshCameras, intent::ChooseCoach, intent::ChoosePerson,
                 intent::AddPerson, intent::SetHand, intent::SetHeight, intent::OpenSwing,
                 intent::CompareWith, intent::StopComparing, intent::SetStar, intent::SetNotes,
                 intent::TrashSwing, intent::RestoreSwing, intent::MakeReference, intent::ExportSwing,
                 intent::ImportFile, intent::SetMarks, intent::KeepShown, intent::ListFolder,
                 intent::ShowFolder, intent::KeepLeftover, intent::TrashLeftover, intent::SetKeys,
                 intent::CancelJob, intent::DismissToast, intent::SetLook, intent::SetTextSize,
                 intent::SetSound, intent::ToggleFullScreen, intent::Quit>;
using Intents = std::vector<Intent>;

}  // namespace posecoach
