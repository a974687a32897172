// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/data_shape.h"
#include "workflows/grade/rubric.h"

namespace gaitwright {

/// Structure of a rubric; its reader also refuses unknown robots and playback options, and checks whose points do not
/// add up.
DataShape RubricShape();

/// Structure of a part of this kind.
DataShape PartShape(RubricPartKind kind);

/// Structure of the limits of a part of this kind.
DataShape LimitsShape(RubricPartKind kind);

/// Structure of the checks of a part of this kind.
DataShape CheckShape(RubricPartKind kind);

/// Names of the measures for parts of this kind.
std::vector<std::string> MeasuresOf(RubricPartKind kind);

}  // namespace gaitwright
