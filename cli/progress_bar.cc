// SPDX-License-Identifier: BSD-3-Clause
#include "cli/progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace gaitwright::cli {

std::string ClockText(double seconds) {
  const long all = std::lround(std::max(0.0, seconds));
  const long hours = all / 3600, minutes = all / 60 % 60;
  return hours > 0 ? fmt::format("{}:{:02}:{:02}", hours, minutes, all % 60)
                   : fmt::format("{}:{:02}", minutes, all % 60);
}

std::string BarText(int done, int all, double left_s, const std::string& words) {
  constexpr int kWidth = 24;
  const int full = all > 0 ? kWidth * done / all : 0;
  const std::string left = std::isfinite(left_s) ? ClockText(left_s) + " left" : "";
  return fmt::format("[{}{}] {:>3} %  {} of {}  {}  {}", std::string(static_cast<std::size_t>(full), '#'),
                     std::string(static_cast<std::size_t>(kWidth - full), '.'), all > 0 ? 100 * done / all : 0, done,
                     all, left, words);
}

ProgressBar::ProgressBar(bool shown) : shown_(shown && ::isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() {
  if (drawn_) fmt::print(stderr, "\r\033[K");
}

void ProgressBar::Show(int done, int all, int before, const std::string& words) {
  if (!shown_) return;
  drawn_ = true;
  const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  const double left = done > before ? elapsed / (done - before) * (all - done) : std::nan("");
  fmt::print(stderr, "\r\033[K{}", BarText(done, all, left, words));
  std::fflush(stderr);
}

}  // namespace gaitwright::cli
