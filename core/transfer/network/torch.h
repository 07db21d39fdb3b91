// libtorch as the networks here use it; nothing outside this folder and its tests may include this.
#pragma once

#include <torch/torch.h>
