#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "core/motion/asf_amc_reader.h"
#include "core/motion/text_scanner.h"

namespace posecoach {
namespace {

constexpr std::size_t kMostBones = 4096;
constexpr double kMetresPerInch = 0.0254;

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  constexpr std::string_view kBlanks = " \t\v\f";
  for (std::size_t at = line.find_first_not_of(kBlanks); at != std::string_view::npos;
       at = line.find_first_not_of(kBlanks, at)) {
    const std::size_t end = std::min(line.find_first_of(kBlanks, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = end;
  }
  return words;
}

using Words = std::vector<std::string_view>;

// A bone as it stands in the file; angles may come before the file says their unit.
struct RawBone {
  std::string name;
  Vec3 direction;
  double length = 0;
  Vec3 axis_angles;
  std::string axis_order = "xyz";
  std::vector<Axis> turns;
  std::size_t line = 0;
};

class AsfParser {
 public:
  AsfParser(std::string_view file_name, std::string_view text)
      : lines_(file_name, text), file_name_(file_name) {
    root_.name = "root";
  }

  Result<AsfDocument> run() {
    std::string_view line;
    while (lines_.next(line)) {
      const Words words = words_of(trimmed(line));
      if (words.empty() || words[0].starts_with('#')) continue;
      Result<void> read;
      if (words[0].starts_with(':'))
        section_ = to_lower(words[0]);
      else if (section_ == ":units")
        read = units(words);
      else if (section_ == ":root")
        read = root(words);
      else if (section_ == ":bonedata")
        read = bone_data(words);
      else if (section_ == ":hierarchy")
        read = hierarchy(words);
      else if (section_.empty())
        return lines_.failure("this is not an ASF file: expected a section such as :units, found " +
                              in_quotes(words[0]));
      if (!read) return tl::unexpected(read.error());
    }
    if (open_) return lines_.failure("the file ends within a bone or the hierarchy");
    if (children_.empty()) return lines_.failure("the file has no :hierarchy");
    return document();
  }

 private:
  Result<double> number(const Words& words, std::size_t at) const {
    const auto value = at < words.size() ? parse_number(words[at]) : std::nullopt;
    if (!value || std::abs(*value) > kLargestNumber)
      return lines_.failure(std::string(words[0]) + " needs a number" +
                            (at < words.size() ? ", found " + in_quotes(words[at]) : ""));
    return *value;
  }
  Result<Vec3> vector(const Words& words) const {
    Vec3 v;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto value = number(words, 1 + i);
      if (!value) return tl::unexpected(value.error());
      v[static_cast<int>(i)] = *value;
    }
    return v;
  }
  Result<std::string> axis_order(std::string_view word) const {
    std::string order = to_lower(word), sorted = order;
    std::sort(sorted.begin(), sorted.end());
    if (sorted != "xyz") return lines_.failure(in_quotes(word) + " is no order of the axes X, Y and Z");
    return order;
  }

  Result<void> units(const Words& words) {
    const std::string key = to_lower(words[0]);
    if (key == "angle" && words.size() > 1) {
      document_.degrees = !to_lower(words[1]).starts_with("rad");
    } else if (key == "length") {
      const auto length = number(words, 1);
      if (!length) return tl::unexpected(length.error());
      if (*length <= 0) return lines_.failure("the unit of length must be greater than 0");
      document_.metres_per_unit = kMetresPerInch / *length;
    }
    return {};
  }

  Result<void> root(const Words& words) {
    const std::string key = to_lower(words[0]);
    if (key == "order") {
      document_.root_order.clear();
      for (std::size_t i = 1; i < words.size(); ++i) {
        const std::string name = to_lower(words[i]);
        if (name.size() != 2 || (name[0] != 't' && name[0] != 'r') || name[1] < 'x' || name[1] > 'z')
          return lines_.failure(in_quotes(words[i]) + " is no degree of freedom of the root (TX ... RZ)");
        document_.root_order.push_back((name[0] == 'r' ? 3 : 0) + name[1] - 'x');
      }
      if (words.size() > 7) return lines_.failure("the root has more than 6 degrees of freedom");
    } else if (key == "axis") {
      if (words.size() < 2) return lines_.failure("axis needs an order of the axes");
      const auto order = axis_order(words[1]);
      if (!order) return tl::unexpected(order.error());
      root_.axis_order = *order;
    } else if (key == "position" || key == "orientation") {
      const auto v = vector(words);
      if (!v) return tl::unexpected(v.error());
      (key == "position" ? document_.root_position : root_.axis_angles) = *v;
    }
    return {};
  }

  Result<void> bone_data(const Words& words) {
    const std::string key = to_lower(words[0]);
    if (key == "begin") {
      if (open_) return lines_.failure("a bone begins within another");
      if (bones_.size() >= kMostBones) return lines_.failure("more than 4096 bones", ErrorCode::Unsupported);
      open_ = true;
      bones_.push_back({});
      bones_.back().line = lines_.line();
      return {};
    }
    if (!open_) return lines_.failure("expected begin, found " + in_quotes(words[0]));
    RawBone& bone = bones_.back();
    if (key == "end") {
      if (bone.name.empty()) return lines_.failure("this bone has no name");
      open_ = false;
    } else if (key == "name") {
      if (words.size() < 2) return lines_.failure("name needs a name");
      bone.name = words[1];
      if (bone.name == root_.name || std::count_if(bones_.begin(), bones_.end(),
                                                   [&](const RawBone& b) { return b.name == bone.name; }) > 1)
        return lines_.failure("a second bone is called " + in_quotes(bone.name));
    } else if (key == "direction") {
      const auto v = vector(words);
      if (!v) return tl::unexpected(v.error());
      bone.direction = *v;
    } else if (key == "length") {
      const auto length = number(words, 1);
      if (!length) return tl::unexpected(length.error());
      bone.length = *length;
    } else if (key == "axis") {
      const auto v = vector(words);
      if (!v) return tl::unexpected(v.error());
      bone.axis_angles = *v;
      if (words.size() > 4) {
        const auto order = axis_order(words[4]);
        if (!order) return tl::unexpected(order.error());
        bone.axis_order = *order;
      }
    } else if (key == "dof") {
      for (std::size_t i = 1; i < words.size(); ++i) {
        const std::string name = to_lower(words[i]);
        if (name.size() != 2 || name[0] != 'r' || name[1] < 'x' || name[1] > 'z')
          return lines_.failure("the degree of freedom " + in_quotes(words[i]) +
                                    " is not supported: bones may turn (rx, ry, rz), not move or stretch",
                                ErrorCode::Unsupported);
        bone.turns.push_back(static_cast<Axis>(name[1] - 'x'));
      }
      if (bone.turns.size() > 3) return lines_.failure("a bone turns about at most 3 axes");
    }
    return {};
  }

  Result<void> hierarchy(const Words& words) {
    const std::string key = to_lower(words[0]);
    if (key == "begin") {
      open_ = true;
      return {};
    }
    if (key == "end") {
      open_ = false;
      return {};
    }
    for (std::size_t i = 1; i < words.size(); ++i) {
      for (const std::string_view name : {words[0], words[i]})
        if (name != root_.name && !find(name)) return lines_.failure("there is no bone " + in_quotes(name));
      if (words[i] == root_.name || !parents_.emplace(std::string(words[i]), std::string(words[0])).second)
        return lines_.failure(in_quotes(words[i]) + " has two parents");
      children_[std::string(words[0])].emplace_back(words[i]);
    }
    return {};
  }

  const RawBone* find(std::string_view name) const {
    const auto found =
        std::find_if(bones_.begin(), bones_.end(), [&](const RawBone& b) { return b.name == name; });
    return found == bones_.end() ? nullptr : &*found;
  }

  Quat turn(const Vec3& angles, const std::string& order) const {
    Quat q(1, 0, 0, 0);
    for (const char axis : order) {
      const double angle = angles[axis - 'x'];
      q = rotation_about(static_cast<Axis>(axis - 'x'),
                         document_.degrees ? radians_from_degrees(angle) : angle) *
          q;
    }
    return q;
  }

  // Bones from the root outwards; what does not hang on it is left out.
  Result<AsfDocument> document() {
    if (document_.root_order.empty()) document_.root_order = {0, 1, 2, 3, 4, 5};
    document_.bones.push_back({root_.name, -1, Vec3(0), turn(root_.axis_angles, root_.axis_order), {}});
    for (std::size_t at = 0; at < document_.bones.size(); ++at) {
      for (const std::string& child : children_[document_.bones[at].name]) {
        const RawBone& raw = *find(child);
        const double length = glm::length(raw.direction);
        if (length <= 0 && raw.length > 0)
          return fail(ErrorCode::Malformed, std::string(file_name_) + ":" + std::to_string(raw.line) +
                                                ": the bone " + in_quotes(raw.name) + " has no direction");
        const Vec3 end = length > 0 ? raw.direction / length * raw.length : Vec3(0);
        document_.bones.push_back(
            {raw.name, static_cast<int>(at), end, turn(raw.axis_angles, raw.axis_order), raw.turns});
      }
    }
    return std::move(document_);
  }

  LineReader lines_;
  std::string_view file_name_;
  std::string section_;
  bool open_ = false;  // between begin and end
  RawBone root_;
  std::vector<RawBone> bones_;
  std::map<std::string, std::string> parents_;
  std::map<std::string, std::vector<std::string>> children_;
  AsfDocument document_;
};

}  // namespace

bool is_asf(std::string_view text) {
  return to_lower(text.substr(0, 1 << 16)).find(":bonedata") != std::string::npos;
}

Result<AsfDocument> parse_asf(std::string_view file_name, std::string_view text) {
  return AsfParser(file_name, text).run();
}

}  // namespace posecoach
