#include "core/retarget/network/training_loop.h"

#include <cmath>
#include <ctime>
#include <limits>
#include <sstream>

#include "core/base/file.h"
#include "core/base/log.h"
#include "core/image/curves.h"
#include "core/retarget/network/one_thread.h"

namespace posecoach {
namespace {

namespace fs = std::filesystem;

fs::path beside(const fs::path& weights, const char* ending) {
  fs::path path = weights;
  path += ending;
  return path;
}

struct State {
  int64_t iteration = 0;
  double seconds = 0;
  double best_error = std::numeric_limits<double>::infinity();
  std::string csv;
};

Result<void> save_checkpoint(const fs::path& path, Trainee& trainee, const State& state) {
  try {
    torch::serialize::OutputArchive archive;
    archive.write("iteration", torch::IValue(state.iteration));
    archive.write("seconds", torch::IValue(state.seconds));
    archive.write("best_error", torch::IValue(state.best_error));
    archive.write("csv", torch::IValue(state.csv));
    trainee.save(archive);
    std::ostringstream bytes;
    archive.save_to(bytes);
    return write_file_atomically(path, bytes.str());
  } catch (const std::exception& error) {
    return fail(ErrorCode::Internal, path.string() + ": cannot be written: " + error.what());
  }
}

Result<State> load_checkpoint(const fs::path& path, Trainee& trainee) {
  const Result<std::string> bytes = read_file(path, std::size_t{1} << 32);
  if (!bytes) return tl::unexpected(bytes.error());
  try {
    std::istringstream stream(*bytes);
    torch::serialize::InputArchive archive;
    archive.load_from(stream);
    State state;
    torch::IValue value;
    archive.read("iteration", value);
    state.iteration = value.toInt();
    archive.read("seconds", value);
    state.seconds = value.toDouble();
    archive.read("best_error", value);
    state.best_error = value.toDouble();
    archive.read("csv", value);
    state.csv = value.toStringRef();
    trainee.load(archive);
    return state;
  } catch (const std::exception&) {
    return fail(ErrorCode::Malformed,
                path.string() + ": not a checkpoint of this training; start again without --resume");
  }
}

// Of a core, so that other work on the machine does not shorten the training.
double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// Means of what was added since the last `take`.
class RunningMeans {
 public:
  void add(const NamedValues& values) {
    sums_.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      sums_[i].first = values[i].first;
      sums_[i].second += values[i].second;
    }
    ++count_;
  }
  NamedValues take() {
    NamedValues means = std::exchange(sums_, {});
    for (auto& [name, value] : means) value /= count_;
    count_ = 0;
    return means;
  }

 private:
  NamedValues sums_;
  double count_ = 0;
};

std::string csv_line(const TrainingReport& report) {
  std::ostringstream line;
  line << report.iteration << ',' << report.minutes;
  for (const auto& [name, value] : report.values) line << ',' << value;
  return line.str() + "\n";
}

std::string csv_header(const TrainingReport& report) {
  std::string line = "iteration,minutes";
  for (const auto& [name, value] : report.values) line += "," + name;
  return line + "\n";
}

// The curves over minutes.
Result<void> write_log(const fs::path& weights, const std::string& csv) {
  if (Result<void> written = write_file_atomically(beside(weights, ".csv"), csv); !written) return written;
  CurveTable table = curves_from_csv(csv);
  table.columns.erase(table.columns.begin());
  for (std::vector<double>& row : table.rows) row.erase(row.begin());
  return write_curves(beside(weights, ".png"), table);
}

}  // namespace

