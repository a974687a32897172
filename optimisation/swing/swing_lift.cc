// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/swing/swing_lift.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/ik/leg_ik.h"
#include "kinematics/spatial/dense_solvers.h"
#include "kinematics/trajectory/swing_curve.h"

namespace gaitwright {
namespace {

constexpr double kLiftPerLegLength = 0.12;

VectorX StandingOfLeg(const RobotModel& model, const LegIk& ik) {
  VectorX standing(static_cast<Eigen::Index>(ik.dofs().size()));
  for (std::size_t i = 0; i < ik.dofs().size(); ++i)
    standing[static_cast<Eigen::Index>(i)] = model.standing_joints[ik.dofs()[i]];
  return standing;
}

/// A leg whose foot is lifted straight up from the standing posture with the base fixed.
class LiftedLeg {
 public:
  LiftedLeg(const RobotModel& model, int foot)
      : model_(model), foot_(model.feet[static_cast<std::size_t>(foot)]), scratch_(model) {
    q_ = StandingConfiguration(model);
    const auto leg = std::find_if(model.legs.begin(), model.legs.end(), [&](const Leg& l) { return l.foot == foot; });
    for (const int joint : leg->joints) {
      const int dof = model.joints[static_cast<std::size_t>(joint)].dof;
      if (std::find(dofs_.begin(), dofs_.end(), dof) == dofs_.end()) dofs_.push_back(dof);
    }
  }

  /// Joint speeds of the leg, by dofs(), for an upward speed of the foot. Least squares, so that it also works for a
  /// leg whose plane is slightly tilted.
  VectorX SpeedsFor(double rate_m_s) {
    constexpr double kDamping = 1e-8;
    ForwardKinematics(model_, q_, scratch_);
    MatrixX whole = MatrixX::Zero(6, model_.nv());
    PointJacobian(model_, scratch_, foot_.body, foot_.X_BF.translation(), whole);
    MatrixX J(foot_.has_sole() ? 6 : 3, static_cast<Eigen::Index>(dofs_.size()));
    for (std::size_t i = 0; i < dofs_.size(); ++i)
      J.col(static_cast<Eigen::Index>(i)) = whole.col(6 + dofs_[i]).head(J.rows());
    VectorX wanted = VectorX::Zero(J.rows());
    wanted[2] = rate_m_s;
    const MatrixX normal = J.transpose() * J + kDamping * MatrixX::Identity(J.cols(), J.cols());
    return SolveSymmetric(normal, J.transpose() * wanted);
  }

  /// @return whether all joints are within their limits at this lift.
  bool LiftBy(double lift_m) {
    constexpr int kSteps = 30;
    bool within = true;
    for (int i = 0; i < kSteps; ++i) {
      const VectorX step = SpeedsFor(lift_m / kSteps);
      for (std::size_t d = 0; d < dofs_.size(); ++d) {
        double& position = q_[7 + dofs_[d]];
        position += step[static_cast<Eigen::Index>(d)];
        within = within && position >= model_.dof_lower(dofs_[d]) && position <= model_.dof_upper(dofs_[d]);
      }
    }
    return within;
  }

  const std::vector<int>& dofs() const { return dofs_; }

 private:
  const RobotModel& model_;
  const Foot& foot_;
  DynamicsScratch scratch_;
  VectorX q_;
  std::vector<int> dofs_;
};

}  // namespace

double SwingLift(const RobotModel& model, const SwingOptions& options) {
  constexpr double kRoom =
      1.3;  // factor of the lift: a foot in front of or behind its nominal place bends the leg more
  constexpr double kLess = 0.85;  // factor from trial to trial
  constexpr int kTries = 10;
  if (options.height_m > 0.0) return options.height_m;
  double lift = kLiftPerLegLength * model.leg_length_m();
  for (const Leg& leg : model.legs) {
    if (!model.feet[static_cast<std::size_t>(leg.foot)].has_sole()) {
      // If the plain lift is possible, the margin is dropped: other body postures provide it.
      if (LiftedLeg(model, leg.foot).LiftBy(lift)) continue;
      for (int i = 0; i < kTries && !LiftedLeg(model, leg.foot).LiftBy(kRoom * lift); ++i) lift *= kLess;
      continue;
    }
    const LegIk ik(model, leg.foot);
    const Pose X_BF = ik.FootPose(StandingOfLeg(model, ik));
    for (int i = 0; i < kTries; ++i) {
      Pose raised = X_BF;
      raised.translation().z() += kRoom * lift;
      if (ik.Solve(raised)) break;
      lift *= kLess;
    }
  }
  return lift;
}

/// Largest share of a joint's speed limit that a lift uses, at the time of the foot's largest upward speed.
double SpeedBoundLift::LargestUse(int foot, double duration_s, double lift_m) const {
  constexpr double kFastest = 0.27639320225002106;  // 0.5 (1 - 1 / sqrt 5), fraction of the swing
  const Motion1 bump = SmoothBump(kFastest);
  LiftedLeg leg(*model_, foot);
  leg.LiftBy(bump.value * lift_m);
  const VectorX speeds = leg.SpeedsFor(bump.rate * lift_m / duration_s);
  double largest = 0.0;
  for (std::size_t i = 0; i < leg.dofs().size(); ++i)
    largest =
        std::max(largest, std::abs(speeds[static_cast<Eigen::Index>(i)]) / model_->dof_velocity_limit(leg.dofs()[i]));
  return largest;
}

double SpeedBoundLift::LiftInTime(int foot, double duration_s, double usual_m) {
  constexpr double kEnough = 0.6;  // share of a speed limit; the rest is for the forward motion
  constexpr double kLess = 0.85, kLeast = 0.25;
  if (!(duration_s > 0.0)) return usual_m;
  const std::pair<int, long long> asked{foot, std::llround(1e6 * duration_s)};
  const auto known = known_.find(asked);
  if (known != known_.end()) return known->second;
  double lift = usual_m;
  if (LargestUse(foot, duration_s, lift) > 1.0) {
    while (lift > kLeast * usual_m && LargestUse(foot, duration_s, lift) > kEnough) lift *= kLess;
    lift = std::max(lift, kLeast * usual_m);
  }
  known_[asked] = lift;
  return lift;
}

}  // namespace gaitwright
