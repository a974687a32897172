// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "playback/control/controller.h"
#include "playback/control/gains.h"
#include "playback/policy/fit_policy_internal.h"
#include "playback/policy/observations_internal.h"

namespace gaitwright {

/// Runs a learned policy: every `step_dt` of its contract, it turns the state into observations and the network's
/// outputs into position targets, which the drives hold with the contract's gains. There is no feed-forward.
///
/// The robot stands in the contract's default posture while the clock stands at the start, as it settles. The policy is
/// first asked in the step after; the time of its observations begins there.
class PolicyController : public Controller {
 public:
  /// @param start_s  start of the plan's clock.
  /// @param gains    for joints that are not in the contract; its factors on stiffness and damping act on all joints.
  /// @throws InvalidArgument for an option out of its range.
  PolicyController(const RobotModel& model, std::shared_ptr<const FittedPolicy> policy, double start_s,
                   const GainOptions& gains);

  JointCommand Update(const ControlInput& input) override;
  void Reset() override;
  std::string Name() const override { return "policy"; }

 private:
  void HoldDefaults();
  void Observe(const ControlInput& input, double since_start_s);
  void Decide();

  const std::shared_ptr<const FittedPolicy> policy_;
  const double start_s_;
  VectorX standing_;
  JointCommand command_;
  Observer observer_;
  PolicyState state_;
  NetworkScratch scratch_;
  Eigen::VectorXf action_;
  long decided_ = -1;  ///< number of the last decision
};

}  // namespace gaitwright
