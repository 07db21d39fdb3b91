#include "core/base/thread_name.h"

#include <pthread.h>

namespace posecoach {

void name_this_thread(const char* name) {
  // Fails only for names that are too long; a thread without a name works as well.
  (void)pthread_setname_np(pthread_self(), name);
}

}  // namespace posecoach
