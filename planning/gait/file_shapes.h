// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/data_shape.h"

namespace gaitwright {

/// What a file of gaits may hold: gaits by name.
DataShape GaitFileShape();

/// What a file of a sequence may hold: a list of parts.
DataShape SequenceFileShape();

}  // namespace gaitwright
