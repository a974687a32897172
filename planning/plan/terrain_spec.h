// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/options.h"

namespace gaitwright {

/// The parameters in a text `key=value,key=value`, in their order. @throws InvalidArgument for a text of another form
/// or with a duplicate key.
OptionTexts ParseParameters(const std::string& text);

}  // namespace gaitwright
