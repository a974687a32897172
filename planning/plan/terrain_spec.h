// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/options.h"

namespace gaitwright {

/// The parameters in a text `key=value,key=value`, in their order. @throws InvalidArgument where it is not written so,
/// or has a key twice.
OptionTexts ParseParameters(const std::string& text);

}  // namespace gaitwright
