// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/result.h"
#include "tests/playback/played.h"

namespace gaitwright {

/// A walking biped with one revolute joint, whose name must be quoted in CSV and YAML.
struct QuotedWalker : synthetic::Played {
  QuotedWalker() : Played(synthetic::Walked(2, {.count = 2})) {
    model.joints[1].type = JointType::kRevolute;
    model.joints[2].name = model.dof_names[2] = "left, \"z\"";
  }
};

/// The message with which a call is refused.
template <class Call>
std::string RefusalText(Call call) {
  try {
    call();
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "nothing was refused";
}

/// Whether two vectors are equal to the bit.
inline bool AreSame(const VectorX& a, const VectorX& b) { return a.size() == b.size() && a == b; }

}  // namespace gaitwright
