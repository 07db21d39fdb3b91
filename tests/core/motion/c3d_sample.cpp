#include "c3d_sample.h"

#include <bit>
#include <cmath>
#include <cstdint>

namespace posecoach::samples {
namespace {

class Bytes {
 public:
  explicit Bytes(int processor) : processor_(processor) {}

  std::string out;

  void byte(int value) { out += static_cast<char>(value); }
  void word(int value) {
    const int low = value & 255, high = value >> 8 & 255;
    byte(processor_ == 86 ? high : low);
    byte(processor_ == 86 ? low : high);
  }
  void real(double value) {
    // VAX F numbers have an exponent greater by two and the high word first.
    const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(processor_ == 85 ? value * 4 : value));
    const int high = static_cast<int>(bits >> 16), low = static_cast<int>(bits & 0xFFFF);
    word(processor_ == 84 ? low : high);
    word(processor_ == 84 ? high : low);
  }
  void fill_block() { out.resize((out.size() + 511) / 512 * 512, '\0'); }

  void group(int id, const std::string& name) {
    byte(static_cast<int>(name.size()));
    byte(-id);
    out += name;
    word(3);  // to the next, over the length of the description
    byte(0);
  }
  void parameter(int id, const std::string& name, int type, const std::vector<int>& dimensions,
                 const std::string& data) {
    byte(static_cast<int>(name.size()));
    byte(id);
    out += name;
    word(static_cast<int>(2 + 2 + dimensions.size() + data.size() + 1));
    byte(type);
    byte(static_cast<int>(dimensions.size()));
    for (const int size : dimensions) byte(size);
    out += data;
    byte(0);
  }

 private:
  int processor_;
};

std::string table(const std::vector<std::string>& lines, std::size_t width) {
  std::string text;
  for (std::string line : lines) {
    line.resize(width, ' ');
    text += line;
  }
  return text;
}

}  // namespace

std::string c3d_bytes(const C3dSample& sample) {
  const int points = static_cast<int>(sample.labels.size());
  const int frames = static_cast<int>(sample.positions.size()) / points;
  Bytes parameters(sample.processor);
  parameters.out = {1, 0x50, 4};
  parameters.byte(sample.processor);
  parameters.group(1, "POINT");
  constexpr std::size_t kWidth = 16;
  parameters.parameter(1, "LABELS", -1, {kWidth, points}, table(sample.labels, kWidth));
  parameters.parameter(1, "UNITS", -1, {4}, table({sample.units}, 4));
  parameters.word(0);
  parameters.fill_block();

  Bytes file(sample.processor);
  file.byte(2);
  file.byte(0x50);
  file.word(points);
  file.word(sample.analog_samples);
  file.word(1);
  file.word(frames);
  file.word(10);
  file.real(sample.as_integers ? sample.scale : -sample.scale);
  file.word(2 + static_cast<int>(parameters.out.size() / 512));
  file.word(1);
  file.real(sample.rate);
  file.fill_block();
  file.out += parameters.out;
  for (int f = 0; f < frames; ++f) {
    for (int p = 0; p < points; ++p) {
      const Vec3& v = sample.positions[static_cast<std::size_t>(f * points + p)];
      const bool is_hidden = std::isnan(v.x);
      for (int i = 0; i < 3; ++i) {
        const double value = is_hidden ? 0 : v[i];
        if (sample.as_integers)
          file.word(static_cast<int>(std::lround(value / sample.scale)) & 0xFFFF);
        else
          file.real(value);
      }
      if (sample.as_integers)
        file.word(is_hidden ? 0xFFFF : 0);
      else
        file.real(is_hidden ? -1 : 0);
    }
    for (int a = 0; a < sample.analog_samples; ++a) {
      if (sample.as_integers)
        file.word(a);
      else
        file.real(a);
    }
  }
  return file.out;
}

}  // namespace posecoach::samples
