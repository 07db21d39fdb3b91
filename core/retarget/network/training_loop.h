// The loop around every training: time, learning rate, log, checkpoints, and the best weights so far.
#pragma once

#include <memory>
#include <random>

#include "core/retarget/network/training.h"
#include "core/retarget/network/weights_file.h"

namespace posecoach {

using NamedValues = std::vector<std::pair<std::string, double>>;

// What is trained.
class Trainee {
 public:
  virtual ~Trainee() = default;
  // One update with the learning rate times `rate` in (0, 1]; its losses. `random` belongs to this iteration
  // alone, so that a resumed training goes the same way.
  virtual NamedValues step(double rate, std::mt19937_64& random) = 0;
  // Errors of the averaged weights on held-out bodies and motions; the first one decides.
  virtual NamedValues validate() = 0;
  virtual double geometry_error() = 0;
  // The averaged weights.
  virtual WeightsFile weights() = 0;
  // Everything that training needs to go on.
  virtual void save(torch::serialize::OutputArchive& archive) = 0;
  virtual void load(torch::serialize::InputArchive& archive) = 0;
};

Result<TrainingSummary> run_training(Trainee& trainee, const TrainingOptions& options);

// A slowly following average of a module's parameters.
class AveragedParameters {
 public:
  AveragedParameters(torch::nn::Module& module, double keep);
  void follow();
  // Exchanges the module's parameters with the averages; twice is nothing.
  void swap();
  void save(torch::serialize::OutputArchive& archive, const std::string& key) const;
  void load(torch::serialize::InputArchive& archive, const std::string& key);

 private:
  std::vector<torch::Tensor> parameters_, averages_;
  double keep_;
  int64_t steps_ = 0;
};

}  // namespace posecoach
