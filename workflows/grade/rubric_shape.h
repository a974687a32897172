// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/data_shape.h"
#include "workflows/grade/rubric.h"

namespace gaitwright {

/// Structure of a rubric; its reader also refuses unknown robots and playback options, and checks whose points do not
/// add up.
DataShape RubricShape();

/// Structure of a part of this kind.
DataShape PartShape(PartKind kind);

/// Structure of its limits.
DataShape LimitsShape(PartKind kind);

/// Structure of its checks.
DataShape CheckShape(PartKind kind);

/// What such checks measure.
std::vector<std::string> MeasuresOf(PartKind kind);

}  // namespace gaitwright
