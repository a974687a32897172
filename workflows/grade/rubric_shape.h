// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/data_shape.h"
#include "workflows/grade/rubric.h"

namespace gaitwright {

/// What a rubric may hold; beyond this its reader refuses what there is not (robots, options of a playback), and checks
/// whose points do not add up.
DataShape RubricShape();

/// What a part of that kind may hold.
DataShape PartShape(PartKind kind);

/// What its limits may hold.
DataShape LimitsShape(PartKind kind);

/// What a check of it may hold.
DataShape CheckShape(PartKind kind);

/// What such checks measure.
std::vector<std::string> MeasuresOf(PartKind kind);

}  // namespace gaitwright
