// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/carried_plan.h"

#include <utility>

#include "kinematics/spatial/rotation.h"

namespace gaitwright {
namespace {

PlanarPose Carried(const Pose& X, const PlanarPose& pose) {
  const Vector3 p = X * Vector3(pose.x_m, pose.y_m, 0.0);
  return {p.x(), p.y(), WrapAngle(pose.yaw_rad + YawOf(X.linear()))};
}

void CarryCentroidal(const Pose& X, CentroidalTrajectory& centroidal) {
  for (Vector3& p : centroidal.p_WC) p = X * p;
  for (Vector3& v : centroidal.v_WC) v = X.linear() * v;
  for (Vector3& a : centroidal.a_WC) a = X.linear() * a;
  for (Vector2& p : centroidal.p_WZ) p = (X * Vector3(p.x(), p.y(), 0.0)).head<2>();
}

void CarryWholeBody(const Pose& X, WholeBodyTrajectory& w) {
  for (VectorX& q : w.q) q = CarriedState(X, std::move(q));
  for (VectorX& v : w.v) v = CarriedRates(X, std::move(v));
  for (VectorX& a : w.a) a = CarriedRates(X, std::move(a));
  for (std::vector<ContactWrench>& wrenches : w.wrenches) {
    for (ContactWrench& wrench : wrenches) wrench = {X.linear() * wrench.force_W, X.linear() * wrench.moment_W};
  }
}

}  // namespace

Pose PoseOf(const PlanarPose& pose) {
  Pose X = Pose::Identity();
  X.linear() = YawRotation(pose.yaw_rad);
  X.translation() << pose.x_m, pose.y_m, 0.0;
  return X;
}

PlanarPose BaseInPlan(const VectorX& q) { return {q[0], q[1], YawOf(BaseRotation(q))}; }

VectorX CarriedState(const Pose& X, VectorX q) {
  const Quaternion R_WB(q[6], q[3], q[4], q[5]);
  q.head<3>() = X * Vector3(q.head<3>());
  q.segment<4>(3) = (Quaternion(X.linear()) * R_WB).normalized().coeffs();
  return q;
}

VectorX CarriedRates(const Pose& X, VectorX v) {
  v.head<3>() = X.linear() * Vector3(v.head<3>());
  v.segment<3>(3) = X.linear() * Vector3(v.segment<3>(3));
  return v;
}

MotionPlan CarriedPlan(const Pose& X, double later_s, MotionPlan plan) {
  plan.goal = Carried(X, plan.goal);
  for (PlanGate& gate : plan.gates) gate.at_s += later_s;
  for (MotionPart& part : plan.parts) {
    part.goal = Carried(X, part.goal);
    part.start_s += later_s;
    part.end_s += later_s;
  }
  for (ContactPhase& phase : plan.schedule.phases) {
    phase.start_s += later_s;
    phase.end_s += later_s;
  }
  for (Foothold& foothold : plan.footsteps.footholds) {
    foothold.X_WF = X * foothold.X_WF;
    foothold.roll_W = X.linear() * foothold.roll_W;
    foothold.touchdown_s += later_s;
    foothold.liftoff_s += later_s;
    if (foothold.heel_off_s) *foothold.heel_off_s += later_s;
  }
  for (SwingTrajectory& swing : plan.swings) {
    swing.X_WF_start = X * swing.X_WF_start;
    swing.X_WF_end = X * swing.X_WF_end;
    for (Vector3& point : swing.detour_W) point = X.linear() * point;  // a vector, not a point
    swing.start_s += later_s;
    swing.end_s += later_s;
  }
  plan.centroidal.start_s += later_s;
  plan.whole_body.start_s += later_s;
  CarryCentroidal(X, plan.centroidal);
  CarryWholeBody(X, plan.whole_body);
  return plan;
}

}  // namespace gaitwright
