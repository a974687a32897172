// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/spatial/dense_solvers.h"
#include "kinematics/spatial/rotation.h"
#include "optimisation/whole_body/finish_problem_internal.h"
#include "workflows/repair/nearest_posture_internal.h"

namespace gaitwright {

NearestPosture::NearestPosture(const RobotModel& model, const RepairOptions& options)
    : model_(model),
      scratch_(model),
      rows_(FreeFootRows(model)),
      give_(model.nv()),
      e_(VectorX::Zero(model.nv())),
      held_(static_cast<std::size_t>(model.num_dofs()), false),
      foot_J_(6, model.nv()) {
  give_.head<3>().setConstant(std::pow(options.base_position, -2.0));
  give_.segment<3>(3).setConstant(std::pow(options.base_rotation, -2.0));
  give_.tail(model.num_dofs()).setConstant(std::pow(options.joint, -2.0));
}

void NearestPosture::Assemble(const std::vector<Pose>& X_WF) {
  Eigen::Index count = 0;
  for (const auto& rows : rows_) count += std::count(rows.begin(), rows.end(), true);
  J_.resize(count, model_.nv());
  error_.resize(count);
  Eigen::Index at = 0;
  for (std::size_t f = 0; f < rows_.size(); ++f) {
    const Foot& foot = model_.feet[f];
    const Vector3 normal = X_WF[f].linear().col(2);
    const Pose now = FramePose(scratch_, foot.body, foot.X_BF);
    Vector6 off;
    off.head<3>() = X_WF[f].translation() + foot.radius * normal - now.translation();
    off.tail<3>() = RotationLog(X_WF[f].linear() * now.linear().transpose());
    PointJacobian(model_, scratch_, foot.body, foot.X_BF.translation(), foot_J_);
    off.tail<3>() = (now.linear().transpose() * off.tail<3>()).eval();
    foot_J_.bottomRows<3>() = (now.linear().transpose() * foot_J_.bottomRows<3>()).eval();
    for (std::size_t i = 0; i < 6; ++i) {
      if (!rows_[f][i]) continue;
      J_.row(at) = foot_J_.row(static_cast<Eigen::Index>(i));
      error_[at++] = off[static_cast<Eigen::Index>(i)];
    }
  }
}

/// q_given changed by e_, with joints in their ranges.
void NearestPosture::Move(const VectorX& q_given, VectorX& q) {
  constexpr double kMargin = 0.02;  // [rad], [m]: what the optimisation of the whole body keeps, and a little
  const Eigen::Index n = model_.num_dofs();
  for (Eigen::Index d = 0; d < n; ++d) {
    const int dof = static_cast<int>(d);
    const double given = q_given[7 + d], lowest = model_.dof_lower(dof), highest = model_.dof_upper(dof);
    // A posture that is nearer to an end than the margin may stay there.
    const double lower = std::min(lowest + kMargin, std::max(given, lowest)),
                 upper = std::max(highest - kMargin, std::min(given, highest));
    if (lower > upper) continue;
    const double inside = std::clamp(given + e_[6 + d], lower, upper);
    if (inside != given + e_[6 + d]) held_[static_cast<std::size_t>(d)] = true;
    e_[6 + d] = inside - given;
  }
  q = q_given;
  q.head<3>() += e_.head<3>();
  q.segment<4>(3) = Quaternion(RotationExp(e_.segment<3>(3)) * BaseRotation(q_given)).coeffs();
  q.tail(n) += e_.tail(n);
  ForwardKinematics(model_, q, scratch_);
}

double NearestPosture::Distance(const std::vector<Pose>& X_WF) const {
  double farthest = 0.0;
  for (std::size_t f = 0; f < rows_.size(); ++f) {
    const Foot& foot = model_.feet[f];
    const Vector3 aim = X_WF[f].translation() + foot.radius * X_WF[f].linear().col(2);
    farthest = std::max(farthest, (aim - FramePose(scratch_, foot.body, foot.X_BF).translation()).norm());
  }
  return farthest;
}

double NearestPosture::Solve(const VectorX& q_given, const std::vector<Pose>& X_WF, VectorX& q) {
  constexpr int kMost = 12;
  constexpr double kLittle = 1e-9, kDone = 1e-8;  // [m^2], [rad^2] of damping; [m], [rad]
  std::fill(held_.begin(), held_.end(), false);
  Move(q_given, q);
  for (int i = 0; i < kMost; ++i) {
    Assemble(X_WF);
    VectorX give = give_;
    for (std::size_t d = 0; d < held_.size(); ++d) {
      if (held_[d]) give[6 + static_cast<Eigen::Index>(d)] = 0.0;
    }
    // Change that cancels the errors and has the least weighted size, counted from q_given; held joints stay.
    VectorX fixed = VectorX::Zero(e_.size());
    for (std::size_t d = 0; d < held_.size(); ++d) {
      if (held_[d]) fixed[6 + static_cast<Eigen::Index>(d)] = e_[6 + static_cast<Eigen::Index>(d)];
    }
    const MatrixX weighted = give.asDiagonal() * J_.transpose();
    MatrixX square = J_ * weighted;
    square.diagonal().array() += kLittle;
    const VectorX next = fixed + weighted * SolveSymmetric(square, error_ + J_ * (e_ - fixed));
    const double step = (next - e_).lpNorm<Eigen::Infinity>();
    constexpr double kLongest = 0.5;  // [rad], [m]
    e_ += std::min(1.0, kLongest / std::max(step, kLongest)) * (next - e_);
    Move(q_given, q);
    if (step < kDone) break;
  }
  return Distance(X_WF);
}

}  // namespace gaitwright
