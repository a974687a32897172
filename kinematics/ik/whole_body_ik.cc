// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/ik/whole_body_ik.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/spatial/rotation.h"

namespace gaitwright {
namespace {

constexpr double kConverged = 1e-10;
constexpr int kMaxIterations = 40;
constexpr double kDependent = 1e-3;  // of a row's length, left after those above are taken out

bool HasRotation(const Foot& foot) { return foot.type == FootType::kSole || foot.type == FootType::kLine; }

/// r [n]x: added to the linear Jacobian by the angular one, it gives the material point under a sphere.
Matrix3 RollMatrix(const Foot& foot, const Vector3& normal) { return foot.radius * Skew(normal); }

Vector3 WantedPosition(const Foot& foot, const FootTarget& target, const Matrix3& R_WF) {
  if (foot.radius == 0.0) return target.p_WF;
  return target.p_WF + foot.radius * RotationLog(R_WF * target.R_anchor.transpose()).cross(target.normal_W);
}

/// The column, beyond the base's six, whose unit vector has most left once directions (orthonormal) are taken out.
std::size_t LeastUsed(const std::vector<Eigen::RowVectorXd>& directions) {
  constexpr double kTie = 1e-9;
  std::size_t least = 6;
  double most_left = -1.0;
  for (Eigen::Index c = 6; c < directions.front().size(); ++c) {
    double left = 1.0;
    for (const auto& direction : directions) left -= direction[c] * direction[c];
    if (left < most_left - kTie) continue;
    most_left = left;
    least = static_cast<std::size_t>(c);
  }
  return least;
}

void Integrate(const VectorX& step, VectorX& q) {
  q.head<3>() += step.head<3>();
  const Quaternion turned(RotationExp(step.segment<3>(3)) * Quaternion(q[6], q[3], q[4], q[5]).toRotationMatrix());
  q.segment<4>(3) = turned.normalized().coeffs();
  q.tail(q.size() - 7) += step.tail(step.size() - 6);
}

}  // namespace

WholeBodyIk::WholeBodyIk(const RobotModel& model) : model_(&model), scratch_(model) {
  foot_jacobians_.assign(model.feet.size(), MatrixX::Zero(6, model.nv()));
  com_jacobian_ = MatrixX::Zero(3, model.nv());
  ListRows();
  ChooseRows();
  const auto n = static_cast<Eigen::Index>(columns_.size());
  system_ = SquareSolver(n);
  rhs_.resize(n);
  solution_.resize(n);
  step_ = VectorX::Zero(model.nv());
  foot_bias_.resize(model.feet.size());
}

void WholeBodyIk::ListRows() {
  const char* axes[] = {"x", "y", "z"};
  for (std::size_t f = 0; f < model_->feet.size(); ++f) {
    const Foot& foot = model_->feet[f];
    const int index = static_cast<int>(f);
    for (int axis = 0; axis < 3; ++axis) {
      rows_.push_back({Row::Kind::kFootLinear, index, axis, fmt::format("{} position {}", foot.name, axes[axis])});
    }
    for (int axis = foot.type == FootType::kLine ? 1 : 0; axis < 3 && HasRotation(foot); ++axis) {
      rows_.push_back({Row::Kind::kFootAngular, index, axis, fmt::format("{} rotation {}", foot.name, axes[axis])});
    }
  }
  for (int axis = 0; axis < 3; ++axis) {
    rows_.push_back({Row::Kind::kCentreOfMass, -1, axis, fmt::format("centre of mass {}", axes[axis])});
  }
  const char* turns[] = {"base roll", "base pitch", "base yaw"};
  for (int axis = 0; axis < 3; ++axis) rows_.push_back({Row::Kind::kBaseRotation, -1, axis, turns[axis]});
}

void WholeBodyIk::ChooseRows() {
  std::vector<bool> in_leg(static_cast<std::size_t>(model_->num_dofs()), false);
  for (const Leg& leg : model_->legs) {
    for (const int joint : leg.joints) {
      in_leg[static_cast<std::size_t>(model_->joints[static_cast<std::size_t>(joint)].dof)] = true;
    }
  }
  for (int i = 0; i < 6; ++i) columns_.push_back(i);
  for (int dof = 0; dof < model_->num_dofs(); ++dof) {
    if (in_leg[static_cast<std::size_t>(dof)]) columns_.push_back(6 + dof);
  }
  ForwardKinematics(*model_, StandingConfiguration(*model_), scratch_);
  BodyTarget standing;
  standing.feet.resize(model_->feet.size());
  UpdateJacobians(standing);
  std::vector<Eigen::RowVectorXd> basis;
  std::vector<Row> chosen;
  const auto take = [&](Eigen::RowVectorXd row) {
    const double length = row.norm();
    for (const auto& direction : basis) row -= row.dot(direction) * direction;
    if (basis.size() == columns_.size() || row.norm() < kDependent * length) return false;
    basis.push_back(row.normalized());
    return true;
  };
  for (const Row& row : rows_) {
    if (take(RowJacobian(row)(columns_))) {
      chosen.push_back(row);
    } else {
      notes_.push_back(fmt::format("whole-body IK: {} yields, the legs have no freedom left for it", row.name));
    }
  }
  rows_ = chosen;
  // Legs with freedoms to spare: hold those that the tasks use least, one after the other.
  while (basis.size() < columns_.size()) {
    const std::size_t held = LeastUsed(basis);
    Eigen::RowVectorXd unit = Eigen::RowVectorXd::Zero(static_cast<Eigen::Index>(columns_.size()));
    unit[static_cast<Eigen::Index>(held)] = 1.0;
    if (!take(unit)) break;
    notes_.push_back(fmt::format("whole-body IK: joint {} is held at its standing position",
                                 model_->dof_names[static_cast<std::size_t>(columns_[held] - 6)]));
    columns_[held] = -1;
  }
  std::erase(columns_, -1);
}

void WholeBodyIk::UpdateJacobians(const BodyTarget& target) {
  for (std::size_t f = 0; f < model_->feet.size(); ++f) {
    const Foot& foot = model_->feet[f];
    MatrixX& J = foot_jacobians_[f];
    PointJacobian(*model_, scratch_, foot.body, foot.X_BF.translation(), J);
    if (foot.radius > 0.0) {
      J.topRows<3>() += RollMatrix(foot, target.feet[f].normal_W).lazyProduct(J.bottomRows<3>());
    }
  }
  CentreOfMassJacobian(*model_, scratch_, com_jacobian_);
}

Eigen::RowVectorXd WholeBodyIk::RowJacobian(const Row& row) const {
  switch (row.kind) {
    case Row::Kind::kFootLinear:
      return foot_jacobians_[static_cast<std::size_t>(row.foot)].row(row.axis);
    case Row::Kind::kFootAngular:
      return foot_jacobians_[static_cast<std::size_t>(row.foot)].row(3 + row.axis);
    case Row::Kind::kCentreOfMass:
      return com_jacobian_.row(row.axis);
    case Row::Kind::kBaseRotation:
      break;
  }
  Eigen::RowVectorXd unit = Eigen::RowVectorXd::Zero(model_->nv());
  unit[3 + row.axis] = 1.0;
  return unit;
}

void WholeBodyIk::AssembleSystem() {
  MatrixX& system = system_.matrix();
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    const Row& row = rows_[r];
    const auto i = static_cast<Eigen::Index>(r);
    if (row.kind == Row::Kind::kBaseRotation) {
      system.row(i).setZero();
      system(i, 3 + row.axis) = 1.0;
      continue;
    }
    const MatrixX& J =
        row.kind == Row::Kind::kCentreOfMass ? com_jacobian_ : foot_jacobians_[static_cast<std::size_t>(row.foot)];
    const Eigen::Index from = row.axis + (row.kind == Row::Kind::kFootAngular ? 3 : 0);
    for (std::size_t c = 0; c < columns_.size(); ++c) system(i, static_cast<Eigen::Index>(c)) = J(from, columns_[c]);
  }
  system_.Factor();
}

