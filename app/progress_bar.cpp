#include "app/progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <string>

namespace posecoach {
namespace {

std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free);

constexpr double kRedrawEvery_s = 0.1;

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

void listen_to_interrupts() {
  struct sigaction action = {};
  action.sa_handler = [](int) { interrupted.store(true); };
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool is_interrupted() {
  return interrupted.load();
}

ProgressBar::ProgressBar() : is_terminal_(isatty(STDERR_FILENO) == 1) {
  listen_to_interrupts();
}

ProgressBar::~ProgressBar() {
  if (is_drawn_) std::fputs("\r\033[K", stderr);
}

Progress ProgressBar::progress() {
  return [this](std::string_view stage, double fraction) {
    if (is_terminal_) draw(stage, fraction);
    return !is_interrupted();
  };
}

void ProgressBar::draw(std::string_view stage, double fraction) {
  const double now = now_s();
  if (is_drawn_ && now - last_drawn_s_ < kRedrawEvery_s) return;
  last_drawn_s_ = now;
  is_drawn_ = true;
  constexpr int kCells = 30;
  std::string bar;
  if (fraction < 0) {
    // The end is unknown: a cell that wanders shows that work goes on.
    const int at = static_cast<int>(now * 10) % kCells;
    for (int i = 0; i < kCells; ++i) bar += i == at ? "█" : "░";
  } else {
    const int full = static_cast<int>(std::min(1.0, fraction) * kCells);
    for (int i = 0; i < kCells; ++i) bar += i < full ? "█" : "░";
    char percent[16];
    std::snprintf(percent, sizeof percent, " %3d %%", static_cast<int>(100 * std::min(1.0, fraction)));
    bar += percent;
  }
  std::fprintf(stderr, "\r\033[K%.*s %s", static_cast<int>(stage.size()), stage.data(), bar.c_str());
  std::fflush(stderr);
}

}  // namespace posecoach
