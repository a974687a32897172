// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "tests/cli/stranger.h"

namespace gaitwright::cli {

/// A walk that was planned and played in `out`, and a slower plan.
class Exchange : public Stranger {
 protected:
  Exchange() {
    EXPECT_EQ(Run({"walk", "--distance", "0.3", "--quiet", "--out-dir", "out"}).status, 0);
    EXPECT_EQ(Run({"plan", "--distance", "0.3", "--speed", "0.2", "--out", "slow.json", "--quiet"}).status, 0);
  }

  static std::size_t LinesIn(const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  }
};

}  // namespace gaitwright::cli
