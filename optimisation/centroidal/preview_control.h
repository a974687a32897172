// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// The cart-table model, with the cost weights of ZMP error and jerk.
struct PreviewSetup {
  double com_height_m = 0.814;
  double step_s = 0.005;
  double preview_s = 1.6;
  double error_weight = 1.0;  ///< Q, of the summed ZMP error [1/m^2]
  double jerk_weight = 1e-6;  ///< R, of the jerk [s^6/m^2]
};

/// Gains of the preview controller.
///   jerk u_k = -K_i sum_i (p_i - p_ref_i) - K_x x_k + sum_j f_j p_ref_{k+j},   x = (c, c', c''),  p = c - (z/g) c''
struct PreviewGains {
  double integral = 0.0;            ///< K_i
  Vector3 state = Vector3::Zero();  ///< K_x
  std::vector<double> preview;      ///< f_1 ... f_N
};

/// Gains from the discrete algebraic Riccati equation of the model with integrated error, solved by structured
/// doubling.
/// @throws InvalidArgument unless every number of the setup is positive and finite, and the preview at most 10,000
/// steps.
/// Kajita et al., ICRA 2003, doi:10.1109/ROBOT.2003.1241826, equations 13 to 19; the gains with the summed error after
/// Katayama et al., Int. J. Control 41(3), 1985.  Doubling: Chu et al., Int. J. Control 77(8), 2004.
PreviewGains ComputePreviewGains(const PreviewSetup& setup);

/// A roll-out along one axis, by sample.
struct PreviewMotion {
  std::vector<double> com_m, com_rate_m_s, com_acceleration_m_s2, zmp_m;
};

/// Tracks a ZMP reference (one value per step) from rest at `com_m`; beyond its end, and beyond each preview, the
/// reference keeps its last value. If the reference moves within the first preview horizon, the ZMP does not start on
/// it; stand still at first.
PreviewMotion FollowZmp(const PreviewSetup& setup, const std::vector<double>& reference_m, double com_m);

}  // namespace gaitwright
