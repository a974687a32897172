// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "optimisation/centroidal/zmp_problem.h"

namespace gaitwright {

/// Options of preview control of the preferred ZMP.
struct PreviewChoice {
  double preview_s = 1.6;
  double jerk_weight = 1e-6;  ///< against 1 for the ZMP error [s^6/m^2]
};

/// The reference of preview control: the problem's preferred point, but at rest for one preview horizon (at most two
/// thirds of the phase) before it moves in the first phase, and after it arrives in the last phase.
std::vector<Vector2> PreviewReference(const ZmpProblem& problem, double preview_s);

/// The ZMP of preview control for this reference, projected to the nearest point of its support. Before and after the
/// plan, the reference rests for one more preview horizon. Gains and control law: preview_control.h.
std::vector<Vector2> PreviewZmp(const ZmpProblem& problem, const PreviewChoice& choice);

}  // namespace gaitwright
