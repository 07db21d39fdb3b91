#include <algorithm>

#include "core/motion/bvh_document.h"
#include "core/motion/text_scanner.h"

namespace posecoach {
namespace {

constexpr std::size_t kMostJoints = 4096;
constexpr double kShortestFrame_s = 1e-5;
constexpr double kLongestFrame_s = 2;

bool is_word(std::string_view word, std::string_view expected) {
  return word.size() == expected.size() && equals_ignoring_case(word, expected);
}

std::optional<BvhChannel> channel_from_name(std::string_view name) {
  const std::string lower = to_lower(name);
  if (lower.size() < 2 || lower[0] < 'x' || lower[0] > 'z') return std::nullopt;
  const auto axis = static_cast<Axis>(lower[0] - 'x');
  if (lower.substr(1) == "position") return BvhChannel{BvhChannel::Kind::Position, axis};
  if (lower.substr(1) == "rotation") return BvhChannel{BvhChannel::Kind::Rotation, axis};
  return std::nullopt;
}

class Parser {
 public:
  Parser(std::string_view file_name, std::string_view text)
      : scanner_(file_name, text), bytes_(text.size()) {}

  Result<BvhDocument> run() {
    if (!is_word(scanner_.next(), "HIERARCHY"))
      return scanner_.failure("this is not a BVH file: it does not begin with HIERARCHY");
    if (const auto read = hierarchy(); !read) return tl::unexpected(read.error());
    if (scanner_.at_end()) return std::move(document_);
    if (const auto read = motion(); !read) return tl::unexpected(read.error());
    return std::move(document_);
  }

 private:
  struct Open {  // a joint whose closing brace has not come yet
    int joint = -1;
    bool has_offset = false;
    bool has_channels = false;
  };

  Result<void> expect(std::string_view expected) {
    const std::string_view word = scanner_.next();
    if (is_word(word, expected)) return {};
    return scanner_.failure("expected " + std::string(expected) + ", found " + found(word));
  }
  static std::string found(std::string_view word) {
    return word.empty() ? "the end of the file" : in_quotes(word);
  }

  Result<double> number(const std::string& what) {
    double value = 0;
    if (scanner_.next_number(value)) return value;
    return scanner_.failure(what + " needs a number, found " + found(scanner_.next()));
  }

  Result<void> open_joint(bool is_end_site) {
    if (document_.joints.size() >= kMostJoints)
      return scanner_.failure("more than 4096 joints", ErrorCode::Unsupported);
    BvhJoint joint;
    joint.is_end_site = is_end_site;
    joint.parent = open_.empty() ? -1 : open_.back().joint;
    const std::string_view name = scanner_.rest_of_name();
    if (!is_end_site) joint.name = name;
    if (const auto brace = expect("{"); !brace) return brace;
    open_.push_back({static_cast<int>(document_.joints.size()), false, false});
    document_.joints.push_back(std::move(joint));
    return {};
  }

  BvhJoint& current() { return document_.joints[static_cast<std::size_t>(open_.back().joint)]; }

  Result<void> read_offset() {
    if (open_.back().has_offset) return scanner_.failure("a second OFFSET for the same joint");
    open_.back().has_offset = true;
    for (int i = 0; i < 3; ++i) {
      const auto value = number("OFFSET");
      if (!value) return tl::unexpected(value.error());
      current().offset[i] = *value;
    }
    return {};
  }

  Result<void> read_channels() {
    if (current().is_end_site) return scanner_.failure("an End Site has no CHANNELS");
    if (open_.back().has_channels) return scanner_.failure("a second list of CHANNELS for the same joint");
    open_.back().has_channels = true;
    const std::string_view word = scanner_.next();
    const auto count = parse_integer(word);
    if (!count || *count < 0 || *count > 6)
      return scanner_.failure("CHANNELS needs a count from 0 to 6, found " + found(word));
    for (long i = 0; i < *count; ++i) {
      const std::string_view name = scanner_.next();
      const auto channel = channel_from_name(name);
      if (!channel)
        return scanner_.failure(found(name) + " is not a channel (Xposition ... Zrotation); " +
                                std::to_string(*count) + " were announced");
      const auto& all = current().channels;
      if (channel->kind == BvhChannel::Kind::Position && std::count(all.begin(), all.end(), *channel) > 0)
        return scanner_.failure("the channel " + in_quotes(name) + " stands twice in one joint");
      current().channels.push_back(*channel);
    }
    return {};
  }

