#include "core/motion/c3d_reader.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <map>
#include <optional>
#include <span>

#include "core/motion/text_scanner.h"

namespace posecoach {
namespace {

constexpr std::size_t kBlock = 512;
constexpr std::size_t kMostPoints = 4096;
constexpr std::size_t kMostParameters = 20'000;

enum class Processor { Intel = 84, Dec = 85, Mips = 86 };

// Numbers at byte positions that the caller has checked to lie inside.
class Numbers {
 public:
  Numbers(std::string_view bytes, Processor processor) : bytes_(bytes), processor_(processor) {}

  std::uint16_t word(std::size_t at) const {
    const unsigned first = byte(at), second = byte(at + 1);
    return static_cast<std::uint16_t>(processor_ == Processor::Mips ? first << 8 | second
                                                                    : second << 8 | first);
  }
  std::int16_t integer(std::size_t at) const { return static_cast<std::int16_t>(word(at)); }
  double real(std::size_t at) const {
    const std::uint32_t first = word(at), second = word(at + 2);
    switch (processor_) {
      case Processor::Intel:
        return static_cast<double>(std::bit_cast<float>(second << 16 | first));
      case Processor::Mips:
        return static_cast<double>(std::bit_cast<float>(first << 16 | second));
      case Processor::Dec:  // VAX F: the high word first, the exponent greater by two
        return static_cast<double>(std::bit_cast<float>(first << 16 | second)) / 4;
    }
    return 0;
  }
  unsigned byte(std::size_t at) const { return static_cast<unsigned char>(bytes_[at]); }

 private:
  std::string_view bytes_;
  Processor processor_;
};

struct Parameter {
  int type = 0;  // -1 text, 1 byte, 2 integer, 4 real
  std::vector<std::size_t> dimensions;
  std::size_t at = 0;  // of the first value, in the file
  std::size_t count = 0;
};

class C3dReader {
 public:
  C3dReader(std::string_view file_name, std::string_view bytes) : file_name_(file_name), bytes_(bytes) {}

  Result<MarkerTrack> run() {
    if (bytes_.size() < kBlock || static_cast<unsigned char>(bytes_[1]) != 0x50)
      return failure(0, "this is not a C3D file: it has no C3D header");
    const std::size_t parameters = (static_cast<unsigned char>(bytes_[0]) - std::size_t{1}) * kBlock;
    if (bytes_[0] == 0 || parameters + 4 > bytes_.size())
      return failure(0, "the parameters lie beyond the end of the file");
    const unsigned processor = static_cast<unsigned char>(bytes_[parameters + 3]);
    if (processor < 84 || processor > 86)
      return failure(parameters + 3,
                     "the processor type " + std::to_string(processor) + " is not known (84, 85 or 86)");
    numbers_.emplace(bytes_, static_cast<Processor>(processor));
    if (const auto read = read_parameters(parameters + 4); !read) return tl::unexpected(read.error());
    if (const auto read = read_header(); !read) return tl::unexpected(read.error());
    read_labels();
    read_units();
    return read_points();
  }

 private:
  tl::unexpected<Error> failure(std::size_t byte, const std::string& message,
                                ErrorCode code = ErrorCode::Malformed) const {
    return fail(code, std::string(file_name_) + ": byte " + std::to_string(byte) + ": " + message);
  }