Result<TrainingSummary> run_training(Trainee& trainee, const TrainingOptions& options) {
  use_one_thread();
  at::globalContext().setFlushDenormal(true);
  const fs::path checkpoint = beside(options.weights, ".checkpoint");
  State state;
  if (options.resume) {
    Result<State> loaded = load_checkpoint(checkpoint, trainee);
    if (!loaded) return tl::unexpected(loaded.error());
    state = *loaded;
  }
  const double before = state.seconds - processor_seconds();
  const double budget = options.minutes * 60;
  const double geometry = trainee.geometry_error();
  double next_report = state.seconds + options.report_every_s;
  double next_validation = state.seconds + options.validate_every_s;
  RunningMeans means;
  NamedValues errors = trainee.validate();
  bool stopped = false;

  const auto validate = [&]() -> Result<void> {
    errors = trainee.validate();
    if (!(errors[0].second < state.best_error)) return save_checkpoint(checkpoint, trainee, state);
    state.best_error = errors[0].second;
    const Result<void> written = write_weights(options.weights, trainee.weights());
    return written ? save_checkpoint(checkpoint, trainee, state) : written;
  };
  while (!stopped && state.seconds < budget) {
    const double rate = 0.5 * (1 + std::cos(kPi * state.seconds / budget));
    std::mt19937_64 random(options.seed * 0x9E3779B97F4A7C15ULL +
                           static_cast<std::uint64_t>(state.iteration));
    means.add(trainee.step(std::max(rate, 0.01), random));
    ++state.iteration;
    state.seconds = before + processor_seconds();
    stopped = options.stop && options.stop();
    if (stopped || state.seconds >= next_validation || state.seconds >= budget) {
      if (const Result<void> done = validate(); !done) return tl::unexpected(done.error());
      next_validation = state.seconds + options.validate_every_s;
    }
    if (stopped || state.seconds >= next_report || state.seconds >= budget) {
      next_report = state.seconds + options.report_every_s;
      TrainingReport report{state.iteration, state.seconds / 60, options.minutes, means.take()};
      report.values.insert(report.values.end(), errors.begin(), errors.end());
      if (state.csv.empty()) state.csv = csv_header(report);
      state.csv += csv_line(report);
      if (const Result<void> written = write_log(options.weights, state.csv); !written)
        return tl::unexpected(written.error());
      if (options.watch && !options.watch(report)) stopped = true;
    }
  }
  if (const Result<void> saved = save_checkpoint(checkpoint, trainee, state); !saved)
    return tl::unexpected(saved.error());
  if (state.best_error > geometry)
    log::warning("the weights are worse than plain geometry on held-out bodies and motions: " +
                 std::to_string(state.best_error) + " against " + std::to_string(geometry));
  return TrainingSummary{state.iteration, state.best_error, geometry, state.seconds >= budget};
}

AveragedParameters::AveragedParameters(torch::nn::Module& module, double keep)
    : parameters_(module.parameters()), keep_(keep) {
  for (const torch::Tensor& parameter : parameters_) averages_.push_back(parameter.detach().clone());
}

void AveragedParameters::follow() {
  torch::NoGradGuard no_gradient;
  const double keep = std::min(keep_, static_cast<double>(steps_) / static_cast<double>(steps_ + 10));
  ++steps_;
  for (std::size_t i = 0; i < parameters_.size(); ++i) averages_[i].lerp_(parameters_[i], 1 - keep);
}

void AveragedParameters::swap() {
  torch::NoGradGuard no_gradient;
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    const torch::Tensor held = parameters_[i].detach().clone();
    parameters_[i].copy_(averages_[i]);
    averages_[i].copy_(held);
  }
}

void AveragedParameters::save(torch::serialize::OutputArchive& archive, const std::string& key) const {
  archive.write(key + ".steps", torch::IValue(steps_));
  for (std::size_t i = 0; i < averages_.size(); ++i) archive.write(key + std::to_string(i), averages_[i]);
}

void AveragedParameters::load(torch::serialize::InputArchive& archive, const std::string& key) {
  torch::NoGradGuard no_gradient;
  torch::IValue value;
  archive.read(key + ".steps", value);
  steps_ = value.toInt();
  for (std::size_t i = 0; i < averages_.size(); ++i) {
    torch::Tensor tensor;
    archive.read(key + std::to_string(i), tensor);
    averages_[i].copy_(tensor);
  }
}

}  // namespace posecoach
