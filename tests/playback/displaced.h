// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/QR>

#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/spatial/rotation.h"
#include "planning/plan/sample_plan.h"
#include "playback/control/controller.h"

/// What a controller measures of a robot that is not quite where its plan has it.
namespace gaitwright::displaced {

/// The robot exactly on its plan, the scheduled feet on the ground with the planned wrenches.
inline ControlInput OnPlan(const MotionPlan& plan, double time_s) {
  WholeBodySample sample;
  SampleWholeBody(plan.whole_body, time_s, sample);
  ControlInput input;
  input.time_s = time_s;
  input.q = sample.q;
  input.v = sample.v;
  input.wrenches = sample.wrenches;
  input.contact = plan.schedule.phases[static_cast<std::size_t>(PhaseAt(plan.schedule, time_s))].stance;
  return input;
}

/// Rows of a foot's position, and of a sole's turn, against all of v: the frame Foot::X_BF.
inline MatrixX FootRows(const RobotModel& model, const DynamicsScratch& scratch, int foot) {
  const Foot& f = model.feet[static_cast<std::size_t>(foot)];
  MatrixX J(6, model.nv());
  PointJacobian(model, scratch, f.body, f.X_BF.translation(), J);
  return J.topRows(f.sole_F.empty() ? 3 : 6);
}

/// The joints with which the feet are at X_WF though the base of q is elsewhere.
inline VectorX FeetAt(const RobotModel& model, const std::vector<Pose>& X_WF, VectorX q) {
  DynamicsScratch scratch(model);
  for (int iteration = 0; iteration < 20; ++iteration) {
    ForwardKinematics(model, q, scratch);
    for (int foot = 0; foot < static_cast<int>(model.feet.size()); ++foot) {
      const Foot& f = model.feet[static_cast<std::size_t>(foot)];
      const Pose &wanted = X_WF[static_cast<std::size_t>(foot)], now = FramePose(scratch, f.body, f.X_BF);
      const MatrixX rows = FootRows(model, scratch, foot).rightCols(model.num_dofs());
      Vector6 error;
      error << wanted.translation() - now.translation(), RotationLog(wanted.linear() * now.linear().transpose());
      q.tail(model.num_dofs()) += rows.completeOrthogonalDecomposition().solve(VectorX(error.head(rows.rows())));
    }
  }
  return q;
}

/// The base moved and turned (rotation vector, W, about its origin), the feet where they were.
inline VectorX BaseMoved(const RobotModel& model, const VectorX& q, const Vector3& way_W, const Vector3& turn_W) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, q, scratch);
  std::vector<Pose> X_WF;
  for (const Foot& foot : model.feet) X_WF.push_back(FramePose(scratch, foot.body, foot.X_BF));
  VectorX moved = q;
  moved.head<3>() += way_W;
  moved.segment<4>(3) = Quaternion(RotationExp(turn_W) * scratch.R_WB[0]).coeffs();
  return FeetAt(model, X_WF, moved);
}

/// The whole robot, or its velocities, turned about z and moved.
inline VectorX Carried(const Pose& X, VectorX q) {
  const Quaternion R_WB(q[6], q[3], q[4], q[5]);
  q.head<3>() = X * Vector3(q.head<3>());
  q.segment<4>(3) = (Quaternion(X.linear()) * R_WB).coeffs();
  return q;
}
inline VectorX CarriedVelocity(const Pose& X, VectorX v) {
  v.head<3>() = X.linear() * Vector3(v.head<3>());
  v.segment<3>(3) = X.linear() * Vector3(v.segment<3>(3));
  return v;
}
inline void CarryWrenches(const Pose& X, std::vector<ContactWrench>& wrenches) {
  for (ContactWrench& wrench : wrenches) {
    wrench.force_W = X.linear() * wrench.force_W;
    wrench.moment_W = X.linear() * wrench.moment_W;
  }
}

inline ControlInput Carried(const Pose& X, ControlInput input) {
  input.q = Carried(X, input.q);
  input.v = CarriedVelocity(X, input.v);
  CarryWrenches(X, input.wrenches);
  return input;
}

/// The same motion elsewhere, with its ground.
inline MotionPlan Carried(const Pose& X, MotionPlan plan) {
  for (VectorX& q : plan.whole_body.q) q = Carried(X, q);
  for (VectorX& v : plan.whole_body.v) v = CarriedVelocity(X, v);
  for (VectorX& a : plan.whole_body.a) a = CarriedVelocity(X, a);
  for (auto& wrenches : plan.whole_body.wrenches) CarryWrenches(X, wrenches);
  for (Foothold& foothold : plan.footsteps.footholds) foothold.X_WF = X * foothold.X_WF;
  for (TerrainPatch& patch : plan.terrain.patches) patch.X_WT = X * patch.X_WT;
  return plan;
}

}  // namespace gaitwright::displaced
