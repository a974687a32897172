// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/description/mjcf_model_internal.h"

namespace gaitwright {

/// Notes all that is passed over outside of the bodies and that may change the motion: <option>, <contact>, <tendon>,
/// <deformable>, sections and attributes that are not known.
void NoteMjcfOthers(MjcfContext& context);

}  // namespace gaitwright
