#include "core/session/references.h"

#include <algorithm>
#include <cerrno>

#include "core/base/file.h"
#include "core/motion/bundled_motion.h"
#include "core/motion/motion_file.h"
#include "core/motion/pose_file.h"
#include "core/session/draft_folder.h"
#include "core/session/file_name.h"
#include "core/session/plain_json.h"

namespace posecoach {
namespace fs = std::filesystem;
namespace {

constexpr const char* kFacts = "reference.json";
constexpr const char* kMotion = "motion.pose.json";
constexpr const char* kPictures = "pictures.pose.json";
constexpr std::string_view kBundledPrefix = "bundled:";

std::vector<Reference> bundled_references() {
  std::vector<Reference> references;
  for (const std::string& name : bundled_motion_names()) {
    Reference reference;
    const bool is_putt = name == "putt";
    reference.name = is_putt ? "Putt" : "Full swing";
    reference.source = std::string(kBundledPrefix) + name;
    reference.stroke = is_putt ? "putt" : "full swing";
    reference.hand = Handedness::Right;
    references.push_back(std::move(reference));
  }
  return references;
}

Reference read_reference(const fs::path& folder) {
  Reference reference;
  reference.name = folder.filename().string();
  reference.source = std::string(kReferencePrefix) + reference.name;
  std::error_code failed;
  reference.is_pictures = fs::is_regular_file(folder / kPictures, failed);
  reference.motion = folder / (reference.is_pictures ? kPictures : kMotion);
  const std::string file = (folder / kFacts).string();
  const Result<PlainJson> json = read_plain_json(file);
  const Result<int> version =
      json ? schema_version(*json, "reference", 1, file) : Result<int>(tl::unexpected(json.error()));
  if (!version) {
    reference.unreadable = version.error().message;
    return reference;
  }
  PlainFields fields(*json, file);
  fields.read("name", reference.name);
  fields.read("stroke", reference.stroke);
  if (const auto hand = fields.choice("hand", {"right", "left"}))
    reference.hand = *hand == 0 ? Handedness::Right : Handedness::Left;
  fields.read("origin", reference.origin);
  if (const Result<void> checked = fields.checked(); !checked)
    reference.unreadable = checked.error().message;
  else if (!fs::is_regular_file(reference.motion, failed))
    reference.unreadable = reference.motion.string() + " is missing";
  return reference;
}

std::string facts_text(const Reference& reference) {
  PlainJson json;
  json["schema"] = "posecoach.reference/1";
  json["name"] = reference.name;
  if (!reference.stroke.empty()) json["stroke"] = reference.stroke;
  if (reference.hand) json["hand"] = *reference.hand == Handedness::Left ? "left" : "right";
  json["origin"] = reference.origin;
  return to_text(json);
}

}  // namespace

std::vector<Reference> References::list() const {
  std::vector<Reference> own;
  std::error_code failed;
  for (fs::directory_iterator entry(folder_, failed), end; !failed && entry != end; entry.increment(failed)) {
    std::error_code ignored;
    if (entry->is_directory(ignored) && !entry->path().filename().string().starts_with("."))
      own.push_back(read_reference(entry->path()));
  }
  std::sort(own.begin(), own.end(),
            [](const Reference& a, const Reference& b) { return folded(a.name) < folded(b.name); });
  std::vector<Reference> all = bundled_references();
  all.insert(all.end(), own.begin(), own.end());
  return all;
}

Result<Reference> References::find(std::string_view source_or_name) const {
  std::string known;
  for (Reference& reference : list()) {
    if (reference.source == source_or_name || folded(reference.name) == folded(source_or_name)) {
      if (!reference.unreadable.empty()) return fail(ErrorCode::Malformed, reference.unreadable);
      return std::move(reference);
    }
    known += (known.empty() ? "" : ", ") + reference.source;
  }
  return fail(ErrorCode::NotFound,
              "there is no coach \"" + std::string(source_or_name) + "\"; there are: " + known);
}

Result<Reference> References::add_swing(const Swing& swing, std::string name) {
  const auto file = swing.file("student");
  if (!file) return fail(ErrorCode::Incomplete, swing.id + ": it has no motion yet; have it analysed first");
  Result<MotionFile> motion = read_motion_file(*file);
  if (!motion) return tl::unexpected(motion.error());
  Reference reference;
  const std::string who = swing.facts.person.empty() ? "Swing" : swing.facts.person;
  reference.name = name.empty() ? who + ", " + to_words(swing.facts.recorded_at) : std::move(name);
  reference.stroke = swing.facts.stroke;
  reference.hand = swing.facts.hand;
  reference.origin = swing.id;
  return add_motion(motion->motion, std::move(reference));
}

Result<Reference> References::add_motion_file(const fs::path& file, std::string name) {
  Result<MotionFile> motion = read_motion_file(file);
  if (!motion) return tl::unexpected(motion.error());
  Reference reference;
  reference.origin = file.filename().string();
  reference.name = name.empty() ? file.stem().stem().string() : std::move(name);
  return add_motion(motion->motion, std::move(reference));
}

Result<Reference> References::add_motion(const Motion& motion, Reference facts) {
  facts.is_pictures = false;
  return add(pose_json_from_motion(motion, facts.origin), facts);
}

Result<Reference> References::add_pictures(PoseTrack pictures) {
  const fs::path source = pictures.source;
  Reference facts;
  facts.origin = source.filename().string();
  facts.is_pictures = true;
  // From whatever place: the same picture.
  pictures.source = facts.origin;
  const std::string seen = pose_json_from_track(pictures);
  constexpr int kMostOfOneName = 100;
  Result<Reference> added = fail(ErrorCode::InvalidArgument, "");
  for (int number = 1; number <= kMostOfOneName; ++number) {
    facts.name = source.stem().string() + (number > 1 ? " " + std::to_string(number) : "");
    const Reference old = read_reference(folder_ / file_name_from(facts.name));
    if (old.unreadable.empty() && old.is_pictures && read_file(old.motion) == seen) return old;
    added = add(seen, facts);
    if (added || added.error().code != ErrorCode::InvalidArgument) break;
  }
  return added;
}

Result<Reference> References::add(const std::string& pose_json, const Reference& facts) {
  const std::string folder_name = file_name_from(facts.name);
  const fs::path place = folder_ / folder_name, drafts = folder_ / ".unfinished";
  for (const AbandonedDraft& draft : abandoned_drafts(drafts))
    if (remove_folder(disk_, draft.path)) forget_draft(disk_, draft.path);
  const Result<DraftFolder> draft = DraftFolder::make(disk_, drafts, DraftKind::Purged);
  if (!draft) return tl::unexpected(draft.error());
  const fs::path file = draft->path() / (facts.is_pictures ? kPictures : kMotion);
  if (const Result<void> stored = store_file(disk_, file, pose_json); !stored)
    return tl::unexpected(stored.error());
  if (const Result<void> stored = store_file(disk_, draft->path() / kFacts, facts_text(facts)); !stored)
    return tl::unexpected(stored.error());
  if (disk_.rename_to_new(draft->path().c_str(), place.c_str()) != 0) {
    if (errno == EEXIST || errno == ENOTEMPTY)
      return fail(ErrorCode::InvalidArgument,
                  "there is a coach called \"" + facts.name + "\" already; choose another name");
    return tl::unexpected(disk_error("make the coach", place));
  }
  if (const Result<void> synced = sync(disk_, folder_); !synced) return tl::unexpected(synced.error());
  return read_reference(place);
}

Result<void> References::remove(std::string_view source) {
  const Result<Reference> reference = find(source);
  if (!reference && reference.error().code == ErrorCode::NotFound) return tl::unexpected(reference.error());
  for (const Reference& listed : list())
    if (listed.source == source || (reference && listed.source == reference->source)) {
      if (listed.is_bundled())
        return fail(ErrorCode::InvalidArgument, listed.source + " belongs to the program");
      return remove_folder(disk_, listed.motion.parent_path());
    }
  return tl::unexpected(reference.error());
}

Result<Motion> load_reference(const References& references, std::string_view source) {
  if (source.starts_with(kBundledPrefix)) return bundled_motion(source.substr(kBundledPrefix.size()));
  const Result<Reference> reference = references.find(source);
  if (!reference) return tl::unexpected(reference.error());
  if (reference->is_pictures)
    return fail(ErrorCode::Unsupported,
                reference->name + ": there are only pictures of this coach, no motion");
  Result<MotionFile> motion = read_motion_file(reference->motion);
  if (!motion) return tl::unexpected(motion.error());
  return std::move(motion->motion);
}

}  // namespace posecoach
