#include "core/retarget/network/weights_file.h"

#include <sstream>

#include "core/base/file.h"

namespace posecoach {

std::map<std::string, torch::Tensor> tensors_of(const torch::nn::Module& module) {
  std::map<std::string, torch::Tensor> tensors;
  for (const auto& item : module.named_parameters()) tensors[item.key()] = item.value().detach();
  for (const auto& item : module.named_buffers()) tensors[item.key()] = item.value();
  return tensors;
}

Result<void> load_tensors(torch::nn::Module& module, const std::map<std::string, torch::Tensor>& tensors,
                          const std::string& name) {
  torch::NoGradGuard no_gradient;
  for (auto& [key, to] : tensors_of(module)) {
    const auto found = tensors.find(key);
    if (found == tensors.end() || found->second.sizes() != to.sizes())
      return fail(ErrorCode::Malformed,
                  name + ": weights of another network (" + key + "); train them again");
    torch::Tensor(to).copy_(found->second);
  }
  return {};
}

Result<void> write_weights(const std::filesystem::path& path, const WeightsFile& weights) {
  try {
    torch::serialize::OutputArchive archive;
    archive.write("kind", torch::IValue(weights.kind));
    std::string keys, names;
    for (const auto& [key, value] : weights.numbers) {
      archive.write("number." + key, torch::IValue(value));
      names += key + "\n";
    }
    int64_t count = 0;
    for (const auto& [key, tensor] : weights.tensors) {
      archive.write("tensor" + std::to_string(count++), tensor.contiguous());
      keys += key + "\n";
    }
    archive.write("names", torch::IValue(names));
    archive.write("keys", torch::IValue(keys));
    std::ostringstream bytes;
    archive.save_to(bytes);
    return write_file_atomically(path, bytes.str());
  } catch (const std::exception& error) {
    return fail(ErrorCode::Internal, path.string() + ": cannot be written: " + error.what());
  }
}

Result<WeightsFile> read_weights(std::string_view bytes, const std::string& name) {
  try {
    std::istringstream stream{std::string(bytes)};
    torch::serialize::InputArchive archive;
    archive.load_from(stream);
    WeightsFile weights;
    torch::IValue value;
    archive.read("kind", value);
    weights.kind = value.toStringRef();
    const auto lines_of = [&](const char* key) {
      archive.read(key, value);
      std::vector<std::string> lines;
      std::istringstream text(value.toStringRef());
      for (std::string line; std::getline(text, line);) lines.push_back(line);
      return lines;
    };
    for (const std::string& key : lines_of("names")) {
      archive.read("number." + key, value);
      weights.numbers[key] = value.toInt();
    }
    int64_t count = 0;
    for (const std::string& key : lines_of("keys")) {
      torch::Tensor tensor;
      archive.read("tensor" + std::to_string(count++), tensor);
      weights.tensors[key] = tensor;
    }
    return weights;
  } catch (const std::exception&) {
    return fail(ErrorCode::Malformed, name + ": not a file of weights of this program");
  }
}

Result<WeightsFile> read_weights(const std::filesystem::path& path) {
  const Result<std::string> bytes = read_file(path);
  if (!bytes) return tl::unexpected(bytes.error());
  return read_weights(*bytes, path.string());
}

}  // namespace posecoach
