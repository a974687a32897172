// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/base/version.h"

namespace gaitwright {

std::string Version() { return GAITWRIGHT_VERSION; }

}  // namespace gaitwright
