// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/given_forces.h"

#include <algorithm>
#include <cmath>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/spatial/dense_solvers.h"
#include "planning/plan/support_plane.h"

namespace gaitwright {
namespace {

/// Computes the wrenches and torques row by row.
class ForceTaker {
 public:
  ForceTaker(const RobotModel& model, const EvenMotion& motion, MotionPlan& plan)
      : model_(model), motion_(motion), plan_(plan), scratch_(model), jacobian_(6, model.nv()) {
    scale_ = VectorX::Constant(model.nv(), 1.0 / (model.weight_n() * model.leg_length_m()));
    scale_.head<3>().setConstant(1.0 / model.weight_n());
    for (int d = 0; d < model.num_dofs(); ++d) {
      if (model.LeaderOf(d).is_prismatic()) scale_[6 + d] = 1.0 / model.weight_n();
    }
  }

  void TakeRow(int row) {
    const auto k = static_cast<std::size_t>(row);
    const double time_s = motion_.TimeOf(row);
    InverseDynamics(model_, motion_.q[k], motion_.v[k], motion_.a[k], scratch_, needed_);
    std::vector<ContactWrench>& wrenches = plan_.whole_body.wrenches[k];
    wrenches.assign(model_.feet.size(), {});
    const FootSet stance = plan_.schedule.phases[static_cast<std::size_t>(PhaseAt(plan_.schedule, time_s))].stance;
    columns_.clear();
    for (std::size_t f = 0; f < model_.feet.size(); ++f) TakeFoot(k, f, Contains(stance, static_cast<int>(f)), time_s);
    if (!columns_.empty()) {
      const VectorX before = needed_;
      SolveFree(k, wrenches);
      if (DropUnloaded(wrenches)) {
        needed_ = before;
        SolveFree(k, wrenches);
      }
      if (motion_.force_W.empty()) KeepInCones(k, before, wrenches);
    }
    VectorX& tau = plan_.whole_body.tau[k];
    for (int d = 0; d < model_.num_dofs(); ++d) tau[d] = HasTorque(k, d) ? motion_.tau[k][d] : needed_[6 + d];
  }

 private:
  /// An unknown component of a wrench.
  struct Free {
    std::size_t foot;
    int axis;  // force, then moment
    VectorX column;
  };

  bool HasTorque(std::size_t k, int dof) const { return !motion_.tau.empty() && std::isfinite(motion_.tau[k][dof]); }

  /// Subtracts the known part of a foot's wrench from the required generalised forces, and stores its unknown
  /// components.
  void TakeFoot(std::size_t k, std::size_t f, bool stands, double time_s) {
    const Foot& foot = model_.feet[f];
    const bool given = !motion_.force_W.empty();
    const Vector3 force_W = given ? motion_.force_W[k][f] : Vector3::Zero();
    if (!stands && force_W.isZero()) return;
    const Vector3 normal_W = NormalUnder(plan_.footsteps, static_cast<int>(f), time_s);
    const Vector3 p_W = ContactFrame(model_, scratch_, static_cast<int>(f), normal_W).translation();
    const auto body = static_cast<std::size_t>(foot.body);
    PointJacobian(model_, scratch_, foot.body, scratch_.R_WB[body].transpose() * (p_W - scratch_.p_WB[body]),
                  jacobian_);
    plan_.whole_body.wrenches[k][f].force_W = force_W;
    needed_ -= jacobian_.topRows<3>().transpose() * force_W;
    const int first = given ? 3 : 0, last = foot.has_sole() ? 6 : 3;
    for (int axis = first; axis < last && stands; ++axis)
      columns_.push_back({f, axis, jacobian_.row(axis).transpose()});
  }

  /// Leaves out feet with nearly no load, whose forces are only rounding errors. @return whether there were any.
  bool DropUnloaded(std::vector<ContactWrench>& wrenches) {
    constexpr double kNothing = 5e-3;  // share of the weight
    if (!motion_.force_W.empty()) return false;
    const auto unloaded = [&](const Free& part) {
      return wrenches[part.foot].force_W.norm() < kNothing * model_.weight_n();
    };
    const auto kept =
        std::stable_partition(columns_.begin(), columns_.end(), [&](const Free& p) { return !unloaded(p); });
    if (kept == columns_.end()) return false;
    for (auto part = kept; part != columns_.end(); ++part) wrenches[part->foot] = {};
    columns_.erase(kept, columns_.end());
    return true;
  }

