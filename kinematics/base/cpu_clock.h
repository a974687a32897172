// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ctime>

namespace gaitwright {

/// CPU time of the calling thread since the clock was made.
class CpuClock {
 public:
  double elapsed_s() const { return Now() - start_; }

 private:
  static double Now() {
    timespec now = {};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  }

  double start_ = Now();
};

}  // namespace gaitwright
