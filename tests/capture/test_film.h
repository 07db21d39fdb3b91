// Small lossless films, made when a test runs: PNG pictures in a QuickTime or Matroska file.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <vector>

#include "core/image/frame.h"

namespace posecoach {

struct TestFilm {
  std::vector<Image> pictures;
  std::vector<std::int64_t> times_ms;  // as many
  // Linear part of the display matrix: a, b, c, d of x' = a x + c y, y' = b x + d y.
  std::optional<std::array<int, 4>> matrix = {};
};

// The name's ending (.mov, .mkv) names the container.
void write_test_film(const std::filesystem::path& path, const TestFilm& film);

// One second of silence as a WAV file.
void write_silence(const std::filesystem::path& path);

// Noise that differs from number to number.
Image make_test_picture(int width, int height, unsigned number);

}  // namespace posecoach
