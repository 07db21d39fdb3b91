#include "tests/support/sample_window.h"

#include <cmath>
#include <limits>
#include <map>

#include "core/base/assert.h"
#include "core/body/landmark_body.h"
#include "core/image/image_codec.h"
#include "tests/support/plain_swing.h"

namespace posecoach {
namespace {

// Pictures as they are asked for, each drawn once.
PictureLookup pictures_of(std::shared_ptr<const ReviewSwing> review) {
  auto kept = std::make_shared<std::map<int, std::shared_ptr<const Image>>>();
  return [review, kept](int wanted) -> std::optional<ShownPicture> {
    auto& image = (*kept)[wanted];
    if (!image) {
      Result<std::shared_ptr<const Image>> drawn =
          review->swing->pictures->picture(static_cast<std::size_t>(wanted));
      if (!drawn) return std::nullopt;
      image = *drawn;
    }
    return ShownPicture{wanted, image};
  };
}

OpenedSwing opened(std::string id, std::string title, const std::shared_ptr<const ReviewSwing>& review) {
  return {std::move(id), std::move(title), "today 14:32 · full swing", review, pictures_of(review), true, {}};
}

std::shared_ptr<const Image> thumbnail(int frame) {
  const Result<std::shared_ptr<const Image>> drawn =
      sample_review()->swing->pictures->picture(static_cast<std::size_t>(frame));
  POSECOACH_ASSERT(drawn.has_value());
  return std::make_shared<const Image>(resized(**drawn, 320, 180));
}

// As far as framing him needs it.
SeenPerson seen_person(const PosedBody& body, const PinholeCamera& camera) {
  SeenPerson person;
  for (const auto& [landmark, role] :
       {std::pair(Landmark::Nose, HumanoidJoint::Head), std::pair(Landmark::LeftHip, HumanoidJoint::LeftHip),
        std::pair(Landmark::RightHip, HumanoidJoint::RightHip),
        std::pair(Landmark::LeftHeel, HumanoidJoint::LeftAnkle),
        std::pair(Landmark::RightHeel, HumanoidJoint::RightAnkle)})
    if (const int joint = body.skeleton->find(role); joint != kNoJoint)
      if (const std::optional<Vec2> at = camera.project(body.positions[static_cast<std::size_t>(joint)]))
        person.image[landmark] = {*at, 0.95};
  return person;
}

BodyPose body_pose(const PosedBody& body) {
  return {std::make_shared<const Skeleton>(*body.skeleton), body.positions, body.confidence};
}

// The top of the swing, where the student's faults are plain to see.
int moment() {
  return sample_review()->events[3];
}

}  // namespace

std::shared_ptr<const ReviewSwing> sample_review() {
  static const auto review = make_review_swing(make_plain_swing("sway=14,bent_lead_arm=60", 1.80));
  return review;
}

std::shared_ptr<const ReviewSwing> second_review() {
  static const auto review = make_review_swing(make_plain_swing("reverse_spine_angle=22", 1.66));
  return review;
}

CoachSnapshot sample_snapshot(LoopState loop) {
  const auto review = sample_review();
  CoachSnapshot snapshot;
  snapshot.number = 1 + static_cast<std::uint64_t>(loop);
  snapshot.source_state = SourceState::Live;
  snapshot.source = "camera:/dev/v4l/by-id/usb-046d_C920?width=1280&height=720&fps=30.00&format=MJPG";
  const Result<std::shared_ptr<const Image>> picture =
      review->swing->pictures->picture(static_cast<std::size_t>(moment()));
  POSECOACH_ASSERT(picture.has_value());
  snapshot.frame = Frame{static_cast<std::size_t>(moment()),
                         review->swing->track.frames[static_cast<std::size_t>(moment())].time,
                         {},
                         *picture};
  const BodiesAtPicture bodies = bodies_at(*review, moment());
  snapshot.student = body_pose(*bodies.student);
  snapshot.camera = review->swing->student.camera;
  snapshot.person = seen_person(*bodies.student, *snapshot.camera);
  Ghost ghost;
  ghost.body = body_pose(*bodies.coach);
  ghost.fraction = 0.4;
  ghost.closeness.fill(0.9);
  for (const auto& [joint, closeness] :
       {std::pair(HumanoidJoint::LeftElbow, 0.15), std::pair(HumanoidJoint::LeftWrist, 0.4),
        std::pair(HumanoidJoint::LeftHip, 0.3), std::pair(HumanoidJoint::RightHip, 0.3)})
    ghost.closeness[static_cast<std::size_t>(joint)] = closeness;
  snapshot.ghost = ghost;
  snapshot.loop = loop;
  snapshot.checks = {{SetUpTopic::WholeBody, SetUpLevel::Good, "All of you is in the picture."},
                     {SetUpTopic::Light, SetUpLevel::Good, "Bright enough."},
                     {SetUpTopic::OnePerson, SetUpLevel::Good, "Only you are seen."},
                     {SetUpTopic::View, SetUpLevel::Poor, "Turn a little more towards the camera."},
                     {SetUpTopic::Distance, SetUpLevel::Bad, "Step back: your feet leave the picture."}};
  snapshot.address_advice = {"Bend 5° more from the hips.", "Stand 6 cm wider."};
  snapshot.counters = {1843, 0, 311, 30.0, 24.9, 46.2, 61.8};
  snapshot.swing = review->swing;
  return snapshot;
}

SampleWindow empty_window() {
  SampleWindow window;
  window.model.listing.path = "/home/anna/Videos";
  window.model.listing.parent = "/home/anna";
  return window;
}

SampleWindow normal_window() {
  SampleWindow window;
  WindowModel& model = window.model;
  model.snapshot = std::make_shared<const CoachSnapshot>(sample_snapshot(LoopState::Armed));
  model.opened = opened("s14", "Swing 14", sample_review());
  model.replay = model.opened;
  model.replay_seconds_left = 8.2;
  static const std::array<std::shared_ptr<const Image>, 4> pictures = {thumbnail(5), thumbnail(30),
                                                                       thumbnail(40), thumbnail(55)};
  for (int i = 0; i < 9; ++i) {
    SwingCard card;
    card.id = "s" + std::to_string(14 - i);
    card.title = "Swing " + std::to_string(14 - i);
    card.when =
        i < 5 ? "today 14:" + std::to_string(50 - 4 * i) : "yesterday 18:" + std::to_string(40 - 3 * i);
    card.person = i % 3 == 2 ? "Ben" : "Anna";
    card.coach = "Full swing, bundled";
    card.stroke = i == 6 ? "putt" : "full swing";
    card.notes = i == 0 ? "Felt the weight stay on the left heel." : "";
    card.score_percent = 88.0 - 6 * i;
    card.seconds = 4.2;
    card.is_starred = i % 4 == 0;
    card.thumbnail = pictures[static_cast<std::size_t>(i % 4)];
    model.swings.push_back(card);
  }
  window.state.selected = "s14";
  model.cameras = {{"camera:/dev/v4l/by-id/usb-046d_C920",
                    "HD Pro Webcam C920",
                    "/dev/video0, up to 1920 × 1080",
                    {{1280, 720, 30, "MJPG"}, {1920, 1080, 30, "MJPG"}, {640, 480, 30, "YUYV"}}},
                   {"simulated:swing", "Simulated student, full swing", "No camera needed", {}},
                   {"simulated:putt", "Simulated student, putt", "No camera needed", {}}};
  model.source = model.cameras[0].source;
  model.coaches = {{"bundled:swing", "Full swing", "Comes with the program"},
                   {"bundled:putt", "Putt", "Comes with the program"},
                   {"s9", "Anna, swing 9", "Your own best, 12 May"}};
  model.coach = "bundled:swing";
  model.people = {{"anna", "Anna", Handedness::Right, 1.71, true},
                  {"ben", "Ben", Handedness::Left, {}, false}};
  model.person = "anna";
  model.has_sound = true;
  model.folder = "/home/anna/Videos/VirtualPoseCoach";
  model.listing = {
      "/home/anna/Videos",
      "/home/anna",
      {{"Videos", "/home/anna/Videos", "", true},
       {"Home", "/home/anna", "", true},
       {"STICK", "/media/anna/STICK", "", true}},
      {{"Range", "/home/anna/Videos/Range", "", true},
       {"coach.bvh", "/home/anna/Videos/coach.bvh", "210 kB · 2026-05-12 18:04", false},
       {"driver 12 May.mp4", "/home/anna/Videos/driver 12 May.mp4", "14 MB · 2026-05-12 18:10", false}},
      ""};
  model.leftovers = {{"/home/anna/Videos/VirtualPoseCoach/.unfinished/swing_1",
                      "Recording of 2026-05-12 14:32", "18 MB of film · Anna"}};
  window.state.hides_leftovers = true;
  model.opened->marks = {{},
                         {{DrawingKind::Line, moment(), {{300, 300}, {330, 60}}},
                          {DrawingKind::Angle, moment(), {{250, 110}, {305, 140}, {300, 250}}}},
                         {20, moment()}};
  model.jobs = {{1, "Exporting swing 14", "drawing", 0.42}};
  model.toasts = {
      {1, ToastKind::Good, "Swing 14 is kept.", "", {}},
      {2, ToastKind::Information, "Swing 9 is in the trash.", "Undo", intent::RestoreSwing{"s9"}}};
  window.state.played = sample_review();
  window.state.playback.frame = moment();
  window.state.chosen_advice = 0;
  return window;
}

SampleWindow extreme_window() {
  SampleWindow window = normal_window();
  WindowModel& model = window.model;
  const std::string endless =
      "A name that somebody has written without ever thinking of where it might have to be shown, "
      "Straße Łódź Ελλάδα Москва 東京 \xff\xfe";
  CoachSnapshot snapshot = sample_snapshot(LoopState::Swinging);
  snapshot.number = 77;
  snapshot.source = endless;
  snapshot.source_state = SourceState::Lost;
  snapshot.source_message = "The camera " + endless + " was unplugged; plug it in again.";
  snapshot.swing_message = "The swing could not be analysed: " + endless;
  for (SetUpCheck& check : snapshot.checks) check = {check.topic, SetUpLevel::Bad, endless};
  for (int i = 0; i < 12; ++i) snapshot.address_advice.push_back(endless);
  snapshot.counters = {std::numeric_limits<std::uint64_t>::max(), 123456789, 987654321,
                       std::numeric_limits<double>::quiet_NaN(),  1e9,       1e12,
                       std::numeric_limits<double>::infinity()};
  snapshot.measuring = Measuring{Measuring::Stage::CountDown, 9999.5, endless};
  for (Vec3& position : snapshot.ghost->body.positions) position *= 40.0;
  snapshot.ghost->closeness.fill(-1);
  model.snapshot = std::make_shared<const CoachSnapshot>(snapshot);
  model.is_simulated = model.is_recording = true;
  model.recorded_s = 1e7;
  model.recording_lost = 17;
  model.compared = opened("s2", endless, second_review());
  model.opened->title = model.opened->detail = endless;
  for (int i = 0; i < 400; ++i) {
    SwingCard card;
    card.id = "many" + std::to_string(i);
    card.title = card.person = card.coach = card.notes = card.when = card.stroke = endless;
    card.score_percent = i % 2 == 0 ? std::numeric_limits<double>::quiet_NaN() : -1e30;
    if (i % 3 == 0) card.unreadable = "analysis.json:3: " + endless;
    model.swings.insert(model.swings.begin(), card);
    model.cameras.push_back({"camera:" + std::to_string(i), endless, endless, {}});
    model.coaches.push_back({"coach" + std::to_string(i), endless, endless});
    model.people.push_back({"person" + std::to_string(i), endless, Handedness::Left, {}, false});
    model.toasts.push_back({100 + i, ToastKind::Warning, endless, "Undo it now", intent::Quit{}});
  }
  model.jobs.push_back({9, endless, endless, std::numeric_limits<double>::quiet_NaN()});
  model.folder = endless;
  model.listing.path = model.listing.parent = endless;
  for (int i = 0; i < 400; ++i) {
    const std::string number = std::to_string(i);
    model.listing.entries.push_back({endless, number, endless, i % 2 == 0});
    model.listing.places.push_back({endless, number, "", true});
    model.leftovers.push_back({number, endless, endless});
    model.opened->marks.drawings.push_back({DrawingKind::Angle, 105, {{-1e9, 1e9}, {0, 0}, {1e9, 0}}});
    model.opened->marks.key_pictures.push_back(1000 * i);
  }
  for (const KeyBinding& binding : key_bindings()) model.keys.set(binding.command, 1, {Key::F12, true, true});
  window.state.zoom = {1e9, {-7, 12}};
  window.state.tool = {DrawingKind::Angle, {{-50, 4000}}, Vec2(1e6, -1e6)};
  window.state.selected = "many399";
  window.state.playback.frame = 1'000'000;
  window.state.playback.in = -5;
  window.state.playback.out = 2'000'000;
  window.state.typed_source = window.state.typed_name = window.state.typed_import = endless;
  return window;
}

}  // namespace posecoach
