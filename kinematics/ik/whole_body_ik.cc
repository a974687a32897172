// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/ik/whole_body_ik.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "kinematics/ik/square_solver.h"
#include "kinematics/model/body_tree.h"
#include "kinematics/spatial/rotation.h"

namespace gaitwright {
namespace {

constexpr double kConverged = 1e-10;
constexpr int kMaxIterations = 40;
constexpr double kLongestStep = 0.3;  // [m, rad] of any coordinate in one iteration
constexpr double kDependent = 1e-3;   // a row is dependent if this share of its length is left after projection
/// Threshold like kDependent for rows of feet that no joint moves, such as those across planar legs. Only these rows
/// hold the base. If the lengths of legs differ by some millimetres, the rest of such a row comes from this difference
/// and is not a degree of freedom.
constexpr double kOfBaseAlone = 0.02;

/// r [n]x. The linear Jacobian plus this matrix times the angular one is the Jacobian of a sphere's material contact
/// point.
Matrix3 RollMatrix(const Foot& foot, const Vector3& normal) { return foot.radius * Skew(normal); }

Vector3 WantedPosition(const Foot& foot, const FootTarget& target, const Matrix3& R_WF) {
  if (foot.radius == 0.0) return target.p_WF;
  return target.p_WF + foot.radius * RotationLog(R_WF * target.R_anchor.transpose()).cross(target.normal_anchor_W);
}

/// The joint column whose unit vector has the largest part outside the span of orthonormal directions. Columns `shared`
/// by legs have priority while one has such a part.
std::size_t LeastUsed(const std::vector<Eigen::RowVectorXd>& directions, const std::vector<bool>& shared) {
  constexpr double kTie = 1e-9;
  std::size_t least = 6;
  double most_left = -1.0;
  bool of_shared = false;
  for (Eigen::Index c = 6; c < directions.front().size(); ++c) {
    double left = 1.0;
    for (const auto& direction : directions) left -= direction[c] * direction[c];
    const bool is_shared = shared[static_cast<std::size_t>(c)] && left > kDependent * kDependent;
    if (is_shared == of_shared ? left < most_left - kTie : of_shared) continue;
    of_shared = is_shared;
    most_left = left;
    least = static_cast<std::size_t>(c);
  }
  return least;
}

/// For each joint coordinate (n), whether it moves more than one leg, like a waist.
std::vector<bool> SharedByLegs(const RobotModel& model) {
  std::vector<int> last(static_cast<std::size_t>(model.num_dofs()), -1);
  std::vector<bool> shared(last.size(), false);
  for (std::size_t leg = 0; leg < model.legs.size(); ++leg) {
    for (const int joint : model.legs[leg].joints) {
      const auto dof = static_cast<std::size_t>(model.joints[static_cast<std::size_t>(joint)].dof);
      shared[dof] = shared[dof] || (last[dof] >= 0 && last[dof] != static_cast<int>(leg));
      last[dof] = static_cast<int>(leg);
    }
  }
  return shared;
}

void Integrate(const VectorX& step, VectorX& q) {
  q.head<3>() += step.head<3>();
  const Quaternion turned(RotationExp(step.segment<3>(3)) * BaseRotation(q));
  q.segment<4>(3) = turned.normalized().coeffs();
  q.tail(q.size() - 7) += step.tail(step.size() - 6);
}

}  // namespace

WholeBodyIk::~WholeBodyIk() = default;

WholeBodyIk::WholeBodyIk(const RobotModel& model) : model_(&model), scratch_(model) {
  foot_jacobians_.assign(model.legs.size(), MatrixX::Zero(6, model.nv()));
  com_jacobian_ = MatrixX::Zero(3, model.nv());
  ListRows();
  ChooseRows();
  const auto n = static_cast<Eigen::Index>(columns_.size());
  system_ = std::make_unique<SquareSolver>(n);
  rhs_.resize(n);
  solution_.resize(n);
  step_ = VectorX::Zero(model.nv());
}

void WholeBodyIk::ListRows() {
  using Kind = Task::Kind;
  const auto add = [&](Kind kind, int foot, int first, const std::array<std::string, 3>& names) {
    for (int axis = first; axis < 3; ++axis)
      rows_.push_back({tasks_.size(), axis, names[static_cast<std::size_t>(axis)]});
    tasks_.push_back({kind, foot, Matrix3::Identity()});
  };
  const auto along = [](const std::string& what) {
    return std::array<std::string, 3>{what + " x", what + " y", what + " z"};
  };
  for (std::size_t f = 0; f < model_->legs.size(); ++f) {
    const Foot& foot = model_->feet[f];
    const int index = static_cast<int>(f);
    add(Kind::kFootLinear, index, 0, along(foot.name + " position"));
    if (foot.has_sole())
      add(Kind::kFootAngular, index, foot.type == FootType::kLine ? 1 : 0, along(foot.name + " rotation"));
  }
  add(Kind::kCentreOfMass, -1, 0, along("centre of mass"));
  add(Kind::kBaseRotation, -1, 0, {"base roll", "base pitch", "base yaw"});
}

void WholeBodyIk::ChooseRows() {
  const std::vector<bool> of_leg = DofsOfLegs(*model_);
  for (int i = 0; i < 6; ++i) columns_.push_back(i);
  for (int dof = 0; dof < model_->num_dofs(); ++dof) {
    if (of_leg[static_cast<std::size_t>(dof)]) columns_.push_back(6 + dof);
  }
  ForwardKinematics(*model_, StandingConfiguration(*model_), scratch_);
  BodyTarget standing;
  standing.feet.resize(model_->legs.size());
  for (std::size_t f = 0; f < standing.feet.size(); ++f) standing.feet[f].R_WF = FootPose(static_cast<int>(f)).linear();
  SetAxes(standing);
  UpdateJacobians(standing);
  std::vector<Eigen::RowVectorXd> basis;
  std::vector<Row> chosen;
  const auto take = [&](Eigen::RowVectorXd row, double dependent = kDependent) {
    const double length = row.norm();
    for (const auto& direction : basis) row -= row.dot(direction) * direction;
    if (basis.size() == columns_.size() || row.norm() < dependent * length) return false;
    basis.push_back(row.normalized());
    return true;
  };
  for (const Row& row : rows_) {
    const Eigen::RowVectorXd all = RowJacobian(row)(columns_);
    const double of_joints = all.tail(all.size() - 6).norm();
    const bool of_base_alone = tasks_[row.task].foot >= 0 && of_joints < kOfBaseAlone * all.norm();
    if (take(all, of_base_alone ? kOfBaseAlone : kDependent)) {
      chosen.push_back(row);
    } else {
      notes_.push_back(
          fmt::format("whole-body IK: {} is not tracked, because the legs have no degree of freedom left", row.name));
    }
  }
  rows_ = chosen;
  // Redundant legs: hold the joints that the tasks use least, one after the other. A waist that carries the legs is
  // held first, because the legs then still move symmetrically.
  const std::vector<bool> shared_by_legs = SharedByLegs(*model_);
  std::vector<bool> shared(columns_.size(), false);
  for (std::size_t c = 6; c < columns_.size(); ++c) {
    shared[c] = shared_by_legs[static_cast<std::size_t>(columns_[c] - 6)];
  }
  while (basis.size() < columns_.size()) {
    const std::size_t held = LeastUsed(basis, shared);
    Eigen::RowVectorXd unit = Eigen::RowVectorXd::Zero(static_cast<Eigen::Index>(columns_.size()));
    unit[static_cast<Eigen::Index>(held)] = 1.0;
    if (!take(unit)) break;
    notes_.push_back(fmt::format("whole-body IK: joint {} is held at its standing position",
                                 model_->dof_names[static_cast<std::size_t>(columns_[held] - 6)]));
    columns_[held] = -1;
  }
  std::erase(columns_, -1);
  for (int dof = 0; dof < model_->num_dofs(); ++dof) {
    if (std::find(columns_.begin(), columns_.end(), 6 + dof) == columns_.end()) held_.push_back(dof);
  }
}

void WholeBodyIk::UpdateJacobians(const BodyTarget& target) {
  for (std::size_t f = 0; f < model_->legs.size(); ++f) {
    const Foot& foot = model_->feet[f];
    MatrixX& J = foot_jacobians_[f];
    PointJacobian(*model_, scratch_, foot.body, foot.X_BF.translation(), J);
    if (foot.radius > 0.0) {
      J.topRows<3>() += RollMatrix(foot, target.feet[f].normal_W).lazyProduct(J.bottomRows<3>());
    }
  }
  CentreOfMassJacobian(*model_, scratch_, com_jacobian_);
}

void WholeBodyIk::SetAxes(const BodyTarget& target) {
  const Matrix3 R_WH = YawRotation(YawOf(target.R_WB));
  for (Task& task : tasks_) {
    task.axes_W = task.kind == Task::Kind::kFootAngular ? target.feet[static_cast<std::size_t>(task.foot)].R_WF : R_WH;
  }
}

Eigen::RowVectorXd WholeBodyIk::RowJacobian(const Row& row) const {
  const Task& task = tasks_[row.task];
  const Vector3 axis = task.axes_W.col(row.axis);
  switch (task.kind) {
    case Task::Kind::kFootLinear:
      return axis.transpose() * foot_jacobians_[static_cast<std::size_t>(task.foot)].topRows<3>();
    case Task::Kind::kFootAngular:
      return axis.transpose() * foot_jacobians_[static_cast<std::size_t>(task.foot)].bottomRows<3>();
    case Task::Kind::kCentreOfMass:
      return axis.transpose() * com_jacobian_;
    case Task::Kind::kBaseRotation:
      break;
  }
  Eigen::RowVectorXd of_base = Eigen::RowVectorXd::Zero(model_->nv());
  of_base.segment<3>(3) = axis.transpose();
  return of_base;
}

/// Coefficient of a row for one velocity coordinate.
double WholeBodyIk::Coefficient(const Row& row, int column) const {
  const Task& task = tasks_[row.task];
  const Vector3 axis = task.axes_W.col(row.axis);
  if (task.kind == Task::Kind::kBaseRotation) return column >= 3 && column < 6 ? axis[column - 3] : 0.0;
  const MatrixX& J =
      task.kind == Task::Kind::kCentreOfMass ? com_jacobian_ : foot_jacobians_[static_cast<std::size_t>(task.foot)];
  const Eigen::Index from = task.kind == Task::Kind::kFootAngular ? 3 : 0;
  return axis.dot(J.col(column).segment<3>(from));
}

void WholeBodyIk::AssembleSystem() {
  MatrixX& system = system_->matrix();
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    for (std::size_t c = 0; c < columns_.size(); ++c)
      system(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)) = Coefficient(rows_[r], columns_[c]);
  }
  system_->Factor();
}

