// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "optimisation/centroidal/rigid_body_unknowns.h"
#include "optimisation/numerics/constrained_problem.h"

namespace gaitwright {

/// Cost of a motion of a rigid body: the integral over time of
///   force_rate |f_i'|^2 + momentum |l|^2 + tilt |angles - wanted|^2 + stance |foot - nominal place|^2
///     + path |across . (p_WC - point of the path)|^2,
/// Forces are in m g; l is the angular momentum over the mean inertia; positions of stance feet are relative to the
/// centre of mass in the wanted heading; `across` is horizontal and normal to the path. In addition, swing_jerk times
/// the integral of |p'''|^2 of each free swing over its fraction.
///
/// Tuning
///   forces change fast, feet land hard          raise force_rate
///   the base rolls and pitches                  raise momentum, tilt
///   feet stand far from nominal positions       raise stance
///   the body drifts sideways                    raise path
///   free swings waver                           raise swing_jerk
struct RigidBodyWeights {
  double force_rate = 1e-3;  ///< [s]
  double momentum = 1e-2;    ///< [s]
  double tilt = 1.0;         ///< [1/(rad^2 s)]
  double stance = 1.0;       ///< [1/(m^2 s)]
  double path = 0.0;         ///< [1/(m^2 s)]; for a path that is more than an initial guess
  double swing_jerk = 1e-5;  ///< [1/m^2]
};

/// The wanted angles at a time: level, with a heading that changes evenly from start to goal.
Vector3 WantedAngles(const RigidBodyProblem& problem, double time_s);

/// The rows of this cost, by the trapezoid rule over the nodes.
std::vector<Residual> RigidBodyCost(const RigidBodyProblem& problem, const RigidBodyUnknowns& unknowns,
                                    const RigidBodyWeights& weights);

}  // namespace gaitwright
