// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/cli/stranger.h"

namespace gaitwright::cli {

/// A walk that was planned and played in `out`.
class View : public Stranger {
 protected:
  View() { EXPECT_EQ(Run({"walk", "--distance", "0.3", "--quiet", "--out-dir", "out"}).status, 0); }

  bool Begins(const std::string& name, const std::string& with) const { return Read(name).starts_with(with); }
};

}  // namespace gaitwright::cli
