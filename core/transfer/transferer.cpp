#include "core/transfer/transferer.h"

namespace posecoach {

std::string_view to_string(TransferMethod method) {
  switch (method) {
    case TransferMethod::Scale:
      return "scale";
    case TransferMethod::Bones:
      return "bones";
    case TransferMethod::Ratio:
      return "ratio";
    case TransferMethod::Paper:
      return "paper";
    case TransferMethod::Network:
      return "network";
  }
  return "unknown";
}

Result<TransferMethod> transfer_method_from_string(std::string_view name) {
  for (const TransferMethod method : kTransferMethods)
    if (to_string(method) == name) return method;
  return fail(ErrorCode::InvalidArgument, "no transfer method '" + std::string(name) +
                                              "'; there are: network, paper, ratio, bones, scale");
}

}  // namespace posecoach
