// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string>

namespace gaitwright::cli {

/// Progress of long work.
struct Progress {
  int done = 0, all = 0;
  int before = 0;  ///< part of `done` that was complete before this run; not used to estimate the time left
};

/// A time in whole seconds as "1:05:09" or "2:07".
std::string ClockText(double seconds);

/// Time left at the average speed of this run so far [s]; NaN while nothing is done.
double TimeLeft(const Progress& progress, double elapsed_s);

/// "7 of 14 trials, 1:03 left, 2 fell". Leaves out a time that is not finite and an empty note.
std::string ProgressText(const Progress& progress, const std::string& unit, double left_s, const std::string& note);

/// "[#####.....]  50 %  "
std::string BarText(const Progress& progress);

/// Limits the plain progress lines in a log to one per minute; the first comes after a minute of work.
class MinuteByMinute {
 public:
  /// @param elapsed_s  time since the work began [s]
  bool Due(double elapsed_s);

 private:
  double last_s_ = 0.0;
};

/// Shows the progress of long work and the time left on standard error. On a terminal it is a bar; elsewhere, such as
/// in the log of a batch queue, it is one line per minute, if the work takes longer than a minute.
class ProgressBar {
 public:
  /// @param shown  false: print nothing.
  /// @param unit   what is counted, such as "trials"
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
