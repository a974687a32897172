// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/description/mjcf_model_internal.h"

namespace gaitwright {

/// Adds notes for elements outside the bodies that are ignored and may change the motion: <option>, <contact>,
/// <tendon>, <deformable>, unknown sections and unknown attributes.
void NoteMjcfOthers(MjcfContext& context);

}  // namespace gaitwright
