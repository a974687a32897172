// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/result.h"

namespace gaitwright {

/// The bytes of a PDF with a picture, made by rsvg-convert. Failure: it is not installed, or fails.
Result<std::string> SvgToPdf(const std::string& svg);

}  // namespace gaitwright
