// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string>

namespace gaitwright::cli {

/// How far long work is.
struct Progress {
  int done = 0, all = 0;
  int before = 0;  ///< how much of `done` was so before this began, and tells nothing of the time left
};

/// "1:05:09" or "2:07": a time in whole seconds.
std::string ClockText(double seconds);

/// The time that is left if the rest goes as what was done in this time [s]; not a number while nothing was.
double TimeLeft(const Progress& progress, double elapsed_s);

/// "7 of 14 trials, 1:03 left, 2 fell"; without a time that is not finite, and without a note that is empty.
std::string ProgressText(const Progress& progress, const std::string& unit, double left_s, const std::string& note);

/// "[#####.....]  50 %  "
std::string BarText(const Progress& progress);

/// When a plain line of a log is due: after a minute of work, and then no more than one a minute.
class MinuteByMinute {
 public:
  /// @param elapsed_s  since the work began
  bool Due(double elapsed_s);

 private:
  double last_s_ = 0.0;
};

/// How far long work is, on standard error, with the time left: a bar on a terminal, and elsewhere, as in the log of a
/// batch queue, a line a minute of work that lasts longer than one.
class ProgressBar {
 public:
  /// @param shown  false for none at all.
  /// @param unit   of what is done: "trials"
  ProgressBar(bool shown, std::string unit);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void Show(const Progress& progress, const std::string& note = "");

 private:
  bool shown_, on_terminal_, drawn_ = false;
  std::string unit_;
  MinuteByMinute lines_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace gaitwright::cli
