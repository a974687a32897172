// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/result.h"
#include "planning/terrain/read_png.h"

namespace gaitwright {

/// The bytes of a grey PNG: of 16 bits if white is 65535, of 8 bits if it is 255. The same picture gives the same
/// bytes. ReadGreyPng reads them back.
/// @throws InvalidArgument for another white, a picture without points, and a number of values that is not that of the
/// points. Failure: libpng refuses.
Result<std::string> WriteGreyPng(const GreyImage& image);

}  // namespace gaitwright