void WholeBodyIk::FillRightHandSide() {
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    const Task& task = tasks_[rows_[r].task];
    rhs_[static_cast<Eigen::Index>(r)] = task.axes_W.col(rows_[r].axis).dot(task.value_W);
  }
}

void WholeBodyIk::TakeOutHeld(const VectorX& joint_rates) {
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    for (const int dof : held_) rhs_[static_cast<Eigen::Index>(r)] -= Coefficient(rows_[r], 6 + dof) * joint_rates[dof];
  }
}

Pose WholeBodyIk::FootPose(int foot) const {
  const Foot& f = model_->feet[static_cast<std::size_t>(foot)];
  return FramePose(scratch_, f.body, f.X_BF);
}

Vector3 WholeBodyIk::Error(const Task& task, const BodyTarget& target) const {
  if (task.kind == Task::Kind::kCentreOfMass) return target.p_WC - CentreOfMass(*model_, scratch_);
  if (task.kind == Task::Kind::kBaseRotation) return RotationLog(target.R_WB * scratch_.R_WB[0].transpose());
  const FootTarget& wanted = target.feet[static_cast<std::size_t>(task.foot)];
  const Pose X_WF = FootPose(task.foot);
  if (task.kind == Task::Kind::kFootAngular) return RotationLog(wanted.R_WF * X_WF.linear().transpose());
  const Foot& foot = model_->feet[static_cast<std::size_t>(task.foot)];
  return WantedPosition(foot, wanted, X_WF.linear()) - X_WF.translation();
}

