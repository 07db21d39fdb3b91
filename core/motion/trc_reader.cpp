#include <map>

#include "core/motion/text_scanner.h"
#include "core/motion/trc.h"

namespace posecoach {
namespace {

constexpr std::size_t kMostMarkers = 4096;

// By tabs, where there are any: then an empty cell counts. Else by blanks.
std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  if (line.find('\t') == std::string_view::npos) {
    for (std::size_t at = line.find_first_not_of(' '); at < line.size();
         at = line.find_first_not_of(' ', at)) {
      const std::size_t end = std::min(line.find(' ', at), line.size());
      cells.push_back(line.substr(at, end - at));
      at = end;
    }
    return cells;
  }
  for (std::size_t at = 0; at <= line.size();) {
    const std::size_t end = std::min(line.find('\t', at), line.size());
    cells.push_back(trimmed(line.substr(at, end - at)));
    at = end + 1;
  }
  return cells;
}

// "X1 Y1 Z1 X2 ...", between the labels and the numbers.
bool is_axis_line(std::string_view line) {
  return to_lower(trimmed(line)).starts_with("x1");
}

class TrcReader {
 public:
  TrcReader(std::string_view file_name, std::string_view text) : lines_(file_name, text) {}

  Result<MarkerTrack> run() {
    if (const auto read = header(); !read) return tl::unexpected(read.error());
    if (const auto read = labels(); !read) return tl::unexpected(read.error());
    std::string_view line;
    while (lines_.next(line)) {
      if (trimmed(line).empty() || is_axis_line(line)) continue;
      if (const auto read = frame(cells_of(line)); !read) return tl::unexpected(read.error());
    }
    if (track_.times.size() < announced_frames_)
      return lines_.failure("the file ends too early, with " + std::to_string(track_.times.size()) + " of " +
                            std::to_string(announced_frames_) + " frames");
    return std::move(track_);
  }

 private:
  Result<void> header() {
    std::string_view first, keys, values;
    if (!lines_.next(first) || !trimmed(first).starts_with("PathFileType"))
      return lines_.failure("this is not a TRC file: it does not begin with PathFileType");
    if (!lines_.next(keys) || !lines_.next(values)) return lines_.failure("the file ends within its header");
    const auto names = cells_of(keys), cells = cells_of(values);
    std::map<std::string, std::string_view> fields;
    for (std::size_t i = 0; i < names.size() && i < cells.size(); ++i) fields[to_lower(names[i])] = cells[i];
    const auto count = [&](const char* name) -> Result<std::size_t> {
      const auto number = parse_number(fields[to_lower(name)]);
      if (!number || *number < 0 || *number > 1e8)
        return lines_.failure(std::string(name) + " needs a count, found " +
                              in_quotes(fields[to_lower(name)]));
      return static_cast<std::size_t>(*number);
    };
    const auto markers = count("NumMarkers"), frames = count("NumFrames");
    if (!markers) return tl::unexpected(markers.error());
    if (!frames) return tl::unexpected(frames.error());
    if (*markers > kMostMarkers) return lines_.failure("more than 4096 markers", ErrorCode::Unsupported);
    if (*markers == 0) return lines_.failure("NumMarkers is 0");
    marker_count_ = *markers;
    announced_frames_ = *frames;
    const std::map<std::string, double> units = {
        {"mm", 0.001}, {"cm", 0.01}, {"m", 1}, {"in", 0.0254}, {"inches", 0.0254}};
    if (const auto found = units.find(to_lower(fields["units"])); found != units.end())
      track_.metres_per_unit = found->second;
    return {};
  }

  Result<void> labels() {
    std::string_view line;
    if (!lines_.next(line)) return lines_.failure("the file ends within its header");
    const auto cells = cells_of(line);
    for (std::size_t i = 2; i < cells.size(); ++i)
      if (!cells[i].empty()) track_.labels.emplace_back(cells[i]);
    if (track_.labels.size() != marker_count_)
      return lines_.failure("there are " + std::to_string(track_.labels.size()) +
                            " marker names, NumMarkers is " + std::to_string(marker_count_));
    return {};
  }

  Result<void> frame(const std::vector<std::string_view>& cells) {
    const auto seconds = cells.size() > 1 ? parse_number(cells[1]) : std::nullopt;
    if (!seconds || std::abs(*seconds) > 1e8) return lines_.failure("the second cell is no time in seconds");
    const MediaTime time = media_time_from_seconds(*seconds);
    if (!track_.times.empty() && time <= track_.times.back()) return lines_.failure("time does not increase");
    const std::size_t expected = 2 + 3 * marker_count_;
    for (std::size_t i = expected; i < cells.size(); ++i)
      if (!cells[i].empty())
        return lines_.failure("the line has more than " + std::to_string(expected) + " cells");
    track_.times.push_back(time);
    for (std::size_t m = 0; m < marker_count_; ++m) {
      Vec3 position;
      int found = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t cell = 2 + 3 * m + i;
        const std::string_view text = cell < cells.size() ? cells[cell] : std::string_view();
        if (text.empty() || to_lower(text) == "nan") continue;
        const auto number = parse_number(text);
        if (!number || std::abs(*number) > kLargestNumber)
          return lines_.failure(in_quotes(text) + " in cell " + std::to_string(cell + 1) +
                                " is not a usable number");
        position[static_cast<int>(i)] = *number;
        ++found;
      }
      if (found != 0 && found != 3)
        return lines_.failure("the marker " + in_quotes(track_.labels[m]) +
                              " has only some of its coordinates");
      track_.positions.push_back(position);
      track_.seen.push_back(found == 3 ? 1 : 0);
    }
    return {};
  }

  LineReader lines_;
  MarkerTrack track_;
  std::size_t marker_count_ = 0, announced_frames_ = 0;
};

}  // namespace

Result<MarkerTrack> read_trc(std::string_view file_name, std::string_view text) {
  return TrcReader(file_name, text).run();
}

}  // namespace posecoach
