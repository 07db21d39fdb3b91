// Networks in memory as Transferers, for the trainers' validation and for load_transferer.
#pragma once

#include <memory>
#include <string>

#include "core/transfer/network/paper_network.h"
#include "core/transfer/network/transfer_network.h"
#include "core/transfer/transferer.h"

namespace posecoach {

std::unique_ptr<Transferer> make_paper_transferer(std::shared_ptr<PaperTransferGenerator> generator);
std::unique_ptr<Transferer> make_network_transferer(std::shared_ptr<TransferNetwork> network);

// The paper has one scale for all people of its data; pictures have none in common. So everybody is brought
// to this stature, as far as their pictures show it.
inline constexpr double kPaperStature_m = 1.65;
// A pose as the paper's network reads it: centred, in the paper's units. Guesses stand for unseen joints.
torch::Tensor paper_tensor(const Pose2d& pose, double units_per_unit);

// `kind` names the network in the file, so that the weights of another are refused.
std::string transfer_weights_of(const torch::nn::Module& module, std::string_view kind);
inline constexpr std::string_view kPaperKind = "posecoach.transfer.paper/1";
inline constexpr std::string_view kNetworkKind = "posecoach.transfer.network/1";
// Errors: Malformed naming the file.
Result<void> read_transfer_weights(torch::nn::Module& module, std::string_view weights, std::string_view name,
                                   std::string_view kind);

// `average` moves towards `current` by 1 - `keep`.
void move_transfer_average(torch::nn::Module& average, const torch::nn::Module& current, double keep);
// What an average of the trained weights keeps of itself in an iteration: little at first, 0.999 in the end.
double transfer_average_keeps(long iteration);

// One core, no denormal numbers; call on the thread that computes.
void use_one_core_for_transfer();

}  // namespace posecoach
