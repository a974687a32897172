// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "optimisation/pipeline/plan_motion.h"
#include "planning/gait/find_gait.h"

namespace gaitwright {

/// A walk over level ground, planned and finished by the whole-body trajectory optimisation.
struct WholeBodyCase {
  std::string name;  ///< such as a1-trot-3.5
  std::string robot, gait;
  double speed_m_s = 0.0;
  double distance_m = 0.0;
  GaitOptions timing = {};
  double swing_height_m = 0.0;  ///< 0: that of the planner
};

/// The built-in cases whose name contains `filter`. Those named a1-chain are the same trot over longer and longer
/// distances; those named a1-step, laikago-step and h1_2-step are StepTasks.
std::vector<WholeBodyCase> WholeBodyCases(const std::string& filter = "");

/// Tasks with steps of given length, height and duration, those of the examples of Crocoddyl (Mastalli et al., ICRA
/// 2020, https://github.com/loco-3d/crocoddyl, examples quadrupedal_gaits and bipedal_walk): ANYmal walks with steps of
/// 0.25 m, 0.15 m high, in 0.25 s with 0.02 s between them; trots, paces and bounds with steps of 0.15 m, 0.1 m high,
/// in 0.25 s; and jumps 0.3 m with a flight of 0.4 s. Talos walks with steps of 0.6 m, 0.1 m high, in 1.05 s with 0.3 s
/// between them.
/// @param legs  two or four; otherwise there are none.
std::vector<WholeBodyCase> StepTasks(const std::string& robot, int legs);

/// Result of a case.
struct WholeBodyOutcome {
  WholeBodyCase one;
  std::string reason;                    ///< why there is no finished plan, or what its audit finds; or empty
  std::optional<FinishReport> finished;  ///< how it was finished
  double planning_cpu_s = 0.0;           ///< all stages
  bool passes_audit = false;

  /// CPU time of an iteration [ms]; 0 without a finished plan.
  double MsAnIteration() const;
};

/// Plans a case of a robot. @param options  with any method; whole-body is used.
WholeBodyOutcome RunWholeBodyCase(const RobotModel& model, const WholeBodyCase& one, MotionOptions options);
/// The same for the built-in robot of the case.
WholeBodyOutcome RunWholeBodyCase(const WholeBodyCase& one, const MotionOptions& options);

/// The outcomes as a text table.
std::string WholeBodyTable(const std::vector<WholeBodyOutcome>& outcomes);

}  // namespace gaitwright
