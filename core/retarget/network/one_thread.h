// libtorch's threads spin against whatever else runs; every thread that computes with it does so alone.
#pragma once

#include <ATen/Parallel.h>
#include <omp.h>

namespace posecoach {

inline void use_one_thread() {
  omp_set_num_threads(1);
  at::set_num_threads(1);
}

}  // namespace posecoach
