// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "kinematics/dynamics/contact_split.h"
#include "kinematics/ik/whole_body_ik.h"
#include "kinematics/model/robot_model.h"
#include "optimisation/whole_body/body_path.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// How contact forces of a plan are chosen.
struct WholeBodyOptions {
  double load_ramp_s = 0.1;
  double friction_use = 0.9;

  OptionFields Fields() {
    return WithBasics(
        {"friction_use"},
        {{"load_ramp_s", &load_ramp_s, "s", 0.0, 1.0,
          "Longest time over which a foot takes up its load after touch-down or gives it up before lift-off."},
         {"friction_use", &friction_use, "1", 0.05, 1.0,
          "Share of the friction coefficient that planned contact forces may use."}});
  }
};

/// What the whole-body stage is given: everything that is settled before joints are.
struct WholeBodyProblem {
  const Terrain* terrain = nullptr;
  const ContactSchedule* schedule = nullptr;
  const FootstepPlan* footsteps = nullptr;
  const CentroidalTrajectory* centroidal = nullptr;
  const std::vector<SwingTrajectory>* swings = nullptr;
  std::function<BaseTurning(double time_s)> turning;
  /// What of the robot's weight a foot on the ground is to carry, above 0; empty for even shares that rise after
  /// touch-down and fall before lift-off, by load_ramp_s.
  std::function<double(int foot, double time_s)> load = {};
  /// Where joints are held that no task takes; empty for the standing posture.
  std::function<void(double time_s, PostureTarget& posture)> posture = {};
};

/// Joint motion and what it tells back to the stages before it.
struct WholeBodySolution {
  WholeBodyTrajectory trajectory;
  std::vector<Vector3> roll_at_touchdown_W;     ///< by foothold: how far the foot has rolled since the start [m]
  std::vector<Vector3> roll_at_liftoff_W;       ///< by foothold
  std::vector<std::vector<Vector3>> contact_W;  ///< by foot, by sample: origin of the contact frame [m]
  std::vector<Vector2> zmp_W;       ///< by sample: of the multibody, from its inverse dynamics; in flight below C [m]
  std::vector<Vector2> pressure_W;  ///< by sample: the same of the contact forces alone [m]
  std::vector<PointWrench> residual_W;  ///< by sample: what the motion needs and contact forces do not give
};

/// Joint positions that put the centre of mass, base orientation and feet where the plan has them, with their exact
/// derivatives; then torques and contact forces by inverse dynamics and the split over the contacts.
/// @param expected_roll_W  by foothold, the roll at touch-down that the swings aim off by (from an earlier solution;
///        zero at first). A sphere's swing ends on its foothold once this agrees with `roll_at_touchdown_W`.
/// @param unreached_s  set to the time at which a foot cannot reach, where that is why it fails; may be null.
Result<WholeBodySolution> SolveWholeBody(const RobotModel& model, const WholeBodyProblem& problem,
                                         const std::vector<Vector3>& expected_roll_W, const WholeBodyOptions& options,
                                         double* unreached_s = nullptr);

/// Adds torques and contact wrenches to a trajectory that has q, v, a; and the multibody ZMP by sample.
void AddContactForces(const RobotModel& model, const WholeBodyProblem& problem, const WholeBodyOptions& options,
                      WholeBodySolution& solution);

/// Points by row, where nothing presses those of the nearest row at which something does: so a reference of the ZMP is
/// inside of the supports on both sides of a flight.
std::vector<Vector2> HeldOverFlights(const std::vector<Vector2>& p_W, const std::vector<bool>& presses);

}  // namespace gaitwright
