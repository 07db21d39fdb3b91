// The trained weights that come with the program, as files of weights_file.h.
#pragma once

#include <string_view>

namespace posecoach {

std::string_view shipped_paper_weights();
std::string_view shipped_network_weights();

}  // namespace posecoach
