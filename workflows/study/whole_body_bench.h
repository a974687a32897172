// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "optimisation/pipeline/plan_motion.h"

namespace gaitwright {

/// A walk of a built-in robot over level ground, planned and finished by the whole-body trajectory optimisation.
struct WholeBodyCase {
  std::string name;  ///< such as a1-trot-3.5
  std::string robot, gait;
  double speed_m_s = 0.0;
  double distance_m = 0.0;
};

/// The built-in cases whose name contains `filter`. Those named a1-chain are the same trot over longer and longer
/// distances.
std::vector<WholeBodyCase> WholeBodyCases(const std::string& filter = "");

/// Result of a case.
struct WholeBodyOutcome {
  WholeBodyCase one;
  std::string reason;                    ///< why there is no finished plan; empty if there is one
  std::optional<FinishReport> finished;  ///< how it was finished
  double planning_cpu_s = 0.0;           ///< all stages
  bool passes_audit = false;

  /// CPU time of an iteration [ms]; 0 without a finished plan.
  double MsAnIteration() const;
};

/// Plans a case. @param options  with any method; whole-body is used.
WholeBodyOutcome RunWholeBodyCase(const WholeBodyCase& one, MotionOptions options);

/// The outcomes as a text table.
std::string WholeBodyTable(const std::vector<WholeBodyOutcome>& outcomes);

}  // namespace gaitwright
