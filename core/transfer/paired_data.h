// Characters performing the same motions: the real truth for transfers.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/transfer/clip_pool.h"
#include "core/transfer/pose_similarity.h"

namespace posecoach {

struct Character {
  std::string name;
  std::vector<PoseClip> clips;  // frame k of one is frame k of another character's clip of the same name
};

struct PairOptions {
  std::size_t identity_pictures = 1;
  std::size_t source_pictures = 60;   // evenly over the clip, one camera, and the pose itself
  std::size_t frames_per_pair = 120;  // poses of each ordered pair of characters and motion
  std::uint64_t seed = 1;
};
// Every ordered pair of characters with a motion in common. The identity's pictures show other motions where
// the character has any, each from another side.
std::vector<TransferSample> paired_samples(const std::vector<Character>& characters,
                                           const PairOptions& options);

// Each pair's clip frame by frame, from one camera: for scores over time.
std::vector<std::vector<TransferSample>> paired_clips(const std::vector<Character>& characters,
                                                      const PairOptions& options, std::size_t frames);

// The paper's "one global scale": every centred pose of every character from any side within (-1, 1).
double units_per_metre(const std::vector<Character>& characters);

// The paper's Table 1: how alike the measures find the same pose on two people (paired), a pose a quarter of
// a second away (similar) and any other pose (unpaired).
struct SimilarityRow {
  std::string pairs;
  long count = 0;
  double angle_rms_bones = 0, angle_rms_ends = 0;
  std::array<LinkCount, 3> four_directions, two_directions;  // bones, bones and ends, all
};
std::vector<SimilarityRow> similarity_table(const std::vector<Character>& characters, std::uint64_t seed);

}  // namespace posecoach
