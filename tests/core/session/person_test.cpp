#include "core/session/person.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/file.h"
#include "core/body/named_body.h"
#include "core/session/settings.h"
#include "tests/core/session/test_disks.h"
#include "tests/support/temporary_folder.h"

namespace posecoach {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

Person make_person() {
  Person person;
  person.name = "Søren Ek";
  person.hand = Handedness::Left;
  person.height_m = 1.87;
  person.body = find_named_body("tall");
  person.coach = "reference:pro";
  person.strictness = 1.5;
  person.last_view = "down-the-line";
  return person;
}

class PersonTest : public testing::Test {
 protected:
  TemporaryFolder folder_;
  People people_{folder_.path() / "people"};
};

TEST_F(PersonTest, is_remembered_with_everything) {
  ASSERT_TRUE(people_.save(make_person()));
  const Person found = people_.find("soren EK").value();
  EXPECT_EQ(found.name, "Søren Ek");
  EXPECT_EQ(found.hand, Handedness::Left);
  EXPECT_EQ(found.height_m, 1.87);
  ASSERT_TRUE(found.body);
  EXPECT_EQ(found.body->size(), make_person().body->size());
  EXPECT_NEAR(found.body->leg_length(), make_person().body->leg_length(), 1e-6);
  EXPECT_EQ(found.coach, "reference:pro");
  EXPECT_EQ(found.strictness, 1.5);
  EXPECT_EQ(found.last_view, "down-the-line");
  Person forgetful = found;
  forgetful.hand.reset();
  forgetful.height_m.reset();
  forgetful.body.reset();
  ASSERT_TRUE(people_.save(forgetful));
  const Person again = people_.find("Søren Ek").value();
  EXPECT_EQ(again.hand, std::nullopt);
  EXPECT_EQ(again.height_m, std::nullopt);
  EXPECT_FALSE(again.body);
}

TEST_F(PersonTest, a_later_version_s_fields_survive) {
  ASSERT_TRUE(people_.save(make_person()));
  const fs::path file = folder_.path() / "people/soren_ek/person.json";
  std::string text = read_file(file).value();
  text.insert(text.find('{') + 1, "\"clubs\": [\"driver\"],");
  ASSERT_TRUE(write_file_atomically(file, text));
  ASSERT_TRUE(people_.save(make_person()));
  EXPECT_THAT(read_file(file).value(), HasSubstr("driver"));
}

TEST_F(PersonTest, one_broken_profile_does_not_hide_the_others) {
  ASSERT_TRUE(people_.save(make_person()));
  Person anna;
  anna.name = "Anna";
  ASSERT_TRUE(people_.save(anna));
  ASSERT_TRUE(write_file_atomically(folder_.path() / "people/anna/person.json", "{\"schema\": 7"));
  const std::vector<People::Listed> listed = people_.list();
  ASSERT_THAT(listed, SizeIs(2));
  EXPECT_THAT(listed[0].unreadable, HasSubstr("anna/person.json:1"));
  EXPECT_EQ(listed[1].person.name, "Søren Ek");
  EXPECT_EQ(people_.default_person("anna").name, "Søren Ek");
  EXPECT_FALSE(people_.save(anna)) << "a broken profile is not overwritten";
}

TEST_F(PersonTest, names_that_cannot_be_told_apart_are_refused) {
  ASSERT_TRUE(people_.save(make_person()));
  Person other;
  other.name = "Soren-Ek";
  EXPECT_EQ(people_.save(other).error().code, ErrorCode::InvalidArgument);
  other.name = "...";
  EXPECT_EQ(people_.save(other).error().code, ErrorCode::InvalidArgument);
  other.name = "Anna";
  other.height_m = 18.7;
  EXPECT_EQ(people_.save(other).error().code, ErrorCode::InvalidArgument);
  EXPECT_THAT(people_.list(), SizeIs(1));
}

TEST_F(PersonTest, who_is_not_there_is_told_with_those_who_are) {
  EXPECT_THAT(people_.find("Anna").error().message, HasSubstr("none yet"));
  ASSERT_TRUE(people_.save(make_person()));
  EXPECT_EQ(people_.find("Anna").error().code, ErrorCode::NotFound);
  EXPECT_THAT(people_.find("Anna").error().message, HasSubstr("Søren Ek"));
}

TEST_F(PersonTest, somebody_is_always_there_to_practise) {
  EXPECT_EQ(people_.default_person("").name, "Golfer");
  ASSERT_TRUE(people_.save(make_person()));
  Person anna;
  anna.name = "Anna";
  ASSERT_TRUE(people_.save(anna));
  EXPECT_EQ(people_.default_person("").name, "Anna");
  EXPECT_EQ(people_.default_person("soren ek").name, "Søren Ek");
  EXPECT_EQ(people_.default_person("nobody").name, "Anna");
  ASSERT_TRUE(people_.remove("Anna"));
  EXPECT_EQ(people_.default_person("").name, "Søren Ek");
  EXPECT_EQ(people_.remove("Anna").error().code, ErrorCode::NotFound);
}

TEST_F(PersonTest, a_disk_that_fills_up_leaves_the_profile_readable) {
  ASSERT_TRUE(people_.save(make_person()));
  Person changed = make_person();
  changed.coach = "bundled:putt";
  bool is_done = false;
  for (int n = 1; !is_done && n < 40; ++n) {
    FillingDisk disk(n);
    is_done = People(folder_.path() / "people", disk).save(changed).has_value();
    const Result<Person> found = people_.find("Søren Ek");
    ASSERT_TRUE(found) << found.error().message;
    EXPECT_THAT(found->coach, testing::AnyOf("reference:pro", "bundled:putt"));
    ASSERT_TRUE(people_.save(make_person()));
  }
  EXPECT_TRUE(is_done);
}

class SettingsTest : public testing::Test {
 protected:
  TemporaryFolder folder_;
  fs::path path_ = folder_.path() / "config" / "settings.json";
  SettingsFile file_{path_};
};

TEST_F(SettingsTest, are_remembered) {
  EXPECT_EQ(file_.load().message, "") << "no file is no fault";
  Settings settings;
  settings.camera = {"/dev/v4l/by-id/usb-cam", "MJPG", 1280, 720, 60};
  settings.theme = "light";
  settings.palette = "colour-blind";
  settings.interface_scale = 1.5;
  settings.speed = 0.25;
  settings.volume = 0;
  settings.person = "Søren Ek";
  settings.keys = {{"play", "Space"}, {"next_frame", "Right"}};
  ASSERT_TRUE(file_.save(settings));
  const LoadedSettings loaded = file_.load();
  EXPECT_EQ(loaded.message, "");
  EXPECT_EQ(loaded.settings.camera.stable_path, "/dev/v4l/by-id/usb-cam");
  EXPECT_EQ(loaded.settings.camera.pixel_format, "MJPG");
  EXPECT_EQ(loaded.settings.camera.width, 1280);
  EXPECT_EQ(loaded.settings.camera.height, 720);
  EXPECT_EQ(loaded.settings.camera.fps, 60);
  EXPECT_EQ(loaded.settings.theme, "light");
  EXPECT_EQ(loaded.settings.palette, "colour-blind");
  EXPECT_EQ(loaded.settings.interface_scale, 1.5);
  EXPECT_EQ(loaded.settings.speed, 0.25);
  EXPECT_EQ(loaded.settings.volume, 0);
  EXPECT_EQ(loaded.settings.person, "Søren Ek");
  EXPECT_EQ(loaded.settings.keys, settings.keys);
}

TEST_F(SettingsTest, keys_of_a_later_version_stay) {
  ASSERT_TRUE(file_.save({}));
  ASSERT_TRUE(write_file_atomically(
      path_, "{\"schema\": \"posecoach.settings/2\", \"camera\": {\"gain\": 3}, \"sounds\": [1]}"));
  EXPECT_EQ(file_.load().message, "");
  ASSERT_TRUE(file_.save({}));
  const std::string text = read_file(path_).value();
  EXPECT_THAT(text, HasSubstr("settings/2"));
  EXPECT_THAT(text, HasSubstr("\"gain\": 3"));
  EXPECT_THAT(text, HasSubstr("\"sounds\""));
}

TEST_F(SettingsTest, a_value_that_cannot_be_is_its_default_and_the_rest_counts) {
  ASSERT_TRUE(file_.save({}));
  for (const char* broken : {"\"speed\": 900", "\"volume\": \"loud\"", "\"theme\": \"pink\"", "\"camera\": 7",
                             "\"keys\": {\"play\": 3}", "\"interface_scale\": -1"}) {
    ASSERT_TRUE(write_file_atomically(path_, std::string("{\"person\": \"Anna\", ") + broken + "}"));
    const LoadedSettings loaded = file_.load();
    EXPECT_THAT(loaded.message, HasSubstr("settings.json")) << broken;
    EXPECT_EQ(loaded.settings.person, "Anna") << broken;
    EXPECT_EQ(loaded.settings.speed, 1);
    EXPECT_EQ(loaded.settings.theme, "dark");
    EXPECT_THAT(loaded.settings.keys, IsEmpty());
  }
}

TEST_F(SettingsTest, a_broken_file_is_set_aside_with_a_message) {
  ASSERT_TRUE(file_.save({}));
  ASSERT_TRUE(write_file_atomically(path_, "{\"theme\": \"light\", "));
  const LoadedSettings loaded = file_.load();
  EXPECT_THAT(loaded.message, HasSubstr("settings.json:1"));
  EXPECT_THAT(loaded.message, HasSubstr("settings.json.broken"));
  EXPECT_EQ(read_file(path_.string() + ".broken").value(), "{\"theme\": \"light\", ");
  EXPECT_EQ(file_.load().message, "");
  ASSERT_TRUE(file_.save({}));
}

TEST_F(SettingsTest, a_full_disk_leaves_the_old_ones) {
  Settings old_settings, new_settings;
  old_settings.person = "Anna";
  new_settings.person = "Søren";
  ASSERT_TRUE(file_.save(old_settings));
  bool is_done = false;
  for (int n = 1; !is_done && n < 20; ++n) {
    FillingDisk disk(n);
    is_done = SettingsFile(path_, disk).save(new_settings).has_value();
    EXPECT_THAT(file_.load().settings.person, testing::AnyOf("Anna", "Søren"));
    EXPECT_EQ(file_.load().message, "");
    if (!is_done) {
      ASSERT_TRUE(file_.save(old_settings));
    }
  }
  EXPECT_EQ(file_.load().settings.person, "Søren");
}

}  // namespace
}  // namespace posecoach
