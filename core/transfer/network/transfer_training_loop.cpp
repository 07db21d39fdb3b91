#include "core/transfer/network/transfer_training_loop.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <sstream>

#include "core/base/file.h"
#include "core/transfer/training_log.h"

namespace posecoach {
namespace {

constexpr std::size_t kHeldOutEvery = 8;
constexpr std::size_t kValidationSamples = 240;
constexpr std::uint64_t kValidationSeed = 20211101;
constexpr double kValidationEvery_s = 90;
// Where cores are scarce a validation may itself take that long; it shall not take all the time there is.
constexpr double kLargestValidationShare = 0.1;
constexpr double kLeastRate = 0.02;

std::filesystem::path beside(const std::filesystem::path& weights, const char* ending) {
  std::filesystem::path path = weights;
  return path.replace_extension(ending);
}

std::vector<TransferSample> validation_samples(const PoseClipPool& pool, std::size_t pictures) {
  std::mt19937_64 random(kValidationSeed + pictures);
  SampleOptions options;
  options.identity_pictures = pictures;
  options.source_pictures = 32;
  std::vector<TransferSample> samples;
  for (std::size_t i = 0; i < kValidationSamples; ++i)
    samples.push_back(random_sample(pool, random, options));
  return samples;
}

void write_number(torch::serialize::OutputArchive& archive, const char* name, double value) {
  archive.write(name, torch::tensor({value}, torch::kFloat64));
}
double read_number(torch::serialize::InputArchive& archive, const char* name) {
  torch::Tensor value;
  archive.read(name, value);
  return value.item<double>();
}

class Loop {
 public:
  Loop(TransferTrainee& trainee, const PoseClipPool& held_out, const TransferTrainingOptions& options)
      : trainee_(trainee),
        options_(options),
        one_(validation_samples(held_out, 1)),
        eight_(validation_samples(held_out, 8)),
        log_(beside(options.weights, ".csv"), columns(trainee)) {}

  Result<TransferTrainingSummary> run() {
    if (Result<void> resumed = resume(); !resumed) return tl::unexpected(resumed.error());
    const double minutes_before = summary_.minutes;
    const auto began = std::chrono::steady_clock::now();
    const auto seconds_since = [&] {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    };
    double next_validation_s = kValidationEvery_s;
    while (true) {
      const double seconds = seconds_since();
      summary_.minutes = minutes_before + seconds / 60;
      const double of_time = options_.minutes > 0 ? seconds / 60 / options_.minutes : 1;
      const double of_iterations =
          options_.iterations > 0 ? double(summary_.iterations) / double(options_.iterations) : 0;
      const double done = std::max(of_time, of_iterations);
      if (summary_.iterations % 8 == 0)
        summary_.stopped = !report(options_.progress, stage(), std::min(done, 1.0));
      if (done >= 1 || summary_.stopped) break;
      if (seconds > next_validation_s) {
        if (Result<void> kept = keep(); !kept) return tl::unexpected(kept.error());
        const double now = seconds_since();
        next_validation_s = now + std::max(kValidationEvery_s, (now - seconds) / kLargestValidationShare);
      }
      step(done);
    }
    if (Result<void> kept = keep(); !kept) return tl::unexpected(kept.error());
    return summary_;
  }

 private:
  static std::vector<std::string> columns(const TransferTrainee& trainee) {
    std::vector<std::string> names = {"iteration", "minutes"};
    for (const std::string& name : trainee.loss_names()) names.push_back("loss_" + name);
    for (const char* name : {"oks_1", "joints_1", "oks_8", "joints_8"}) names.emplace_back(name);
    return names;
  }

  std::string stage() const {
    char text[96];
    std::snprintf(text, sizeof text, "iteration %ld, best OKS %.1f %%", summary_.iterations,
                  summary_.best_score);
    return text;
  }

  void step(double done) {
    std::mt19937_64 random(options_.seed * 1000003 + static_cast<std::uint64_t>(summary_.iterations));
    const double rate = kLeastRate + (1 - kLeastRate) * 0.5 * (1 + std::cos(kPi * done));
    const std::vector<double> losses = trainee_.step(summary_.iterations, rate, random);
    loss_sums_.resize(losses.size());
    for (std::size_t i = 0; i < losses.size(); ++i) loss_sums_[i] += losses[i];
    ++steps_since_;
    ++summary_.iterations;
  }

