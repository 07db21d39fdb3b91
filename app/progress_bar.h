// Progress on a terminal, and Ctrl-C as its answer.
#pragma once

#include "core/base/progress.h"

namespace posecoach {

// From now on an interrupt (SIGINT, SIGTERM) makes every Progress answer "stop", so that work ends cleanly; a
// second one ends the program at once.
void listen_to_interrupts();
bool is_interrupted();

// A bar on standard error while it lives; nothing where standard error is not a terminal.
class ProgressBar {
 public:
  ProgressBar();
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  // Refers to this bar.
  Progress progress();

 private:
  void draw(std::string_view stage, double fraction);

  bool is_terminal_ = false;
  bool is_drawn_ = false;
  double last_drawn_s_ = -1;
};

}  // namespace posecoach
