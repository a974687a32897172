// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/QR>

#include "playback/control/momentum_feedback.h"
#include "playback/control/stance_feedback.h"
#include "tests/playback/displaced.h"

namespace gaitwright {

/// Reaction of the ground to joint torques: the foot forces that balance them.
struct Reaction {
  std::vector<Vector3> foot_W;         ///< force by foot
  Vector3 force_W = Vector3::Zero();   ///< of all feet
  Vector3 moment_W = Vector3::Zero();  ///< of all feet, about the centre of mass
  Vector2 zmp_W = Vector2::Zero();     ///< at the mean height of the standing feet
};

/// A stance feedback and its output.
class StanceCase {
 public:
  explicit StanceCase(const RobotModel& model, MotionPlan plan, const StabilisedOptions& options = {})
      : model_(model),
        plan_(std::move(plan)),
        options_(options),
        predictive_(model_, plan_, options_),
        now(model_, plan_),
        stance(model_, options_) {
    footing.offset_W.assign(model.feet.size(), Vector3::Zero());
  }

  const MotionPlan& plan() const { return plan_; }

  /// Torques beyond the plan's.
  VectorX Torques(const ControlInput& input) {
    constexpr double kBefore = 0.02;  // [s]: longer than the time for which a lost contact is bridged
    now.Reset();
    ControlInput before = input;
    before.time_s -= kBefore;
    now.Update(model_, before);
    now.Update(model_, input);
    VectorX tau = VectorX::Zero(model_.num_dofs());
    predictive_.Update(now, footing);
    stance.Update(now, footing, tau, &predictive_);
    return tau;
  }

  /// Additional joint torque that holds the robot at its actual place instead of its planned place, by inverse dynamics
  /// at rest.
  VectorX MovedWeight() const {
    const VectorX still = VectorX::Zero(model_.nv());
    DynamicsScratch scratch(model_);
    VectorX here = still, planned = still;
    InverseDynamics(model_, now.measured.q, still, still, scratch, here);
    InverseDynamics(model_, now.planned.q, still, still, scratch, planned);
    return (here - planned).tail(model_.num_dofs());
  }

  /// The part of MovedWeight that is compensated: along each leg's displacement, if it would move the leg farther away.
  VectorX BorneWeight() const {
    const VectorX moved = MovedWeight(), off = (now.measured.q - now.planned.q).tail(model_.num_dofs());
    VectorX borne = VectorX::Zero(model_.num_dofs());
    for (const Leg& leg : model_.legs) {
      VectorX displacement = VectorX::Zero(model_.num_dofs());
      for (const int joint : leg.joints) {
        const int dof = model_.joints[static_cast<std::size_t>(joint)].dof;
        displacement[dof] = off[dof];
      }
      if (displacement.norm() > 1e-6)
        borne += std::min(moved.dot(displacement.normalized()), 0.0) * displacement.normalized();
    }
    return borne;
  }

  /// Inverts tau = -J^T f on the joints. Feet must not be redundant: points, or one sole.
  Reaction Ask(const ControlInput& input) {
    VectorX tau = VectorX::Zero(model_.nv());
    tau.tail(model_.num_dofs()) = Torques(input);
    tau.tail(model_.num_dofs()) -= BorneWeight();
    for (std::size_t f = 0; f < model_.feet.size(); ++f) {
      Vector6 wrench;
      wrench << now.sample.wrenches[f].force_W, now.sample.wrenches[f].moment_W;
      AddPointWrench(model_, now.planned.scratch, model_.feet[f].body, now.planned.X_WF[f].translation(), -wrench, tau);
    }
    MatrixX J(0, model_.num_dofs());
    for (int f = 0; f < static_cast<int>(model_.feet.size()); ++f) {
      const MatrixX rows = ContactRows(f);
      J.conservativeResize(J.rows() + rows.rows(), Eigen::NoChange);
      J.bottomRows(rows.rows()) = rows;
    }
    const MatrixX map = -J.transpose();
    return Sum(map.completeOrthogonalDecomposition().solve(VectorX(tau.tail(model_.num_dofs()))));
  }

 private:
  MatrixX ContactRows(int foot) const {
    const Foot& f = model_.feet[static_cast<std::size_t>(foot)];
    const auto body = static_cast<std::size_t>(f.body);
    const DynamicsScratch& scratch = now.measured.scratch;
    const Vector3& p_WF = now.measured.X_WF[static_cast<std::size_t>(foot)].translation();
    MatrixX J(6, model_.nv());
    PointJacobian(model_, scratch, f.body, scratch.R_WB[body].transpose() * (p_WF - scratch.p_WB[body]), J);
    if (!Contains(now.bearing, foot)) J.setZero();
    return J.rightCols(model_.num_dofs()).topRows(RowsOf(f));
  }
  static Eigen::Index RowsOf(const Foot& foot) { return foot.sole_F.empty() ? 3 : 6; }

  Reaction Sum(const VectorX& wrenches) const {
    Reaction reaction;
    Vector3 moment_O = Vector3::Zero();
    double height = 0.0, standing = 0.0;
    Eigen::Index row = 0;
    for (std::size_t f = 0; f < model_.feet.size(); ++f) {
      const Vector3& p_WF = now.measured.X_WF[f].translation();
      const Vector3 force = wrenches.segment<3>(row);
      reaction.foot_W.push_back(force);
      reaction.force_W += force;
      moment_O += p_WF.cross(force);
      if (RowsOf(model_.feet[f]) == 6) moment_O += wrenches.segment<3>(row + 3);
      row += RowsOf(model_.feet[f]);
      if (!Contains(now.bearing, static_cast<int>(f))) continue;
      height += p_WF.z();
      standing += 1.0;
    }
    const Vector3& F = reaction.force_W;
    const double ground = standing > 0.0 ? height / standing : 0.0;
    reaction.moment_W = moment_O - now.measured.p_WC.cross(F);
    reaction.zmp_W = Vector2(ground * F.x() - moment_O.y(), ground * F.y() + moment_O.x()) / F.z();
    return reaction;
  }

  const RobotModel model_;
  const MotionPlan plan_;
  const StabilisedOptions options_;
  MomentumFeedback predictive_;

 public:
  Situation now;
  StanceFeedback stance;
  Footing footing;
};

}  // namespace gaitwright
