// The trained transfers: their weights in, a Transferer out. libtorch stays behind this header.
#pragma once

#include <memory>
#include <string_view>

#include "core/transfer/transferer.h"

namespace posecoach {

// `weights` are the bytes of a file that `train transfer` wrote; `name` is for messages. Asserts Paper or
// Network. Errors: Malformed when the weights cannot be read or are of another network.
Result<std::unique_ptr<Transferer>> load_transferer(TransferMethod method, std::string_view weights,
                                                    std::string_view name);

// Any method, the trained ones with the weights that the program carries inside itself.
Result<std::unique_ptr<Transferer>> make_transferer(TransferMethod method);
// The one that was measured best.
inline constexpr TransferMethod kDefaultTransferMethod = TransferMethod::Network;

}  // namespace posecoach
