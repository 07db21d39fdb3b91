// libtorch, precompiled for this folder; nothing outside it may include this.
#pragma once

#include <torch/torch.h>
