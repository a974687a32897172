// SPDX-License-Identifier: BSD-3-Clause
// Check `consistency`: columns of the same grid against each other, row by row.
#include <algorithm>
#include <cmath>

#include "kinematics/spatial/rotation.h"
#include "kinematics/stability/zero_moment_point.h"
#include "planning/audit/auditor.h"
#include "planning/audit/tolerances.h"

namespace gaitwright {

using namespace tolerance;
namespace {

/// Change of a position in one step, from v and a: the corrected trapezoidal rule, exact to the fifth order.
template <class Vector>
Vector StepOf(double h, const Vector& v0, const Vector& v1, const Vector& a0, const Vector& a1) {
  return 0.5 * h * (v0 + v1) + h * h / 12.0 * (a0 - a1);
}

}  // namespace

void Auditor::CheckColumns() {
  const WholeBodyTrajectory& w = plan_.whole_body;
  const double h = w.step_s;
  for (std::size_t k = 0; k < w.q.size(); ++k) {
    const double time_s = w.start_s + static_cast<double>(k) * h;
    const double norm = w.q[k].segment<4>(3).norm();
    if (!(std::abs(norm - 1.0) <= kRelative))
      findings_.Note(Law::kConsistency, "quaternion norm", time_s, norm, 1.0, "1");
    if (k + 1 == w.q.size()) break;
    const VectorX step = StepOf(h, w.v[k], w.v[k + 1], w.a[k], w.a[k + 1]);
    const VectorX change = (w.v[k + 1] - w.v[k]) / h - 0.5 * (w.a[k] + w.a[k + 1]);
    const Vector3 moved = w.q[k + 1].head<3>() - w.q[k].head<3>() - step.head<3>();
    const Vector3 turn = RotationLog(BaseRotation(w.q[k + 1]) * BaseRotation(w.q[k]).transpose());
    Expect("base position against velocity", time_s, moved.norm() / h, kSpeed, "m/s");
    Expect("base rotation against velocity", time_s, (turn - step.segment<3>(3)).norm() / h, kRate, "rad/s");
    Expect("base velocity against acceleration", time_s, change.head<3>().norm(), kAcceleration, "m/s^2");
    Expect("base angular velocity against acceleration", time_s, change.segment<3>(3).norm(), kAngular, "rad/s^2");
    for (int d = 0; d < model_.num_dofs(); ++d) {
      const std::string& name = model_.dof_names[static_cast<std::size_t>(d)];
      const bool slides = Slides(d);
      const double joint = std::abs(w.q[k + 1][7 + d] - w.q[k][7 + d] - step[6 + d]) / h;
      if (!(joint <= (slides ? kSpeed : kRate)))
        Expect(name + " position against velocity", time_s, joint, slides ? kSpeed : kRate, slides ? "m/s" : "rad/s");
      if (!(std::abs(change[6 + d]) <= kAngular))
        Expect(name + " velocity against acceleration", time_s, std::abs(change[6 + d]), kAngular,
               slides ? "m/s^2" : "rad/s^2");
    }
  }
}

void Auditor::CheckCentroidal() {
  const CentroidalTrajectory& c = plan_.centroidal;
  const WholeBodyTrajectory& w = plan_.whole_body;
  if (c.p_WC.size() != w.q.size() || c.start_s != w.start_s || c.step_s != w.step_s) {
    findings_.Note(Law::kConsistency, "centroidal rows", w.start_s, static_cast<double>(c.p_WC.size()),
                   static_cast<double>(w.q.size()), "1");
    return;
  }
  const double h = c.step_s;
  for (std::size_t k = 0; k < c.p_WC.size(); ++k) {
    const double time_s = c.start_s + static_cast<double>(k) * h;
    InverseDynamics(model_, w.q[k], w.v[k], w.a[k], scratch_, needed_);
    const Vector3 p_WC = CentreOfMass(model_, scratch_);
    const Vector3 v_WC = CentroidalMomentum(model_, scratch_).head<3>() / model_.total_mass_kg;
    const Vector3 a_WC = needed_.head<3>() / model_.total_mass_kg - kGravity * Vector3::UnitZ();
    Expect("centre of mass against joints", time_s, (p_WC - c.p_WC[k]).norm(), kPosition, "m");
    Expect("velocity of the centre of mass against joints", time_s, (v_WC - c.v_WC[k]).norm(), kSpeed, "m/s");
    Expect("acceleration of the centre of mass against joints", time_s, (a_WC - c.a_WC[k]).norm(), kComAcceleration,
           "m/s^2");
    FindFooting(time_s);
    if (const GroundPlane plane = SupportPlaneAt(plan_.schedule, time_s, points_); PressesOn(plane)) {
      const Vector2 p_WZ = ZeroMomentPoint(scratch_.p_WB[0], needed_.head<3>(), needed_.segment<3>(3), plane).head<2>();
      // At small vertical force, a negligible moment moves the ZMP far.
      const double slight = kCertain * (p_WC.z() - plane.HeightAt(p_WC.head<2>())) * model_.weight_n() / needed_[2];
      Expect("reference of the zero-moment point against joints", time_s, (p_WZ - c.p_WZ[k]).norm(),
             std::max(kZmp, slight), "m");
    }
    if (k + 1 == c.p_WC.size()) break;
    const Vector3 step = StepOf(h, c.v_WC[k], c.v_WC[k + 1], c.a_WC[k], c.a_WC[k + 1]);
    const Vector3 change = (c.v_WC[k + 1] - c.v_WC[k]) / h - 0.5 * (c.a_WC[k] + c.a_WC[k + 1]);
    Expect("centre of mass against its velocity", time_s, (c.p_WC[k + 1] - c.p_WC[k] - step).norm() / h, kSpeed, "m/s");
    Expect("velocity of the centre of mass against its acceleration", time_s, change.norm(), kComAcceleration, "m/s^2");
  }
}

void Auditor::CheckPendulum() {
  const CentroidalTrajectory& c = plan_.centroidal;
  if (c.p_WC.empty()) return;
  double height = 0.0;
  for (std::size_t k = 0; k < c.p_WC.size(); ++k) {
    const GroundPlane plane = CarryingPlaneAt(plan_.footsteps, static_cast<int>(model_.feet.size()),
                                              c.start_s + static_cast<double>(k) * c.step_s);
    height += c.p_WC[k].z() - plane.HeightAt(c.p_WC[k].head<2>());
  }
  height /= static_cast<double>(c.p_WC.size());
  const double frequency = std::sqrt(kGravity / height);
  if (!(std::abs(c.omega_rad_s - frequency) <= kFrequency * frequency))
    findings_.Note(Law::kConsistency, "frequency of the pendulum", c.start_s, c.omega_rad_s, frequency, "rad/s");
}

}  // namespace gaitwright