Result<int> WholeBodyIk::SolvePosition(const BodyTarget& target, VectorX& q) {
  SetAxes(target);
  if (target.posture.q.size() > 0) {
    for (const int dof : held_) q[7 + dof] = target.posture.q[dof];
  }
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    ForwardKinematics(*model_, q, scratch_);
    for (Task& task : tasks_) task.value_W = Error(task, target);
    FillRightHandSide();
    if (!rhs_.allFinite()) break;
    if (rhs_.lpNorm<Eigen::Infinity>() < kConverged) return iteration;
    UpdateJacobians(target);
    AssembleSystem();
    system_->Solve(rhs_, solution_);
    const double largest = solution_.lpNorm<Eigen::Infinity>();
    if (largest > kLongestStep) solution_ *= kLongestStep / largest;
    for (std::size_t c = 0; c < columns_.size(); ++c) step_[columns_[c]] = solution_[static_cast<Eigen::Index>(c)];
    Integrate(step_, q);
  }
  return OutOfReach(target);
}

Failure WholeBodyIk::OutOfReach(const BodyTarget& target) const {
  std::size_t worst = 0;
  double distance = -1.0;
  for (std::size_t f = 0; f < model_->legs.size(); ++f) {
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
          FailureCode::kOutOfReach,
          "WholeBodyIk",
          fmt::format("foot '{}' cannot reach its target: it is {:.1f} mm away (the centre of mass is {:.1f} mm away "
                      "from its target)",
                      model_->feet[worst].name, 1e3 * distance, 1e3 * com_gap),
          {"lower the speed or the step length, or lower the centre of mass"}};
}