Pose WholeBodyIk::FootPose(int foot) const {
  const Foot& f = model_->feet[static_cast<std::size_t>(foot)];
  return FramePose(scratch_, f.body, f.X_BF);
}

double WholeBodyIk::RowError(const Row& row, const BodyTarget& target) const {
  if (row.kind == Row::Kind::kCentreOfMass) return (target.p_WC - CentreOfMass(*model_, scratch_))[row.axis];
  if (row.kind == Row::Kind::kBaseRotation) {
    return RotationLog(target.R_WB * scratch_.R_WB[0].transpose())[row.axis];
  }
  const FootTarget& wanted = target.feet[static_cast<std::size_t>(row.foot)];
  const Foot& foot = model_->feet[static_cast<std::size_t>(row.foot)];
  const Pose X_WF = FootPose(row.foot);
  if (row.kind == Row::Kind::kFootAngular) return RotationLog(wanted.R_WF * X_WF.linear().transpose())[row.axis];
  return (WantedPosition(foot, wanted, X_WF.linear()) - X_WF.translation())[row.axis];
}

Result<int> WholeBodyIk::SolvePosition(const BodyTarget& target, VectorX& q) {
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    ForwardKinematics(*model_, q, scratch_);
    for (std::size_t r = 0; r < rows_.size(); ++r) rhs_[static_cast<Eigen::Index>(r)] = RowError(rows_[r], target);
    const double error = rhs_.lpNorm<Eigen::Infinity>();
    if (error < kConverged) return iteration;
    if (!std::isfinite(error)) break;
    UpdateJacobians(target);
    AssembleSystem();
    system_.Solve(rhs_, solution_);
    const double largest = solution_.lpNorm<Eigen::Infinity>();
    if (largest > 0.3) solution_ *= 0.3 / largest;
    for (std::size_t c = 0; c < columns_.size(); ++c) step_[columns_[c]] = solution_[static_cast<Eigen::Index>(c)];
    Integrate(step_, q);
  }
  return OutOfReach(target);
}