  /// Moves forces onto their friction cones if they are outside by no more than the error of derived accelerations, and
  /// solves for the forces of the other feet again. The remaining error of the base is within the audit's tolerance.
  void KeepInCones(std::size_t k, VectorX before, std::vector<ContactWrench>& wrenches) {
    constexpr double kRounding = 0.015;  // share of the weight
    const double time_s = motion_.TimeOf(static_cast<int>(k));
    for (bool more = true; more;) {
      more = false;
      for (std::size_t f = 0; f < wrenches.size(); ++f) {
        const Vector3 inside_W = NearestInCone(f, time_s, wrenches[f].force_W);
        const double outside = (wrenches[f].force_W - inside_W).norm();
        if (!(outside > 0.0 && outside < kRounding * model_.weight_n()) || !Settle(f, inside_W, before)) continue;
        wrenches[f].force_W = inside_W;
        more = true;
      }
      if (!more) break;
      needed_ = before;
      SolveFree(k, wrenches);
    }
  }

  /// The nearest force in the friction cone: no tension, and a tangential force within friction times normal force.
  Vector3 NearestInCone(std::size_t f, double time_s, const Vector3& force_W) const {
    const int foot = static_cast<int>(f);
    const Vector3 normal_W = NormalUnder(plan_.footsteps, foot, time_s);
    const double normal = std::max(0.0, force_W.dot(normal_W));
    const double cone = normal * FrictionUnder(plan_.terrain, plan_.footsteps, foot, time_s);
    const Vector3 across_W = force_W - force_W.dot(normal_W) * normal_W;
    if (normal == 0.0) return Vector3::Zero();
    return across_W.norm() <= cone ? force_W : Vector3(normal * normal_W + cone / across_W.norm() * across_W);
  }

  /// Fixes a foot's force: removes it from the unknowns and subtracts it from the required forces. @return whether it
  /// was unknown.
  bool Settle(std::size_t f, const Vector3& force_W, VectorX& needed) {
    const auto settled = [&](const Free& part) { return part.foot == f && part.axis < 3; };
    for (const Free& part : columns_) {
      if (settled(part)) needed -= force_W[part.axis] * part.column;
    }
    return std::erase_if(columns_, settled) > 0;
  }

  /// Solves for the unknown components by least squares over the equations without a free torque. A small weight on the
  /// wrenches resolves components that the motion does not determine.
  void SolveFree(std::size_t k, std::vector<ContactWrench>& wrenches) {
    constexpr double kSlight = 1e-5;
    if (columns_.empty()) return;
    const auto n = static_cast<Eigen::Index>(columns_.size());
    MatrixX A = MatrixX::Zero(model_.nv() + n, n);
    VectorX b = VectorX::Zero(model_.nv() + n);
    for (int row = 0; row < model_.nv(); ++row) {
      const bool torque = row >= 6 && HasTorque(k, row - 6);
      if (row >= 6 && !torque) continue;
      b[row] = scale_[row] * (needed_[row] - (torque ? motion_.tau[k][row - 6] : 0.0));
      for (Eigen::Index i = 0; i < n; ++i) A(row, i) = scale_[row] * columns_[static_cast<std::size_t>(i)].column[row];
    }
    for (Eigen::Index i = 0; i < n; ++i)
      A(model_.nv() + i, i) = kSlight * scale_[columns_[static_cast<std::size_t>(i)].axis < 3 ? 0 : 3];
    const VectorX x = SolveSymmetric(A.transpose() * A, A.transpose() * b);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Free& part = columns_[static_cast<std::size_t>(i)];
      (part.axis < 3 ? wrenches[part.foot].force_W[part.axis] : wrenches[part.foot].moment_W[part.axis - 3]) = x[i];
      needed_ -= x[i] * part.column;
    }
  }

  const RobotModel& model_;
  const EvenMotion& motion_;
  MotionPlan& plan_;
  DynamicsScratch scratch_;
  MatrixX jacobian_;
  VectorX needed_, scale_;
  std::vector<Free> columns_;
};

}  // namespace

void TakeGivenForces(const RobotModel& model, const EvenMotion& motion, MotionPlan& plan,
                     std::vector<DerivedPart>& derived) {
  if (motion.tau.empty() && motion.force_W.empty()) {
    derived.push_back({"contact forces and torques",
                       "inverse dynamics, with contact forces split over the stance feet inside their friction cones"});
    return;
  }
  ForceTaker taker(model, motion, plan);
  for (int row = 0; row < motion.size(); ++row) taker.TakeRow(row);
  if (motion.tau.empty()) derived.push_back({"torques", "inverse dynamics with the file's contact forces"});
  if (motion.force_W.empty())
    derived.push_back({"contact forces", "least-squares fit to the file's torques and the motion"});
}

}  // namespace gaitwright
