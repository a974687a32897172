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

/// Options for the contact forces of a plan.
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

/// Inputs of the whole-body stage: all results of the stages before.
struct WholeBodyProblem {
  const Terrain* terrain = nullptr;
  const ContactSchedule* schedule = nullptr;
  const FootstepPlan* footsteps = nullptr;
  const CentroidalTrajectory* centroidal = nullptr;
  const std::vector<SwingTrajectory>* swings = nullptr;
  std::function<BaseTurning(double time_s)> turning;
  /// Share of the robot's weight that a foot on the ground carries, above 0. Empty: equal shares that rise after
  /// touch-down and fall before lift-off over load_ramp_s.
  std::function<double(int foot, double time_s)> load = {};
  /// Posture of joints that no task determines; empty for the standing posture.
  std::function<void(double time_s, PostureTarget& posture)> posture = {};
};

/// Joint motion, and feedback to the stages before.
struct WholeBodySolution {
  WholeBodyTrajectory trajectory;
  std::vector<Vector3> roll_at_touchdown_W;     ///< by foothold: roll of the foot since the start [m]
  std::vector<Vector3> roll_at_liftoff_W;       ///< by foothold
  std::vector<std::vector<Vector3>> contact_W;  ///< by foot, by sample: origin of the contact frame [m]
  std::vector<Vector2> zmp_W;       ///< by sample: multibody ZMP from inverse dynamics; in flight the point below C [m]
  std::vector<Vector2> pressure_W;  ///< by sample: ZMP of the contact forces alone [m]
  std::vector<PointWrench> residual_W;  ///< by sample: wrench that the motion needs minus that of the contact forces
};

/// Computes joint positions, with exact derivatives, from the planned centre of mass, base orientation and feet; then
/// torques by inverse dynamics and contact forces by splitting the wrench over the contacts.
/// @param expected_roll_W  by foothold, the roll at touch-down that the swings assume (from an earlier solution; zero
///   at first). A sphere's swing ends on its foothold once this agrees with `roll_at_touchdown_W`.
/// @param unreached_s  receives the time at which a foot cannot reach its target, if that is the failure; may be null.
Result<WholeBodySolution> SolveWholeBody(const RobotModel& model, const WholeBodyProblem& problem,
                                         const std::vector<Vector3>& expected_roll_W, const WholeBodyOptions& options,
                                         double* unreached_s = nullptr);

/// Adds torques and contact wrenches to a trajectory with q, v and a, and the multibody ZMP by sample.
void AddContactForces(const RobotModel& model, const WholeBodyProblem& problem, const WholeBodyOptions& options,
                      WholeBodySolution& solution);

/// Points by row; in rows without contact, the point of the nearest row with contact. So a ZMP reference is inside the
/// supports on both sides of a flight.
std::vector<Vector2> HeldOverFlights(const std::vector<Vector2>& p_W, const std::vector<bool>& presses);

}  // namespace gaitwright
