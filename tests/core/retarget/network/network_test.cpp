#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <glm/geometric.hpp>
#include <set>
#include <sstream>

#include "core/body/standard_body.h"
#include "core/retarget/network/correction_trainer.h"
#include "core/retarget/network/paper_inference.h"
#include "core/retarget/network/paper_losses.h"
#include "tests/core/retarget/motions.h"
#include "tests/support/temporary_folder.h"

namespace posecoach {
namespace {

std::set<int> joints_of(const BodyLayout& layout, BodySegment segment) {
  const std::vector<int> joints = layout.joints_of(segment);
  return {joints.begin(), joints.end()};
}

std::vector<TurnClip> random_clips(int count, int frames) {
  std::vector<TurnClip> clips;
  for (int i = 0; i < count; ++i)
    clips.push_back(
        *make_turn_clip("clip", random_motion(make_standard_body(), frames, static_cast<unsigned>(i + 1))));
  return clips;
}

BodyBatch random_batch(BodyLayoutKind kind, int count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<RoleBody> bodies;
  for (int i = 0; i < count; ++i) bodies.push_back(random_role_body(random));
  return make_body_batch(kind, random_clips(count, 32), bodies);
}

TEST(BodyLayout, has_the_joints_of_the_paper_and_every_joint_but_the_root_a_segment) {
  EXPECT_EQ(BodyLayout::of(BodyLayoutKind::Split28).size(), 28);
  EXPECT_EQ(BodyLayout::of(BodyLayoutKind::OldRig23).size(), 23);
  EXPECT_EQ(BodyLayout::of(BodyLayoutKind::Webcam38).size(), 38);
  for (const BodyLayoutKind kind : kBodyLayoutKinds)
    for (int j = 1; j < BodyLayout::of(kind).size(); ++j) {
      const LayoutJoint& joint = BodyLayout::of(kind).joints()[static_cast<std::size_t>(j)];
      EXPECT_FALSE(joint.segments.empty()) << joint.name;
      EXPECT_LT(joint.parent, j);
    }
}

TEST(PaperNetwork, features_of_a_segment_hear_its_own_joints_and_the_roots_path_only) {
  torch::manual_seed(1);
  const PaperNetworkOptions options;
  for (const BodyLayoutKind kind : kBodyLayoutKinds) {
    const BodyLayout& layout = BodyLayout::of(kind);
    StructureNetwork network(kind, options);
    for (int64_t segment = 0; segment < kSegments; ++segment) {
      const std::set<int> own = joints_of(layout, static_cast<BodySegment>(segment));
      const torch::Tensor rows = torch::randn({1, 16, layout.size() + 1, 3}).set_requires_grad(true);
      network->motion(rows).narrow(1, segment * options.width, options.width).square().sum().backward();
      const torch::Tensor heard = rows.grad().abs().sum(torch::IntArrayRef({0, 1, 3}));
      for (int j = 0; j < layout.size(); ++j)
        EXPECT_EQ(heard[j].item<float>() > 0, own.count(j) == 1) << "segment " << segment << " joint " << j;
      EXPECT_GT(heard[layout.size()].item<float>(), 0);

      const torch::Tensor bones = torch::randn({1, layout.size(), 3}).set_requires_grad(true);
      network->skeleton(bones).narrow(1, segment * options.width, options.width).square().sum().backward();
      const torch::Tensor of_bones = bones.grad().abs().sum(torch::IntArrayRef({0, 2}));
      for (int j = 0; j < layout.size(); ++j)
        EXPECT_EQ(of_bones[j].item<float>() > 0, own.count(j) == 1)
            << "segment " << segment << " joint " << j;
    }
  }
}

TEST(PaperNetwork, rotations_of_a_joint_hear_its_own_segments_and_the_root_all) {
  torch::manual_seed(2);
  const PaperNetworkOptions options;
  const BodyLayout& layout = BodyLayout::of(BodyLayoutKind::Split28);
  StructureNetwork network(BodyLayoutKind::Split28, options);
  const auto heard_segments = [&](const std::function<torch::Tensor(const DecodedMotion&)>& part) {
    const torch::Tensor features = torch::randn({1, kSegments * options.width, 4}).set_requires_grad(true);
    part(network->decoder(features)).square().sum().backward();
    std::set<int64_t> heard;
    for (int64_t s = 0; s < kSegments; ++s)
      if (features.grad().narrow(1, s * options.width, options.width).abs().sum().item<float>() > 0)
        heard.insert(s);
    return heard;
  };
  for (int j = 1; j < layout.size(); ++j) {
    std::set<int64_t> own;
    for (const BodySegment segment : layout.joints()[static_cast<std::size_t>(j)].segments)
      own.insert(static_cast<int64_t>(segment));
    EXPECT_EQ(
        heard_segments([&](const DecodedMotion& m) { return m.rotations.select(2, j - 1).select(-1, 1); }),
        own)
        << layout.joints()[static_cast<std::size_t>(j)].name;
  }
  EXPECT_EQ(heard_segments([](const DecodedMotion& m) { return m.root; }).size(), 6U);
}

TEST(PaperNetwork, forward_kinematics_puts_turned_bones_where_the_body_is) {
  const BodyBatch batch = random_batch(BodyLayoutKind::OldRig23, 2, 3);
  const torch::Tensor off = turned_bones(batch.rest_bones, batch.motion.rotations) - batch.motion.bones;
  EXPECT_LT(off.abs().max().item<float>(), 1e-5F);
}

TEST(PaperLosses, vanish_where_the_answer_is_right_and_follow_their_switches) {
  torch::manual_seed(3);
  PaperNetwork network{PaperNetworkOptions()};
  const BodyBatch source = random_batch(BodyLayoutKind::Split28, 2, 5);
  const BodyBatch target = random_batch(BodyLayoutKind::OldRig23, 2, 6);
  MotionDiscriminator judge(BodyLayout::of(BodyLayoutKind::OldRig23));
  PaperLossOptions options;
  const PaperLosses all = paper_losses(*network, judge, source, target, options);
  EXPECT_TRUE(std::isfinite(all.total(options).item<double>()));
  options.reconstruct_rows = false;
  options.cycle_root = true;
  options.discriminator = false;
  const PaperLosses other = paper_losses(*network, judge, source, target, options);
  EXPECT_LT(other.reconstruction.item<double>(), all.reconstruction.item<double>());
  EXPECT_GT(other.cycle.item<double>(), all.cycle.item<double>());
  EXPECT_EQ(other.adversarial.item<double>(), 0);
  EXPECT_EQ(local_error(*network->of(source.kind), source.motion, source.motion), 0);
}

TEST(PaperNetwork, follows_the_world_when_it_is_turned_and_shifted) {
  torch::manual_seed(4);
  PaperNetwork network{PaperNetworkOptions()};
  const Motion coach = random_motion(make_standard_body(), 40, 7);
  const Skeleton body = make_standard_body({.height_m = 1.5, .arms = 1.2});
  const Quat yaw(glm::angleAxis(1.1, Vec3(0, 1, 0)));
  const Vec3 shift(0.4, 0, -1.0);
  const auto here = carried_by(network, coach, body),
             there = carried_by(network, transformed(coach, yaw, shift), body);
  ASSERT_TRUE(here && there);
  const double scale = body.leg_length() / coach.skeleton().leg_length();
  double worst = 0;
  for (int f = 0; f < coach.frame_count(); ++f)
    for (int j = 0; j < body.size(); ++j)
      worst =
          std::max(worst, glm::distance(there->position(f, j), yaw * here->position(f, j) + scale * shift));
  EXPECT_LT(worst, 2e-4);
}

TEST(PaperNetwork, takes_motions_of_any_length_and_keeps_bones_and_times) {
  torch::manual_seed(5);
  PaperNetwork network{PaperNetworkOptions()};
  const Skeleton body = make_standard_body({.height_m = 1.6, .thighs = 1.1});
  for (const int frames : {1, 3, 17, 200}) {
    const Motion coach = random_motion(make_standard_body(), frames, 8);
    const auto carried = carried_by(network, coach, body);
    ASSERT_TRUE(carried) << carried.error().message;
    EXPECT_EQ(carried->frame_count(), frames);
    EXPECT_EQ(carried->time(frames - 1), coach.time(frames - 1));
    for (int j = 1; j < body.size(); ++j)
      EXPECT_NEAR(glm::distance(carried->position(frames - 1, j),
                                carried->position(frames - 1, body.joint(j).parent)),
                  body.bone_length(j), 1e-9);
  }
  const Motion coach = random_motion(make_standard_body(), 32, 9);
  ASSERT_TRUE(carried_by(network, coach, test_landmark_body(1)));
  ASSERT_TRUE(carried_by(network, *carried_by(network, coach, test_landmark_body(1)), body));
}

TEST(Weights, come_back_as_they_went_and_a_cut_file_is_refused) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "w.pt";
  torch::manual_seed(6);
  CorrectionNetwork network{CorrectionNetworkOptions()}, other{CorrectionNetworkOptions()};
  ASSERT_TRUE(write_weights(path, {kCorrectionWeightsKind, {{"answer", 42}}, tensors_of(*network)}));
  const auto read = read_weights(path);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->kind, kCorrectionWeightsKind);
  EXPECT_EQ(read->numbers.at("answer"), 42);
  ASSERT_TRUE(load_tensors(*other, read->tensors, "w.pt"));
  const torch::Tensor values = torch::randn({1, kCorrectionValues, 9});
  const torch::Tensor steadier =
      torch::randn({1, 9, static_cast<int64_t>(kHumanoidJointCount), kSteadyTurns, 3});
  EXPECT_TRUE(torch::equal(network(values, steadier), other(values, steadier)));
  PaperNetwork paper{PaperNetworkOptions()};
  EXPECT_EQ(load_tensors(*paper, read->tensors, "w.pt").error().code, ErrorCode::Malformed);
  std::filesystem::resize_file(path, 1000);
  EXPECT_EQ(read_weights(path).error().code, ErrorCode::Malformed);
}

template <typename T>
void expect_resumed_training_to_go_the_same_way() {
  TrainingOptions options;
  options.batch = 2;
  const ClipSplit clips{random_clips(2, 70), random_clips(1, 80)};
  const auto step = [](Trainee& trainee, std::uint64_t number) {
    std::mt19937_64 random(number);
    return trainee.step(1.0, random)[0].second;
  };
  T straight(clips, options);
  step(straight, 1);
  std::stringstream bytes;
  torch::serialize::OutputArchive out;
  straight.save(out);
  out.save_to(bytes);
  const double expected = step(straight, 2);
  T resumed(clips, options);
  torch::serialize::InputArchive in;
  in.load_from(bytes);
  resumed.load(in);
  EXPECT_EQ(step(resumed, 2), expected);
  const double error = resumed.validate()[0].second;
  EXPECT_TRUE(std::isfinite(error) && error > 0);
}

TEST(Training, of_the_papers_network_resumes_where_it_stopped) {
  expect_resumed_training_to_go_the_same_way<PaperTrainee>();
}

TEST(Training, of_the_correction_resumes_where_it_stopped) {
  expect_resumed_training_to_go_the_same_way<CorrectionTrainee>();
}

}  // namespace
}  // namespace posecoach