Vector3 WholeBodyIk::Rate(const Task& task, const BodyTarget& target) const {
  if (task.kind == Task::Kind::kCentreOfMass) return target.v_WC;
  if (task.kind == Task::Kind::kBaseRotation) return target.w_WB;
  const FootTarget& foot = target.feet[static_cast<std::size_t>(task.foot)];
  return task.kind == Task::Kind::kFootLinear ? foot.v_WF : foot.w_WF;
}

Vector3 WholeBodyIk::AccelerationLessBias(const Task& task, const BodyTarget& target) const {
  if (task.kind == Task::Kind::kCentreOfMass) return target.a_WC - CentreOfMassBiasAcceleration(*model_, scratch_);
  if (task.kind == Task::Kind::kBaseRotation) return target.alpha_WB;
  const Foot& foot = model_->feet[static_cast<std::size_t>(task.foot)];
  const FootTarget& wanted = target.feet[static_cast<std::size_t>(task.foot)];
  const Vector6 bias = PointBiasAcceleration(scratch_, foot.body, foot.X_BF.translation());
  if (task.kind == Task::Kind::kFootLinear) {
    return wanted.a_WF - bias.head<3>() - RollMatrix(foot, wanted.normal_W) * bias.tail<3>() -
           RollMatrix(foot, wanted.normal_rate_W) * scratch_.w_WB[static_cast<std::size_t>(foot.body)];
  }
  // A rotation relative to the target, about a free axis of F, rotates with F.
  const Vector3& w_WF = scratch_.w_WB[static_cast<std::size_t>(foot.body)];
  return wanted.alpha_WF + wanted.w_WF.cross(w_WF - wanted.w_WF) - bias.tail<3>();
}

void WholeBodyIk::SolveRates(const BodyTarget& target, const VectorX& q, VectorX& v, VectorX& a) {
  v.setZero(model_->nv());
  a.setZero(model_->nv());
  ForwardKinematics(*model_, q, scratch_);
  SetAxes(target);
  UpdateJacobians(target);
  AssembleSystem();
  const auto solve = [&](const VectorX& held, VectorX& out) {
    FillRightHandSide();
    if (held.size() > 0) {
      TakeOutHeld(held);
      for (const int dof : held_) out[6 + dof] = held[dof];
    }
    system_->Solve(rhs_, solution_);
    for (std::size_t c = 0; c < columns_.size(); ++c) out[columns_[c]] = solution_[static_cast<Eigen::Index>(c)];
  };
  for (Task& task : tasks_) task.value_W = Rate(task, target);
  solve(target.posture.v, v);
  ForwardVelocities(*model_, q, v, scratch_);
  for (Task& task : tasks_) task.value_W = AccelerationLessBias(task, target);
  solve(target.posture.a, a);
}

}  // namespace gaitwright
