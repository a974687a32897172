// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/result.h"

namespace gaitwright {

/// A drawing as SVG, and its size.
struct SvgDrawing {
  std::string svg;
  int width_px = 0, height_px = 0;
};

/// A drawing as the bytes of a PNG, by a headless Chromium. Failure: there is none, or it does not start.
Result<std::string> SvgToPng(const SvgDrawing& drawing);

}  // namespace gaitwright