Failure WholeBodyIk::OutOfReach(const BodyTarget& target) const {
  std::size_t worst = 0;
  double distance = -1.0;
  for (std::size_t f = 0; f < model_->feet.size(); ++f) {
    const Foot& foot = model_->feet[f];
    const Pose X_WF = FootPose(static_cast<int>(f));
    const double gap = (WantedPosition(foot, target.feet[f], X_WF.linear()) - X_WF.translation()).norm();
    if (!(gap <= distance)) {
      distance = gap;
      worst = f;
    }
  }
  const double com_gap = (target.p_WC - CentreOfMass(*model_, scratch_)).norm();
  return {FailureKind::kInfeasible,
          "out_of_reach",
          "WholeBodyIk",
          fmt::format("foot '{}' cannot reach its target: {:.1f} mm are missing (the centre of mass is {:.1f} mm off)",
                      model_->feet[worst].name, 1e3 * distance, 1e3 * com_gap),
          {"lower the speed or the step length, or lower the centre of mass"}};
}

void WholeBodyIk::SolveRates(const BodyTarget& target, const VectorX& q, VectorX& v, VectorX& a) {
  v.setZero(model_->nv());
  a.setZero(model_->nv());
  ForwardKinematics(*model_, q, scratch_);
  UpdateJacobians(target);
  AssembleSystem();
  const auto wanted = [&](const Row& row, bool second) -> double {
    const FootTarget* foot = row.foot >= 0 ? &target.feet[static_cast<std::size_t>(row.foot)] : nullptr;
    switch (row.kind) {
      case Row::Kind::kFootLinear:
        return second ? foot->a_WF[row.axis] : foot->v_WF[row.axis];
      case Row::Kind::kFootAngular:
        return second ? foot->alpha_WF[row.axis] : foot->w_WF[row.axis];
      case Row::Kind::kCentreOfMass:
        return second ? target.a_WC[row.axis] : target.v_WC[row.axis];
      case Row::Kind::kBaseRotation:
        break;
    }
    return second ? target.alpha_WB[row.axis] : target.w_WB[row.axis];
  };
  const auto scatter = [&](VectorX& out) {
    system_.Solve(rhs_, solution_);
    for (std::size_t c = 0; c < columns_.size(); ++c) out[columns_[c]] = solution_[static_cast<Eigen::Index>(c)];
  };
  for (std::size_t r = 0; r < rows_.size(); ++r) rhs_[static_cast<Eigen::Index>(r)] = wanted(rows_[r], false);
  scatter(v);
  ForwardVelocities(*model_, q, v, scratch_);
  for (std::size_t f = 0; f < foot_bias_.size(); ++f) {
    const Foot& foot = model_->feet[f];
    Vector6& bias = foot_bias_[f];
    bias = PointBiasAcceleration(scratch_, foot.body, foot.X_BF.translation());
    if (foot.radius > 0.0) bias.head<3>() += RollMatrix(foot, target.feet[f].normal_W) * bias.tail<3>();
  }
  const Vector3 com_bias = CentreOfMassBiasAcceleration(*model_, scratch_);
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    const Row& row = rows_[r];
    double value = wanted(row, true);
    if (row.kind == Row::Kind::kCentreOfMass) value -= com_bias[row.axis];
    if (row.kind == Row::Kind::kFootLinear) value -= foot_bias_[static_cast<std::size_t>(row.foot)][row.axis];
    if (row.kind == Row::Kind::kFootAngular) value -= foot_bias_[static_cast<std::size_t>(row.foot)][3 + row.axis];
    rhs_[static_cast<Eigen::Index>(r)] = value;
  }
  scatter(a);
}

}  // namespace gaitwright
