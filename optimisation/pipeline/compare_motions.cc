// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/compare_motions.h"

#include <algorithm>
#include <cmath>

#include "kinematics/model/actuator.h"

namespace gaitwright {

TorqueUse TorqueUseOf(const RobotModel& model, const WholeBodyTrajectory& motion) {
  double sum = 0.0;
  int count = 0;
  TorqueUse use;
  for (const Actuator& motor : ActuatorsOf(model)) {
    if (!std::isfinite(motor.effort_limit)) continue;
    for (const VectorX& tau : motion.tau) {
      const double share = std::abs(motor.Effort(tau)) / motor.effort_limit;
      sum += share * share;
      ++count;
      use.peak = std::max(use.peak, share);
    }
  }
  if (count > 0) use.rms = std::sqrt(sum / count);
  return use;
}

bool IsBetterMotion(const MotionFigures& motion, const std::optional<MotionFigures>& former, double residual) {
  constexpr double kLess = 0.99;      // required ratio to the former value
  constexpr double kSlight = 1e-3;    // violation that the audit accepts
  constexpr double kBalanced = 10.0;  // multiple of the target residual; the audit accepts far more
  if (!former) return true;
  const double violation = std::max(motion.limit_violation, kSlight), was = std::max(former->limit_violation, kSlight);
  if (violation > kSlight || was > kSlight) return violation < kLess * was;
  const bool balanced = motion.residual < kBalanced * residual, was_balanced = former->residual < kBalanced * residual;
  if (balanced != was_balanced) return balanced;
  return motion.torque.rms * motion.torque.peak < kLess * former->torque.rms * former->torque.peak;
}

}  // namespace gaitwright
