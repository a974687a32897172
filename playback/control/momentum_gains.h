// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// How large errors are that are worth changing the forces of all feet by their whole load.
struct MomentumErrors {
  double position_m = 0.0;    ///< of the centre of mass; all of them > 0
  double velocity_m_s = 0.0;  ///< likewise
  double turn_rad = 0.0;      ///< of the base
  double rate_rad_s = 0.0;    ///< likewise
  double step_m = 0.0;        ///< of a foothold against the body, where it is put down
};

/// Linear feedback of a robot's momentum along a whole plan.
///
/// The state x of a robot with n feet is its error against the plan, in W:
///   place and velocity of C; turn of the base (rotation vector); angular momentum about C over the locked inertia;
///   by foot x and y of where it stands, zero in the air.
/// What feet in a line or one foot alone cannot hold, or only at the cost of the rest, is left to the stances after
/// them and to where those are put down.
struct MomentumGains {
  static constexpr Eigen::Index kFeet = 12;  ///< row of x where those of the feet begin

  /// What holds in an interval of the plan's grid.
  struct Row {
    /// By foot, 6 x (12 + 2 n): change of its wrench about its contact, by newton of normal force that the plan has.
    std::vector<MatrixX> wrench_per_n;
    /// 2 n x (12 + 2 n): by foot where its next foothold is to be, against the plan, if all goes on so until then.
    MatrixX steps;
  };
  double start_s = 0.0, step_s = 0.0;
  std::vector<Row> rows;  ///< in order

  /// The row that holds at a time, beyond the ends the first or the last. There must be one.
  const Row& At(double time_s) const;
};

/// The feedback of least cost, by the discrete Riccati equation backwards along the plan. With u_i the change of a
/// point's force by its share of the load (tangents by friction times it), T = sqrt(leg length / g):
///   cost = integral of (sum of squared errors, each by what counts one, + |u|^2) dt / T
///          + at each touch-down |dr_i - dp|^2 / step^2,  dr_i chosen
///   dp' = dv,  m dv' = sum df_i,  turn' = w x turn + rate,  I rate' = sum (r_i - p) x df_i + (dr_i - dp) x f_i
/// Anderson and Moore, Optimal Control: Linear Quadratic Methods, 1990; the body as in Di Carlo et al., IROS 2018.
/// @param plan  with motion, forces and schedule; two rows or more.
MomentumGains DeriveMomentumGains(const RobotModel& model, const MotionPlan& plan, const MomentumErrors& errors);

}  // namespace gaitwright
