// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string>

namespace gaitwright::cli {

/// "1:05:09" or "2:07": a time in whole seconds.
std::string ClockText(double seconds);

/// "[#####.....]  50 %   7 of 14, 1:03 left  words"
std::string BarText(int done, int all, double left_s, const std::string& words);

/// How far long work is, on standard error, with the time left; nothing where that is no terminal.
class ProgressBar {
 public:
  /// @param shown  false for none at all.
  explicit ProgressBar(bool shown);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// @param before  how much of `done` was so before this began, and tells nothing of the time left.
  void Show(int done, int all, int before, const std::string& words);

 private:
  bool shown_, drawn_ = false;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace gaitwright::cli