  // Validates, logs, keeps the best weights and a checkpoint.
  Result<void> keep() {
    if (steps_since_ == 0) return {};
    const std::unique_ptr<Transferer> averaged = trainee_.averaged();
    const TransferScore one = score(*averaged, one_), eight = score(*averaged, eight_);
    std::vector<double> row = {double(summary_.iterations), summary_.minutes};
    for (double& sum : loss_sums_) {
      row.push_back(sum / double(steps_since_));
      sum = 0;
    }
    steps_since_ = 0;
    row.insert(row.end(), {one.error.oks_percent, one.error.mse_joints, eight.error.oks_percent,
                           eight.error.mse_joints});
    log_.add(std::move(row));
    const double value = 0.5 * (one.error.oks_percent + eight.error.oks_percent);
    if (value > summary_.best_score) {
      summary_.best_score = value;
      summary_.best_iteration = summary_.iterations;
      if (Result<void> written = write_file_atomically(options_.weights, trainee_.weights()); !written)
        return written;
    }
    if (Result<void> written = log_.write(beside(options_.weights, ".png")); !written) return written;
    torch::serialize::OutputArchive archive;
    write_number(archive, "iterations", double(summary_.iterations));
    write_number(archive, "minutes", summary_.minutes);
    write_number(archive, "best_score", summary_.best_score);
    write_number(archive, "best_iteration", double(summary_.best_iteration));
    trainee_.save(archive);
    std::ostringstream stream;
    archive.save_to(stream);
    return write_file_atomically(beside(options_.weights, ".checkpoint"), stream.str());
  }

  Result<void> resume() {
    const std::filesystem::path path = beside(options_.weights, ".checkpoint");
    if (!options_.resume) return {};
    const Result<std::string> bytes = read_file(path);
    if (!bytes) return tl::unexpected(bytes.error());
    try {
      std::istringstream stream(*bytes);
      torch::serialize::InputArchive archive;
      archive.load_from(stream);
      summary_.iterations = std::lround(read_number(archive, "iterations"));
      summary_.minutes = read_number(archive, "minutes");
      summary_.best_score = read_number(archive, "best_score");
      summary_.best_iteration = std::lround(read_number(archive, "best_iteration"));
      trainee_.load(archive);
    } catch (const std::exception&) {
      return fail(ErrorCode::Malformed,
                  path.string() + ": not a checkpoint of this training; start it without --resume");
    }
    return log_.resume(double(summary_.iterations));
  }

  TransferTrainee& trainee_;
  const TransferTrainingOptions& options_;
  std::vector<TransferSample> one_, eight_;
  TransferTrainingLog log_;
  TransferTrainingSummary summary_;
  std::vector<double> loss_sums_;
  long steps_since_ = 0;
};

}  // namespace

Result<TransferTrainingSummary> run_transfer_training(TransferTrainee& trainee, const PoseClipPool& held_out,
                                                      const TransferTrainingOptions& options) {
  try {
    return Loop(trainee, held_out, options).run();
  } catch (const c10::Error& error) {
    return fail(ErrorCode::Internal, "the training failed in libtorch: " + error.msg());
  } catch (const std::exception& error) {
    return fail(ErrorCode::Internal, std::string("the training failed in libtorch: ") + error.what());
  }
}

Result<std::pair<PoseClipPool, PoseClipPool>> held_out_and_training(std::vector<PoseClip> clips) {
  if (clips.size() < kHeldOutEvery)
    return fail(ErrorCode::Incomplete, "training needs at least " + std::to_string(kHeldOutEvery) +
                                           " motions, of which some are held out; there are " +
                                           std::to_string(clips.size()));
  std::sort(clips.begin(), clips.end(), [](const PoseClip& a, const PoseClip& b) { return a.name < b.name; });
  auto [held_out, rest] = PoseClipPool::split(std::move(clips), kHeldOutEvery);
  return std::pair{PoseClipPool(std::move(held_out)), PoseClipPool(std::move(rest))};
}

}  // namespace posecoach