  Result<void> close_joint() {
    if (!open_.back().has_offset) {
      const BvhJoint& joint = current();
      return scanner_.failure((joint.is_end_site ? "this End Site" : "the joint " + in_quotes(joint.name)) +
                              " has no OFFSET");
    }
    open_.pop_back();
    return {};
  }

  Result<void> hierarchy() {
    if (const auto root = expect("ROOT"); !root) return root;
    if (const auto opened = open_joint(false); !opened) return opened;
    while (!open_.empty()) {
      const std::string_view word = scanner_.next();
      Result<void> read;
      if (is_word(word, "OFFSET")) {
        read = read_offset();
      } else if (is_word(word, "CHANNELS")) {
        read = read_channels();
      } else if (is_word(word, "}")) {
        read = close_joint();
      } else if (is_word(word, "JOINT") && !current().is_end_site) {
        read = open_joint(false);
      } else if ((is_word(word, "End") || is_word(word, "EndSite")) && !current().is_end_site) {
        read = open_joint(true);
      } else {
        return scanner_.failure("expected OFFSET, CHANNELS, JOINT, End Site or }, found " + found(word));
      }
      if (!read) return read;
    }
    return {};
  }

  Result<void> motion() {
    const std::string_view word = scanner_.next();
    if (is_word(word, "ROOT"))
      return scanner_.failure("a second skeleton begins here; only files with one are supported",
                              ErrorCode::Unsupported);
    if (!is_word(word, "MOTION")) return scanner_.failure("expected MOTION, found " + found(word));
    if (const auto frames = expect("Frames:"); !frames) return frames;
    const std::string_view count_word = scanner_.next();
    const auto count = parse_integer(count_word);
    if (!count || *count < 0 || *count > 100'000'000)
      return scanner_.failure("Frames: needs a count, found " + found(count_word));
    if (*count == 0) return {};
    if (const auto frame = expect("Frame"); !frame) return frame;
    if (const auto time = expect("Time:"); !time) return time;
    const auto frame_time = number("Frame Time:");
    if (!frame_time) return tl::unexpected(frame_time.error());
    if (*frame_time < kShortestFrame_s || *frame_time > kLongestFrame_s)
      return scanner_.failure("a frame time of " + std::to_string(*frame_time) +
                              " seconds cannot be right (30 frames a second would be 0.033333)");
    document_.frame_time_s = *frame_time;
    document_.frame_count = static_cast<std::size_t>(*count);
    return read_values();
  }

  Result<void> read_values() {
    const std::size_t channels = document_.channel_count();
    const std::size_t frames = document_.frame_count;
    if (channels == 0) return scanner_.failure("there are frames, but no joint has channels");
    // Every number takes two bytes at least, so a small file cannot make us reserve much.
    document_.values.reserve(std::min(frames * channels, bytes_ / 2 + 1));
    for (std::size_t frame = 0; frame < frames; ++frame) {
      for (std::size_t channel = 0; channel < channels; ++channel) {
        double value = 0;
        if (!scanner_.next_number(value)) return bad_value(frame, channel);
        document_.values.push_back(value);
      }
      if (!scanner_.at_line_end()) return not_at_line_end(frame);
    }
    if (!scanner_.at_end()) {
      const std::string_view word = scanner_.next();
      return scanner_.failure("the file goes on with " + in_quotes(word) + " after its " +
                              std::to_string(frames) + " frames");
    }
    return {};
  }

  tl::unexpected<Error> bad_value(std::size_t frame, std::size_t channel) {
    const std::string where =
        "frame " + std::to_string(frame + 1) + " of " + std::to_string(document_.frame_count) + ", number " +
        std::to_string(channel + 1) + " of " + std::to_string(document_.channel_count());
    const std::string_view word = scanner_.next();
    if (word.empty()) return scanner_.failure("the file ends too early, in " + where);
    return scanner_.failure(in_quotes(word) + " is not a usable number (" + where + ")");
  }

  tl::unexpected<Error> not_at_line_end(std::size_t frame) {
    return scanner_.failure("frame " + std::to_string(frame + 1) +
                            " does not end with its line: the line has more or fewer than " +
                            std::to_string(document_.channel_count()) + " numbers");
  }

  TextScanner scanner_;
  std::size_t bytes_;
  BvhDocument document_;
  std::vector<Open> open_;
};

}  // namespace

std::size_t BvhDocument::channel_count() const {
  std::size_t count = 0;
  for (const BvhJoint& joint : joints) count += joint.channels.size();
  return count;
}

Result<BvhDocument> parse_bvh(std::string_view file_name, std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // a byte order mark
  return Parser(file_name, text).run();
}

}  // namespace posecoach
