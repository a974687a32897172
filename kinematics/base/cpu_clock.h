// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ctime>

namespace gaitwright {

/// CPU time of the process since the clock was made.
class CpuClock {
 public:
  double elapsed_s() const { return static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC; }

 private:
  std::clock_t start_ = std::clock();
};

}  // namespace gaitwright