  // Groups and parameters follow each other, each with the distance to the next.
  Result<void> read_parameters(std::size_t at) {
    std::map<int, std::string> groups;
    struct Pending {
      int group;
      std::string name;
      Parameter parameter;
    };
    std::vector<Pending> pending;
    for (std::size_t n = 0; at + 2 <= bytes_.size(); ++n) {
      if (n > kMostParameters) return failure(at, "more than 20000 parameters", ErrorCode::Unsupported);
      const auto length = static_cast<std::size_t>(std::abs(static_cast<signed char>(bytes_[at])));
      const int group = static_cast<signed char>(bytes_[at + 1]);
      if (length == 0 || group == 0) break;
      const std::size_t link = at + 2 + length;
      if (link + 2 > bytes_.size()) return failure(at, "a parameter's name runs over the end of the file");
      const std::string name = to_lower(trimmed(bytes_.substr(at + 2, length)));
      const std::size_t distance = numbers_->word(link);
      if (group < 0) {
        groups[-group] = name;
      } else {
        const auto parameter = read_parameter(link + 2, name);
        if (!parameter) return tl::unexpected(parameter.error());
        pending.push_back({group, name, *parameter});
      }
      if (distance == 0) break;
      at = link + distance;
    }
    for (const Pending& entry : pending)
      if (groups.contains(entry.group)) parameters_[groups[entry.group] + ':' + entry.name] = entry.parameter;
    return {};
  }

  Result<Parameter> read_parameter(std::size_t at, const std::string& name) const {
    const auto broken = [&](const std::string& what) {
      return failure(at, "the parameter " + in_quotes(name) + " " + what);
    };
    if (at + 2 > bytes_.size()) return broken("runs over the end of the file");
    Parameter parameter;
    parameter.type = static_cast<signed char>(bytes_[at]);
    if (parameter.type != -1 && parameter.type != 1 && parameter.type != 2 && parameter.type != 4)
      return broken("has the unknown type " + std::to_string(parameter.type));
    const std::size_t dimensions = numbers_->byte(at + 1);
    if (dimensions > 7 || at + 2 + dimensions > bytes_.size()) return broken("has more than 7 dimensions");
    parameter.count = 1;
    for (std::size_t d = 0; d < dimensions; ++d) {
      parameter.dimensions.push_back(numbers_->byte(at + 2 + d));
      parameter.count *= parameter.dimensions.back();
      if (parameter.count > bytes_.size()) return broken("runs over the end of the file");
    }
    parameter.at = at + 2 + dimensions;
    const auto width = static_cast<std::size_t>(std::abs(parameter.type));
    if (parameter.at + parameter.count * width > bytes_.size())
      return broken("runs over the end of the file");
    return parameter;
  }

  const Parameter* find(const std::string& name) const {
    const auto found = parameters_.find(name);
    return found == parameters_.end() ? nullptr : &found->second;
  }
  std::optional<double> number(const std::string& name) const {
    const Parameter* parameter = find(name);
    if (parameter == nullptr || parameter->count == 0) return std::nullopt;
    if (parameter->type == 4) return numbers_->real(parameter->at);
    if (parameter->type == 2) return static_cast<double>(numbers_->word(parameter->at));
    return std::nullopt;
  }
  // A text, or the lines of a table of texts.
  std::vector<std::string> texts(const std::string& name) const {
    const Parameter* parameter = find(name);
    std::vector<std::string> lines;
    if (parameter == nullptr || parameter->type != -1 || parameter->dimensions.empty()) return lines;
    const std::size_t width = parameter->dimensions[0];
    for (std::size_t done = 0; width > 0 && done + width <= parameter->count; done += width)
      lines.emplace_back(trimmed(bytes_.substr(parameter->at + done, width)));
    return lines;
  }

