#include "core/transfer/paired_data.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace posecoach {
namespace {

struct Pair {
  const Character* second;
  const PoseClip* from;
  const PoseClip* to;
  std::size_t frames() const { return std::min(from->poses.size(), to->poses.size()); }
};

std::vector<Pair> ordered_pairs(const std::vector<Character>& characters) {
  std::vector<Pair> pairs;
  for (const Character& first : characters)
    for (const Character& second : characters) {
      if (&first == &second) continue;
      for (const PoseClip& from : first.clips)
        for (const PoseClip& to : second.clips)
          if (from.name == to.name) pairs.push_back({&second, &from, &to});
    }
  return pairs;
}

std::size_t any(std::mt19937_64& random, std::size_t count) {
  return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
}
CameraTurn any_view(std::mt19937_64& random) {
  return {std::uniform_real_distribution<double>(-kPi, kPi)(random), 0};
}

std::vector<Pose2d> identity_pictures(const Pair& pair, std::size_t count, std::mt19937_64& random) {
  std::vector<const PoseClip*> shown;
  for (const PoseClip& clip : pair.second->clips)
    if (clip.name != pair.to->name) shown.push_back(&clip);
  if (shown.empty()) shown.push_back(pair.to);
  std::vector<Pose2d> pictures;
  while (pictures.size() < count) {
    const PoseClip& clip = *shown[any(random, shown.size())];
    pictures.push_back(project(clip.poses[any(random, clip.poses.size())], any_view(random)));
  }
  return pictures;
}

std::vector<Pose2d> source_film(const Pair& pair, std::size_t frame, const CameraTurn& view,
                                std::size_t count) {
  std::vector<Pose2d> film = {project(pair.from->poses[frame], view)};
  for (std::size_t i = 1; i < count; ++i)
    film.push_back(project(pair.from->poses[i * pair.frames() / count], view));
  return film;
}

TransferSample sample_of(const Pair& pair, std::size_t frame, const CameraTurn& view,
                         std::vector<Pose2d> source, std::vector<Pose2d> identity) {
  TransferSample sample;
  sample.source = std::move(source);
  sample.identity = std::move(identity);
  sample.truth = project(pair.to->poses[frame], view);
  sample.oracle = project(with_bone_lengths(pair.from->poses[frame], pair.to->lengths), view);
  sample.source_lengths = pair.from->lengths;
  sample.identity_lengths = pair.to->lengths;
  sample.source_stature_m = stature_from_lengths(pair.from->lengths);
  sample.stature_m = stature_from_lengths(pair.to->lengths);
  sample.hands_touch = hands_touch(pair.from->poses[frame], sample.source_stature_m);
  return sample;
}

}  // namespace

std::vector<TransferSample> paired_samples(const std::vector<Character>& characters,
                                           const PairOptions& options) {
  std::mt19937_64 random(options.seed);
  std::vector<TransferSample> samples;
  for (const Pair& pair : ordered_pairs(characters))
    for (std::size_t i = 0; i < options.frames_per_pair; ++i) {
      const std::size_t frame = any(random, pair.frames());
      const CameraTurn view = any_view(random);
      std::vector<Pose2d> source = source_film(pair, frame, view, options.source_pictures);
      samples.push_back(sample_of(pair, frame, view, std::move(source),
                                  identity_pictures(pair, options.identity_pictures, random)));
    }
  return samples;
}

std::vector<std::vector<TransferSample>> paired_clips(const std::vector<Character>& characters,
                                                      const PairOptions& options, std::size_t frames) {
  std::mt19937_64 random(options.seed);
  std::vector<std::vector<TransferSample>> clips;
  for (const Pair& pair : ordered_pairs(characters)) {
    const CameraTurn view = any_view(random);
    const std::vector<Pose2d> identity = identity_pictures(pair, options.identity_pictures, random);
    std::vector<TransferSample> clip;
    for (std::size_t frame = 0; frame < std::min(frames, pair.frames()); ++frame) {
      // Only the first sample's film is read.
      std::vector<Pose2d> source = source_film(pair, frame, view, frame == 0 ? options.source_pictures : 1);
      clip.push_back(sample_of(pair, frame, view, std::move(source), identity));
    }
    clips.push_back(std::move(clip));
  }
  return clips;
}

double units_per_metre(const std::vector<Character>& characters) {
  double largest = 0;
  for (const Character& character : characters)
    for (const PoseClip& clip : character.clips)
      for (const Pose3d& pose : clip.poses)
        for (int turn = 0; turn < 4; ++turn) {
          const Vec2 half = 0.5 * bounding_box(project(pose, {turn * kPi / 4, 0})).size();
          largest = std::max({largest, half.x, half.y});
        }
  return largest > 0 ? 1 / largest : 1;
}

std::vector<SimilarityRow> similarity_table(const std::vector<Character>& characters, std::uint64_t seed) {
  constexpr std::size_t kFramesPerPair = 600, kNearbyFrames = 15;
  using Choice = std::function<const Pose3d&(const Pair&, std::size_t, std::mt19937_64&)>;
  const std::array<std::pair<const char*, Choice>, 3> choices = {{
      {"paired",
       [](const Pair& pair, std::size_t frame, std::mt19937_64&) -> const Pose3d& {
         return pair.to->poses[frame];
       }},
      {"similar",
       [](const Pair& pair, std::size_t frame, std::mt19937_64& random) -> const Pose3d& {
         const bool later =
             frame < kNearbyFrames || (random() % 2 == 0 && frame + kNearbyFrames < pair.frames());
         return pair.to
             ->poses[std::min(later ? frame + kNearbyFrames : frame - kNearbyFrames, pair.frames() - 1)];
       }},
      {"unpaired",
       [](const Pair& pair, std::size_t, std::mt19937_64& random) -> const Pose3d& {
         const PoseClip& clip = pair.second->clips[any(random, pair.second->clips.size())];
         return clip.poses[any(random, clip.poses.size())];
       }},
  }};
  const std::array<Links, 3> sets = {Links::Bones, Links::BonesAndEnds, Links::All};
  const std::vector<Vec2> four = projection_directions(4), two = projection_directions(2);
  std::vector<SimilarityRow> rows;
  for (const auto& [name, choose] : choices) {
    std::mt19937_64 random(seed);
    SimilarityRow row;
    row.pairs = name;
    double bones = 0, ends = 0;
    for (const Pair& pair : ordered_pairs(characters))
      for (std::size_t i = 0; i < kFramesPerPair; ++i) {
        const std::size_t frame = any(random, pair.frames());
        const CameraTurn view = any_view(random);
        const Pose2d a = project(pair.from->poses[frame], view);
        const Pose3d& other = choose(pair, frame, random);
        // Poses of other moments face elsewhere, as pictures of other moments do.
        const Pose2d b = project(other, row.pairs == "unpaired" ? any_view(random) : view);
        bones += mean_squared_angle(a, b, links(Links::Bones));
        ends += mean_squared_angle(a, b, end_effector_links());
        for (std::size_t s = 0; s < sets.size(); ++s) {
          row.four_directions[s] += violations(a, b, links(sets[s]), four);
          row.two_directions[s] += violations(a, b, links(sets[s]), two);
        }
        ++row.count;
      }
    if (row.count > 0) {
      row.angle_rms_bones = std::sqrt(bones / double(row.count));
      row.angle_rms_ends = std::sqrt(ends / double(row.count));
    }
    rows.push_back(row);
  }
  return rows;
}

}  // namespace posecoach
