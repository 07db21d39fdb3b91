// The name under which debuggers and `top -H` show the calling thread.
#pragma once

namespace posecoach {

// At most 15 characters count.
void name_this_thread(const char* name);

}  // namespace posecoach