  Result<void> read_header() {
    point_count_ = numbers_->word(2);
    analog_count_ = numbers_->word(4);
    const std::size_t first = numbers_->word(6), last = numbers_->word(8);
    scale_ = numbers_->real(12);
    data_ = (numbers_->word(16) - std::size_t{1}) * kBlock;
    rate_ = numbers_->real(20);
    if (point_count_ == 0) return failure(2, "the file has no points", ErrorCode::Incomplete);
    if (point_count_ > kMostPoints) return failure(2, "more than 4096 points", ErrorCode::Unsupported);
    if (first == 0 || last < first) return failure(6, "the file has no frames", ErrorCode::Incomplete);
    if (numbers_->word(16) == 0 || data_ >= bytes_.size())
      return failure(16, "the data lie beyond the end of the file");
    if (!(rate_ >= 1 && rate_ <= 10'000)) rate_ = number("point:rate").value_or(0);
    if (!(rate_ >= 1 && rate_ <= 10'000)) return failure(20, "the frame rate is not between 1 and 10000");
    if (!(std::abs(scale_) > 0 && std::abs(scale_) < 1e6))
      return failure(12, "the scale of the points is no usable number");
    frame_count_ = last - first + 1;
    // The header counts to 65535; what is longer says so in a parameter.
    constexpr std::size_t kHeaderLimit = 65535;
    const double frames = number("point:frames").value_or(0);
    if (last == kHeaderLimit && frames > static_cast<double>(frame_count_) && frames < 1e8)
      frame_count_ = static_cast<std::size_t>(frames);
    return {};
  }

  void read_labels() {
    for (int table = 1; track_.labels.size() < point_count_; ++table) {
      const auto more = texts("point:labels" + (table == 1 ? std::string() : std::to_string(table)));
      if (more.empty()) break;
      track_.labels.insert(track_.labels.end(), more.begin(), more.end());
    }
    track_.labels.resize(point_count_);
  }

  void read_units() {
    const auto units = texts("point:units");
    const std::string unit = units.empty() ? "" : to_lower(units.front());
    const std::map<std::string, double> known = {{"mm", 0.001}, {"cm", 0.01}, {"m", 1}, {"in", 0.0254}};
    if (const auto found = known.find(unit); found != known.end()) track_.metres_per_unit = found->second;
  }

  Result<MarkerTrack> read_points() {
    const bool is_real = scale_ < 0;
    const std::size_t width = is_real ? 4 : 2;
    const std::size_t frame_bytes = (point_count_ * 4 + analog_count_) * width;
    const std::size_t available = (bytes_.size() - data_) / frame_bytes;
    if (available < frame_count_)
      return failure(bytes_.size(), "the file ends too early, in frame " + std::to_string(available + 1) +
                                        " of " + std::to_string(frame_count_));
    for (std::size_t f = 0; f < frame_count_; ++f) {
      track_.times.push_back(media_time_from_seconds(static_cast<double>(f) / rate_));
      for (std::size_t p = 0; p < point_count_; ++p)
        read_point(data_ + f * frame_bytes + p * 4 * width, is_real);
    }
    return std::move(track_);
  }

  void read_point(std::size_t at, bool is_real) {
    Vec3 position;
    for (int i = 0; i < 3; ++i) {
      const auto offset = at + static_cast<std::size_t>(i) * (is_real ? 4 : 2);
      position[i] = is_real ? numbers_->real(offset) : numbers_->integer(offset) * scale_;
    }
    const double residual = is_real ? numbers_->real(at + 12) : numbers_->integer(at + 6);
    constexpr double kLargest = 1e7;
    const bool is_usable =
        std::abs(position.x) < kLargest && std::abs(position.y) < kLargest && std::abs(position.z) < kLargest;
    // Some programs write zeros for a hidden marker and forget to say so.
    const bool is_seen = is_usable && residual >= 0 && position != Vec3(0);
    track_.positions.push_back(is_usable ? position : Vec3(0));
    track_.seen.push_back(is_seen ? 1 : 0);
  }

  std::string_view file_name_;
  std::string_view bytes_;
  std::optional<Numbers> numbers_;
  std::map<std::string, Parameter> parameters_;
  std::size_t point_count_ = 0, analog_count_ = 0, frame_count_ = 0, data_ = 0;
  double scale_ = 0, rate_ = 0;
  MarkerTrack track_;
};

}  // namespace

Result<MarkerTrack> read_c3d(std::string_view file_name, std::string_view bytes) {
  return C3dReader(file_name, bytes).run();
}

}  // namespace posecoach
