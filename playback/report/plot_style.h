// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace gaitwright {

/// Meanings of colours, on light and on dark screens. Hues are after Okabe and Ito (https://jfly.uni-koeln.de/color/).
/// Lightness is chosen so that any two colours differ by at least 18 in CIELAB, also for people without red or green
/// cones (Machado, Oliveira and Fernandes 2009, doi:10.1109/TVCG.2009.113).
enum class Ink { kZmp, kCom, kDcm, kFoot, kJoint, kLimit, kSupport, kBad, kMuted };

/// Line styles: planned values are broad and pale, measured values thin and dark on top.
enum class Stroke { kPlanned, kMeasured, kThin, kDashed };

/// The style sheet's class of an ink or a stroke.
const char* CssClass(Ink ink);
const char* CssClass(Stroke stroke);

/// The style sheet of all plots, for light and dark screens.
std::string PlotStyle();

/// A plot as a separate file: XML declaration, name space, style inside.
std::string StandaloneSvg(const std::string& svg);

}  // namespace gaitwright
