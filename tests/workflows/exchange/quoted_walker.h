// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/result.h"
#include "tests/playback/played.h"

namespace gaitwright {

/// A biped that walks, one of its joints turning, with a name that CSV and YAML must quote.
struct QuotedWalker : synthetic::Played {
  QuotedWalker() : Played(synthetic::Walked(2, {.count = 2})) {
    model.joints[1].type = JointType::kRevolute;
    model.joints[2].name = model.dof_names[2] = "left, \"z\"";
  }
};

/// What a call is refused with.
template <class Call>
std::string RefusalText(Call call) {
  try {
    call();
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "nothing was refused";
}

/// Whether two vectors are the same to the bit.
inline bool AreSame(const VectorX& a, const VectorX& b) { return a.size() == b.size() && a == b; }

}  // namespace gaitwright
