// SPDX-License-Identifier: BSD-3-Clause
#include "cli/progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace gaitwright::cli {

std::string ClockText(double seconds) {
  const long all = std::lround(std::max(0.0, seconds));
  const long hours = all / 3600, minutes = all / 60 % 60;
  return hours > 0 ? fmt::format("{}:{:02}:{:02}", hours, minutes, all % 60)
                   : fmt::format("{}:{:02}", minutes, all % 60);
}

double TimeLeft(const Progress& progress, double elapsed_s) {
  const int done = progress.done - progress.before;
  return done > 0 ? elapsed_s / done * (progress.all - progress.done) : std::nan("");
}

std::string ProgressText(const Progress& progress, const std::string& unit, double left_s, const std::string& note) {
  const std::string left = std::isfinite(left_s) ? fmt::format(", {} left", ClockText(left_s)) : "";
  return fmt::format("{} of {} {}{}{}{}", progress.done, progress.all, unit, left, note.empty() ? "" : ", ", note);
}

std::string BarText(const Progress& progress) {
  constexpr int kWidth = 24;
  const int full = progress.all > 0 ? kWidth * progress.done / progress.all : 0;
  return fmt::format("[{}{}] {:>3} %  ", std::string(static_cast<std::size_t>(full), '#'),
                     std::string(static_cast<std::size_t>(kWidth - full), '.'),
                     progress.all > 0 ? 100 * progress.done / progress.all : 0);
}

bool MinuteByMinute::Due(double elapsed_s) {
  if (elapsed_s - last_s_ < 60.0) return false;
  last_s_ = elapsed_s;
  return true;
}

ProgressBar::ProgressBar(bool shown, std::string unit)
    : shown_(shown), on_terminal_(::isatty(STDERR_FILENO) != 0), unit_(std::move(unit)) {}

ProgressBar::~ProgressBar() {
  if (drawn_) fmt::print(stderr, "\r\033[K");
}

void ProgressBar::Show(const Progress& progress, const std::string& note) {
  if (!shown_) return;
  const double elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  const std::string text = ProgressText(progress, unit_, TimeLeft(progress, elapsed_s), note);
  if (on_terminal_) {
    drawn_ = true;
    fmt::print(stderr, "\r\033[K{}{}", BarText(progress), text);
  } else if (lines_.Due(elapsed_s)) {
    fmt::print(stderr, "gaitwright: {}\n", text);
  }
  std::fflush(stderr);
}

}  // namespace gaitwright::cli
