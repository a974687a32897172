// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/base/suggestion.h"

namespace gaitwright {

const char* CertaintyName(Certainty certainty) {
  switch (certainty) {
    case Certainty::kPlanned:
      return "planned";
    case Certainty::kEstimated:
      return "estimated";
    case Certainty::kUntried:
      return "untried";
  }
  return "";
}

}  // namespace gaitwright
