// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/data_shape.h"

namespace gaitwright {

/// Structure of a gait file: gaits by name.
DataShape GaitFileShape();

/// Structure of a sequence file: a list of parts.
DataShape SequenceFileShape();

}  // namespace gaitwright
