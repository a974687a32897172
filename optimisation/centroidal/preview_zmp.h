// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "optimisation/centroidal/zmp_problem.h"

namespace gaitwright {

/// How preview control follows the preferred ZMP.
struct PreviewChoice {
  double preview_s = 1.6;
  double jerk_weight = 1e-6;  ///< against 1 for the ZMP error [s^6/m^2]
};

/// The preferred point as preview control is given it: that of the problem, but standing for one preview (at most two
/// thirds of the phase) before it sets out in the first phase, and likewise once it has arrived in the last.
std::vector<Vector2> PreviewReference(const ZmpProblem& problem, double preview_s);

/// The ZMP with which preview control follows that reference, taken to the nearest point of its support. Before and
/// after the plan the reference stands still for one more preview. Gains and law: preview_control.h.
std::vector<Vector2> PreviewZmp(const ZmpProblem& problem, const PreviewChoice& choice);

}  // namespace gaitwright
