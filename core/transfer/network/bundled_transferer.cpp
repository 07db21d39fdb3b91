#include "core/base/embedded.h"
#include "core/transfer/closed_form.h"
#include "core/transfer/trained.h"

namespace posecoach {

POSECOACH_EMBEDDED(transfer_paper_weights)
POSECOACH_EMBEDDED(transfer_network_weights)

Result<std::unique_ptr<Transferer>> make_transferer(TransferMethod method) {
  switch (method) {
    case TransferMethod::Paper:
      return load_transferer(method, transfer_paper_weights(), "transfer-paper.pt");
    case TransferMethod::Network:
      return load_transferer(method, transfer_network_weights(), "transfer-network.pt");
    default:
      return make_closed_form_transferer(method);
  }
}

}  // namespace posecoach
