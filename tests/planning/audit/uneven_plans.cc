// SPDX-License-Identifier: BSD-3-Clause
#include "tests/planning/audit/uneven_plans.h"

#include <cmath>
#include <utility>

#include "kinematics/dynamics/contact_split.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/stability/zero_moment_point.h"
#include "planning/plan/carried_plan.h"
#include "planning/plan/support_plane.h"

namespace gaitwright {

MotionPlan CarriedWithGround(const Pose& X, MotionPlan plan) {
  MotionPlan carried = CarriedPlan(X, 0.0, std::move(plan));
  for (TerrainPatch& patch : carried.terrain.patches) patch.X_WT = X * patch.X_WT;
  return carried;
}

void CutToSlab(MotionPlan& plan, double half_m) {
  for (TerrainPatch& patch : plan.terrain.patches)
    patch.outline_T = {{-half_m, -half_m}, {half_m, -half_m}, {half_m, half_m}, {-half_m, half_m}};
}

void ReplaceByField(MotionPlan& plan, double height_m) {
  HeightField field;
  field.name = "field";
  field.resolution_m = 0.05;
  field.columns = field.rows = 81;
  field.origin_W = Vector2::Constant(-0.5 * field.resolution_m * (field.columns - 1));
  field.height_m.assign(static_cast<std::size_t>(field.columns * field.rows), height_m);
  field.friction = plan.terrain.patches[0].friction;
  plan.terrain.patches.clear();
  plan.terrain.height_fields = {field};
}

MotionPlan StandOnSlope(const RobotModel& model, const MotionPlan& plan, const Matrix3& tilt) {
  Pose X = Pose::Identity();
  X.linear() = tilt;
  MotionPlan still = CarriedWithGround(X, plan);
  still.swings.clear();
  const double end_s = still.whole_body.start_s + 0.1;
  const FootSet all = AllFeet(static_cast<int>(model.feet.size()));
  still.schedule.phases = {{still.whole_body.start_s, end_s, all}};
  auto& holds = still.footsteps.footholds;
  holds.resize(model.feet.size());
  DynamicsScratch scratch(model);
  const VectorX q = still.whole_body.q.front(), zero = VectorX::Zero(model.nv());
  VectorX tau;
  InverseDynamics(model, q, zero, zero, scratch, tau);
  const Vector3 normal_W = tilt.col(2);
  std::vector<ContactPoint> contacts;
  std::vector<std::size_t> foot_of;
  ContactsByFoot points(model.feet.size());
  for (std::size_t f = 0; f < model.feet.size(); ++f) {
    holds[f].liftoff_s = end_s;
    holds[f].roll_W.setZero();
    holds[f].X_WF.translation() = ContactFrame(model, scratch, static_cast<int>(f), normal_W).translation();
    points[f] = ContactPoints(model, scratch, static_cast<int>(f), normal_W);
    for (const Vector3& p : points[f]) {
      contacts.push_back({p, normal_W, 0.7, 1.0});
      foot_of.push_back(f);
    }
  }
  const PointWrench needed{scratch.p_WB[0], tau.head<3>(), tau.segment<3>(3)};
  ContactSplit split;
  ContactSplitter().Solve(contacts, needed, split);
  std::vector<ContactWrench> wrenches(model.feet.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const std::size_t f = foot_of[i];
    wrenches[f].force_W += split.force_W[i];
    wrenches[f].moment_W += (contacts[i].p_W - holds[f].X_WF.translation()).cross(split.force_W[i]);
    AddPointForce(model, scratch, model.feet[f].body, contacts[i].p_W, -split.force_W[i], tau);
  }
  const Vector3 p_WC = CentreOfMass(model, scratch);
  const GroundPlane plane = PlaneThrough(points, all);
  const Vector2 zmp = ZeroMomentPoint(needed.p_W, needed.force_W, needed.moment_W, plane).head<2>();
  const auto rows = static_cast<std::size_t>(1 + std::lround(0.1 / still.whole_body.step_s));
  WholeBodyTrajectory& w = still.whole_body;
  w.q.assign(rows, q);
  w.v.assign(rows, zero);
  w.a.assign(rows, zero);
  w.tau.assign(rows, tau.tail(model.num_dofs()));
  w.wrenches.assign(rows, wrenches);
  CentroidalTrajectory& c = still.centroidal;
  c.p_WC.assign(rows, p_WC);
  c.v_WC.assign(rows, Vector3::Zero());
  c.a_WC.assign(rows, Vector3::Zero());
  c.p_WZ.assign(rows, zmp);
  c.omega_rad_s = std::sqrt(kGravity / (p_WC.z() - plane.HeightAt(p_WC.head<2>())));
  MotionPart& part = still.parts.front();
  part.command = {};
  part.command.extent = WalkCommand::Extent::kDuration;
  part.end_s = w.end_s();
  return still;
}

}  // namespace gaitwright
