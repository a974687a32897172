// SPDX-License-Identifier: BSD-3-Clause
#include "tests/playback/displaced.h"

#include <Eigen/QR>
#include <utility>

#include "kinematics/spatial/rotation.h"
#include "planning/plan/carried_plan.h"
#include "planning/plan/sample_plan.h"

namespace gaitwright::displaced {

ControlInput OnPlan(const MotionPlan& plan, double time_s) {
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

MatrixX FootRows(const RobotModel& model, const DynamicsScratch& scratch, int foot) {
  const Foot& f = model.feet[static_cast<std::size_t>(foot)];
  MatrixX J(6, model.nv());
  PointJacobian(model, scratch, f.body, f.X_BF.translation(), J);
  return J.topRows(f.sole_F.empty() ? 3 : 6);
}

VectorX FeetAt(const RobotModel& model, const std::vector<Pose>& X_WF, VectorX q) {
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

VectorX BaseMoved(const RobotModel& model, const VectorX& q, const Vector3& displacement_W, const Vector3& turn_W) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, q, scratch);
  std::vector<Pose> X_WF;
  for (const Foot& foot : model.feet) X_WF.push_back(FramePose(scratch, foot.body, foot.X_BF));
  VectorX moved = q;
  moved.head<3>() += displacement_W;
  moved.segment<4>(3) = Quaternion(RotationExp(turn_W) * scratch.R_WB[0]).coeffs();
  return FeetAt(model, X_WF, moved);
}

ControlInput Carried(const Pose& X, ControlInput input) {
  input.q = CarriedState(X, input.q);
  input.v = CarriedRates(X, input.v);
  for (ContactWrench& wrench : input.wrenches) wrench = {X.linear() * wrench.force_W, X.linear() * wrench.moment_W};
  return input;
}

MotionPlan Carried(const Pose& X, MotionPlan plan) {
  MotionPlan there = CarriedPlan(X, 0.0, std::move(plan));
  for (TerrainPatch& patch : there.terrain.patches) patch.X_WT = X * patch.X_WT;
  return there;
}

}  // namespace gaitwright::displaced
