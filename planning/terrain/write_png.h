// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/result.h"
#include "planning/terrain/read_png.h"

namespace gaitwright {

/// The bytes of a grey PNG: 16 bits if white is 65535, 8 bits if it is 255. Equal pictures give equal bytes.
/// ReadGreyPng reads them.
/// @throws InvalidArgument for another white, a picture without points, and a number of values that differs from the
/// number of points. Failure if libpng fails.
Result<std::string> WriteGreyPng(const GreyImage& image);

}  // namespace gaitwright
