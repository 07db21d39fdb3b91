#include "core/session/person.h"

#include <algorithm>

#include "core/body/body_file.h"
#include "core/session/file_name.h"
#include "core/session/plain_json.h"

namespace posecoach {
namespace fs = std::filesystem;
namespace {

constexpr const char* kPersonSchema = "posecoach.person/1";
constexpr const char* kProfile = "person.json";
constexpr const char* kBody = "body.json";
constexpr double kShortest_m = 0.5, kTallest_m = 2.6, kKindest = 0.5, kHardest = 2;
constexpr std::size_t kLongestName = 80;

Result<Person> read_person(const fs::path& folder) {
  const std::string file = (folder / kProfile).string();
  const Result<PlainJson> json = read_plain_json(file);
  if (!json) return tl::unexpected(json.error());
  if (const Result<int> version = schema_version(*json, "person", 1, file); !version)
    return tl::unexpected(version.error());
  Person person;
  PlainFields fields(*json, file);
  fields.read("name", person.name);
  if (const auto hand = fields.choice("hand", {"right", "left"}))
    person.hand = *hand == 0 ? Handedness::Right : Handedness::Left;
  fields.read("height_m", person.height_m);
  fields.read("coach", person.coach);
  fields.read("strictness", person.strictness);
  fields.read("last_view", person.last_view);
  if (person.name.empty()) fields.complain("name", "a text");
  if (const Result<void> checked = fields.checked(); !checked) return tl::unexpected(checked.error());
  std::error_code failed;
  if (!fs::exists(folder / kBody, failed)) return person;
  Result<Skeleton> body = read_body_file(folder / kBody);
  if (!body) return tl::unexpected(body.error());
  person.body = *std::move(body);
  return person;
}

Result<void> check(const Person& person) {
  if (file_name_from(person.name) == "unnamed" || person.name.size() > kLongestName)
    return fail(ErrorCode::InvalidArgument,
                "\"" + person.name + "\": a person's name needs a letter or digit, and at most 80 bytes");
  if (person.height_m && !(*person.height_m >= kShortest_m && *person.height_m <= kTallest_m))
    return fail(ErrorCode::InvalidArgument, person.name + ": a height is 0.5 to 2.6 metres");
  if (!(person.strictness >= kKindest && person.strictness <= kHardest))
    return fail(ErrorCode::InvalidArgument, person.name + ": strictness is 0.5 (kind) to 2 (hard)");
  return {};
}

void put(PlainJson& json, const Person& person) {
  json["schema"] = kPersonSchema;
  json["name"] = person.name;
  if (person.hand)
    json["hand"] = *person.hand == Handedness::Left ? "left" : "right";
  else
    json.erase("hand");
  if (person.height_m)
    json["height_m"] = *person.height_m;
  else
    json.erase("height_m");
  json["coach"] = person.coach;
  json["strictness"] = person.strictness;
  json["last_view"] = person.last_view;
}

}  // namespace

std::vector<People::Listed> People::list() const {
  std::vector<Listed> people;
  std::error_code failed;
  for (fs::directory_iterator entry(folder_, failed), end; !failed && entry != end; entry.increment(failed)) {
    std::error_code ignored;
    if (!entry->is_directory(ignored)) continue;
    Result<Person> person = read_person(entry->path());
    Listed listed;
    if (person) {
      listed.person = *std::move(person);
    } else {
      listed.person.name = entry->path().filename().string();
      listed.unreadable = person.error().message;
    }
    people.push_back(std::move(listed));
  }
  std::sort(people.begin(), people.end(),
            [](const Listed& a, const Listed& b) { return folded(a.person.name) < folded(b.person.name); });
  return people;
}

Result<Person> People::find(std::string_view name) const {
  Result<Person> person = read_person(folder_ / file_name_from(name));
  if (person || person.error().code != ErrorCode::NotFound) return person;
  std::string known;
  for (const Listed& listed : list()) known += (known.empty() ? "" : ", ") + listed.person.name;
  return fail(ErrorCode::NotFound, "there is no profile \"" + std::string(name) + "\"; " +
                                       (known.empty() ? "there are none yet" : "there are: " + known));
}

Result<void> People::save(const Person& person) {
  if (const Result<void> checked = check(person); !checked) return checked;
  const fs::path folder = folder_ / file_name_from(person.name);
  const fs::path profile = folder / kProfile;
  Result<PlainJson> json = read_plain_json(profile);
  if (!json && json.error().code != ErrorCode::NotFound) return tl::unexpected(json.error());
  if (!json) json = PlainJson::object();
  if (const auto known = json->find("name");
      known != json->end() && known->is_string() && folded(known->get<std::string>()) != folded(person.name))
    return fail(ErrorCode::InvalidArgument, "\"" + person.name + "\" is too like \"" +
                                                known->get<std::string>() + "\"; choose another name");
  put(*json, person);
  if (const Result<void> made = make_folders(disk_, folder); !made) return made;
  // The body first: a profile is there only once all of it is.
  const fs::path body = folder / kBody;
  std::error_code failed;
  if (person.body) {
    if (const Result<void> stored = store_file(disk_, body, body_to_json(*person.body)); !stored)
      return stored;
  } else if (fs::exists(body, failed) && disk_.remove(body.c_str()) != 0) {
    return tl::unexpected(disk_error("remove", body));
  }
  return store_file(disk_, profile, to_text(*json));
}

Result<void> People::remove(std::string_view name) {
  const fs::path folder = folder_ / file_name_from(name);
  std::error_code failed;
  if (!fs::is_directory(folder, failed))
    return fail(ErrorCode::NotFound, "there is no profile \"" + std::string(name) + "\"");
  return remove_folder(disk_, folder);
}

Person People::default_person(std::string_view last) const {
  if (!last.empty())
    if (Result<Person> person = find(last)) return *std::move(person);
  for (Listed& listed : list())
    if (listed.unreadable.empty()) return std::move(listed.person);
  Person somebody;
  somebody.name = "Golfer";
  return somebody;
}

}  // namespace posecoach
