// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <utility>

#include "playback/bullet/condensed_solver_internal.h"
#include "playback/bullet/joint_rows_internal.h"
#include "playback/bullet/shared_motors_internal.h"

namespace gaitwright::bullet {
namespace {

constexpr double kSettled = 1e-9;  // relative change of impulses at which iterating ends
constexpr double kHeld = 1e-13;  // share of a row's own A that is rounding: others hold it, as friction does at a stop

btMultiBody* BodyOf(const btMultiBodySolverConstraint& row) {
  return row.m_multiBodyA != nullptr ? row.m_multiBodyA : row.m_multiBodyB;
}

/// Where a row's J is in Bullet's arrays.
int JacobianAt(const btMultiBodySolverConstraint& row) {
  return row.m_multiBodyA != nullptr ? row.m_jacAindex : row.m_jacBindex;
}

/// Of the row J qd + softness * impulse = target, less what J qd is without it.
double Target(const btMultiBodySolverConstraint& row) { return row.m_rhs / row.m_jacDiagABInv; }
double Softness(const btMultiBodySolverConstraint& row) { return row.m_cfm / row.m_jacDiagABInv; }

bool Holds(const btMultiBodySolverConstraint& row, double impulse) {
  return impulse > row.m_lowerLimit && impulse < row.m_upperLimit;
}

double Bounded(const btMultiBodySolverConstraint& row, double impulse) {
  return std::clamp<double>(impulse, row.m_lowerLimit, row.m_upperLimit);
}

}  // namespace

btScalar CondensedSolver::solveGroupCacheFriendlySetup(btCollisionObject** bodies, int num_bodies,
                                                       btPersistentManifold** manifolds, int num_manifolds,
                                                       btTypedConstraint** constraints, int num_constraints,
                                                       const btContactSolverInfo& info, btIDebugDraw* debug) {
  thinning_.Thin(manifolds, num_manifolds, info.m_timeStep);
  return btMultiBodyConstraintSolver::solveGroupCacheFriendlySetup(bodies, num_bodies, manifolds, num_manifolds,
                                                                   constraints, num_constraints, info, debug);
}

btScalar CondensedSolver::solveGroupCacheFriendlyIterations(btCollisionObject** bodies, int num_bodies,
                                                            btPersistentManifold** manifolds, int num_manifolds,
                                                            btTypedConstraint** constraints, int num_constraints,
                                                            const btContactSolverInfo& info, btIDebugDraw* debug) {
  btMultiBody* body = Gather();
  if (body == nullptr) return 0.0;
  WarmStart();
  bool taken_in = false;
  do {
    if (!Condense()) {  // gears that contradict each other: let projected Gauss-Seidel find a compromise
      return btMultiBodyConstraintSolver::solveGroupCacheFriendlyIterations(
          bodies, num_bodies, manifolds, num_manifolds, constraints, num_constraints, info, debug);
    }
    Iterate(info.m_numIterations);
  } while (MoveTurned() || (!std::exchange(taken_in, true) && TakeInStuck()) || MoveSaturated());
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const Line& line = lines_[i];
    const double own = OwnImpulse(line, impulse_[static_cast<Eigen::Index>(i)]);
    line.row->m_appliedImpulse = own;
    if (line.loss < 0) continue;
    impulse_[line.loss] = impulse_[static_cast<Eigen::Index>(i)] - own;
  }
  impulse_by_column_.setZero(U_.cols());
  for (std::size_t i = 0; i < lines_.size(); ++i) impulse_by_column_[column_[i]] += lines_[i].row->m_appliedImpulse;
  const VectorX change = U_ * impulse_by_column_;
  body->applyDeltaVeeMultiDof2(change.data(), 1.0);
  body->setPosUpdated(false);
  return 0.0;
}

btMultiBody* CondensedSolver::Gather() {
  lines_.clear();
  direct_.clear();
  iterated_.clear();
  sliding_.clear();
  AddLines(m_multiBodyNonContactConstraints, Kind::kDirect, 0);
  const int normals_at = static_cast<int>(lines_.size());
  AddLines(m_multiBodyNormalContactConstraints, Kind::kNormal, 0);
  AddLines(m_multiBodyFrictionContactConstraints, Kind::kFriction, normals_at);
  if (lines_.empty()) return nullptr;

  btMultiBody* body = BodyOf(*lines_.front().row);
  GatherMatrices(6 + body->getNumDofs());
  impulse_.setZero(static_cast<Eigen::Index>(lines_.size()));
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    if (i > 0 && Join(i - 1, i)) continue;
    const Kind kind = lines_[i].kind;
    auto& set = kind == Kind::kDirect ? direct_ : kind == Kind::kSliding ? sliding_ : iterated_;
    set.push_back(static_cast<Eigen::Index>(i));
  }
  GatherSharedSoftness();
  return body;
}

void CondensedSolver::GatherSharedSoftness() {
  const auto motor_of = [](const Line& line) -> const SharedMotorRow* {
    const bool is = line.kind == Kind::kDirect && line.row->m_orgDofIndex == SharedMotorRow::kSharedDrive;
    return is ? static_cast<const SharedMotorRow*>(line.row->m_orgConstraint) : nullptr;
  };
  shared_softness_.clear();
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const SharedMotorRow* first = motor_of(lines_[i]);
    if (first == nullptr) continue;
    for (std::size_t j = i + 1; j < lines_.size(); ++j) {
      const SharedMotorRow* second = motor_of(lines_[j]);
      if (second == nullptr || &second->motors() != &first->motors()) continue;
      shared_softness_.push_back({static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j),
                                  first->motors().SofteningOf(first->index(), second->index())});
    }
  }
}

void CondensedSolver::AddSharedSoftness(MatrixX& of_direct, MatrixX& across, MatrixX& of_iterated) const {
  for (const auto& [i, j, softness] : shared_softness_) {
    const Eigen::Index direct_i = direct_position_[static_cast<std::size_t>(i)],
                       direct_j = direct_position_[static_cast<std::size_t>(j)];
    const Eigen::Index other_i = position_[static_cast<std::size_t>(i)],
                       other_j = position_[static_cast<std::size_t>(j)];
    if (direct_i >= 0 && direct_j >= 0) {
      of_direct(direct_i, direct_j) += softness;
      of_direct(direct_j, direct_i) += softness;
    } else if (direct_i >= 0) {
      across(direct_i, other_j) += softness;
    } else if (direct_j >= 0) {
      across(direct_j, other_i) += softness;
    } else {
      of_iterated(other_i, other_j) += softness;
      of_iterated(other_j, other_i) += softness;
    }
  }
}

bool CondensedSolver::Join(std::size_t drive, std::size_t loss) {
  Line &first = lines_[drive], &second = lines_[loss];
  const bool are = first.kind == Kind::kDirect && second.kind == Kind::kDirect && column_[drive] == column_[loss] &&
                   first.row->m_orgDofIndex == MotorRow::kDrive && second.row->m_orgDofIndex == MotorRow::kLoss;
  if (!are) return false;
  const double together = first.softness + second.softness;
  first.b = (second.softness * first.b + first.softness * second.b) / together;
  first.softness *= second.softness / together;
  first.loss = static_cast<Eigen::Index>(loss);
  return true;
}

void CondensedSolver::Part(Line& drive) {
  drive.b = Target(*drive.row);
  drive.softness = Softness(*drive.row);
  direct_.push_back(std::exchange(drive.loss, -1));
}

double CondensedSolver::OwnImpulse(const Line& line, double impulse) const {
  if (line.loss < 0) return impulse;
  const Line& loss = lines_[static_cast<std::size_t>(line.loss)];
  const double own = Softness(*line.row), together = own + loss.softness;
  return (Target(*line.row) - loss.b + loss.softness * impulse) / together;
}

void CondensedSolver::GatherMatrices(Eigen::Index n) {
  column_.clear();
  Eigen::Index columns = 0;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const bool shared = i > 0 && JacobianAt(*lines_[i].row) == JacobianAt(*lines_[i - 1].row);
    column_.push_back(shared ? columns - 1 : columns++);
  }
  J_.resize(n, columns);
  U_.resize(n, columns);
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const int at = JacobianAt(*lines_[i].row);
    J_.col(column_[i]) = Eigen::Map<const VectorX>(&m_data.m_jacobians[at], n);
    U_.col(column_[i]) = Eigen::Map<const VectorX>(&m_data.m_deltaVelocitiesUnitImpulse[at], n);
  }
  A_.noalias() = J_.transpose() * U_;
}

void CondensedSolver::AddLines(btMultiBodyConstraintArray& rows, Kind kind, int normals_at) {
  for (int i = 0; i < rows.size(); ++i) {
    btMultiBodySolverConstraint& row = rows[i];
    const bool of_joint = kind == Kind::kDirect;
    const bool rubs = of_joint && row.m_orgDofIndex == MotorRow::kDryFriction;
    const double last = rubs ? row.m_orgConstraint->getAppliedImpulse(row.m_orgDofIndex) : 0.0;
    Kind is = kind;
    if (of_joint && row.m_orgDofIndex == MotorRow::kStop) is = Kind::kBounded;
    if (rubs && !Holds(row, last)) is = Kind::kSliding;
    lines_.push_back(
        {&row, is, normals_at + row.m_frictionIndex, Target(row), Softness(row), Bounded(row, last), rubs});
  }
}

void CondensedSolver::WarmStart() {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    if (lines_[i].kind == Kind::kSliding) impulse_[static_cast<Eigen::Index>(i)] = lines_[i].last;
    if (lines_[i].kind != Kind::kNormal) continue;
    const auto* point = static_cast<const btManifoldPoint*>(lines_[i].row->m_originalContactPoint);
    impulse_[static_cast<Eigen::Index>(i)] = point->m_appliedImpulse;
  }
  for (std::size_t i = 0; i + 1 < lines_.size(); ++i) {
    if (lines_[i].kind != Kind::kFriction) continue;
    const auto* point = static_cast<const btManifoldPoint*>(lines_[i].row->m_originalContactPoint);
    impulse_[static_cast<Eigen::Index>(i)] = point->m_appliedImpulseLateral1;
    impulse_[static_cast<Eigen::Index>(i + 1)] = point->m_appliedImpulseLateral2;
    ++i;
  }
}

bool CondensedSolver::Condense() {
  const auto nd = static_cast<Eigen::Index>(direct_.size()), ni = static_cast<Eigen::Index>(iterated_.size());
  position_.assign(lines_.size(), -1);
  direct_position_.assign(lines_.size(), -1);
  b_direct_.resize(nd);
  b_small_.resize(ni);
  p_small_.resize(ni);
  softness_small_.resize(ni);
  ColumnsOf(direct_, direct_columns_);
  ColumnsOf(iterated_, iterated_columns_);
  if (nd > 0) A_direct_ = A_(direct_columns_, direct_columns_);
  for (Eigen::Index k = 0; k < nd; ++k) {
    const Eigen::Index i = direct_[static_cast<std::size_t>(k)];
    direct_position_[static_cast<std::size_t>(i)] = k;
    A_direct_(k, k) += lines_[static_cast<std::size_t>(i)].softness;
    b_direct_[k] = lines_[static_cast<std::size_t>(i)].b - BySliding(i);
  }
  for (Eigen::Index k = 0; k < ni; ++k) {
    const Eigen::Index i = iterated_[static_cast<std::size_t>(k)];
    position_[static_cast<std::size_t>(i)] = k;
    b_small_[k] = lines_[static_cast<std::size_t>(i)].b - BySliding(i);
    softness_small_[k] = lines_[static_cast<std::size_t>(i)].softness;
    p_small_[k] = impulse_[i];
  }
  if (ni > 0) A_small_ = A_(iterated_columns_, iterated_columns_);
  if (ni > 0 && nd > 0) coupling_ = A_(direct_columns_, iterated_columns_);
  AddSharedSoftness(A_direct_, coupling_, A_small_);
  if (nd > 0) {
    factor_.compute(A_direct_);
    if (factor_.info() != Eigen::Success) return false;
  }
  if (ni == 0) return true;
  if (nd > 0) {
    elimination_ = factor_.solve(coupling_);
    A_small_.noalias() -= coupling_.transpose() * elimination_;
    b_small_.noalias() -= elimination_.transpose() * b_direct_;
  }
  w_small_.noalias() = A_small_ * p_small_;
  return true;
}

void CondensedSolver::Iterate(int most) {
  const Eigen::Index ni = p_small_.size();
  for (int iteration = 0; iteration < most; ++iteration) {
    double change = 0.0;
    for (Eigen::Index k = 0; k < ni; ++k) {
      const bool friction =
          lines_[static_cast<std::size_t>(iterated_[static_cast<std::size_t>(k)])].kind == Kind::kFriction;
      change = std::max(change, friction ? SolveCone(k) : SolveLine(k));
      if (friction) ++k;
    }
    if (ni == 0 || change <= kSettled * p_small_.lpNorm<Eigen::Infinity>()) break;
  }
  for (Eigen::Index k = 0; k < ni; ++k) impulse_[iterated_[static_cast<std::size_t>(k)]] = p_small_[k];
  if (direct_.empty()) return;
  VectorX direct = b_direct_;
  if (ni > 0) direct.noalias() -= coupling_ * p_small_;
  factor_.solveInPlace(direct);
  for (std::size_t k = 0; k < direct_.size(); ++k) impulse_[direct_[k]] = direct[static_cast<Eigen::Index>(k)];
}

void CondensedSolver::ChangeImpulse(Eigen::Index k, double change) {
  p_small_[k] += change;
  w_small_ += change * A_small_.col(k);
}

double CondensedSolver::SolveLine(Eigen::Index k) {
  const Eigen::Index i = iterated_[static_cast<std::size_t>(k)];
  const btMultiBodySolverConstraint& row = *lines_[static_cast<std::size_t>(i)].row;
  const double s = softness_small_[k], now = p_small_[k];
  const Eigen::Index column = column_[static_cast<std::size_t>(i)];
  if (A_small_(k, k) + s <= kHeld * A_(column, column)) return 0.0;
  const double free = now + (b_small_[k] - w_small_[k] - s * now) / (A_small_(k, k) + s);
  const double change = std::clamp<double>(free, row.m_lowerLimit, row.m_upperLimit) - now;
  if (change != 0.0) ChangeImpulse(k, change);
  return std::abs(change);
}

double CondensedSolver::SolveCone(Eigen::Index k) {
  const Line& line = lines_[static_cast<std::size_t>(iterated_[static_cast<std::size_t>(k)])];
  const double radius = line.row->m_friction * p_small_[position_[static_cast<std::size_t>(line.normal)]];
  const Vector2 now = p_small_.segment<2>(k), s = softness_small_.segment<2>(k);
  Eigen::Matrix2d block = A_small_.block<2, 2>(k, k);
  block.diagonal() += s;
  const Vector2 residual = b_small_.segment<2>(k) - w_small_.segment<2>(k) - s.cwiseProduct(now);
  // A step by the larger eigenvalue keeps the projection onto the disc a descent; the exact step is taken inside it.
  Vector2 wanted = now + block.inverse() * residual;
  if (wanted.norm() > radius) {
    const double half = 0.5 * block.trace();
    const double largest = half + std::sqrt(std::max(0.0, half * half - block.determinant()));
    wanted = now + residual / largest;
    if (wanted.norm() > radius) wanted *= radius / wanted.norm();
  }
  const Vector2 change = wanted - now;
  if (change.x() != 0.0) ChangeImpulse(k, change.x());
  if (change.y() != 0.0) ChangeImpulse(k + 1, change.y());
  return change.lpNorm<Eigen::Infinity>();
}

bool CondensedSolver::TakeInStuck() {
  const auto stuck = std::stable_partition(iterated_.begin(), iterated_.end(), [&](Eigen::Index i) {
    const Line& line = lines_[static_cast<std::size_t>(i)];
    return !line.rubs || !Holds(*line.row, impulse_[i]);
  });
  if (stuck == iterated_.end()) return false;
  for (auto i = stuck; i != iterated_.end(); ++i) lines_[static_cast<std::size_t>(*i)].kind = Kind::kDirect;
  direct_.insert(direct_.end(), stuck, iterated_.end());
  iterated_.erase(stuck, iterated_.end());
  return true;
}

bool CondensedSolver::MoveTurned() {
  const auto turned = [&](Eigen::Index i) {
    double left = lines_[static_cast<std::size_t>(i)].b;  // of the velocity it is against; it pushes that way
    for (std::size_t k = 0; k < lines_.size(); ++k) {
      left -= A_(column_[static_cast<std::size_t>(i)], column_[k]) * impulse_[static_cast<Eigen::Index>(k)];
    }
    return left * impulse_[i] < 0.0;
  };
  const auto kept = std::stable_partition(sliding_.begin(), sliding_.end(), [&](Eigen::Index i) { return !turned(i); });
  if (kept == sliding_.end()) return false;
  for (auto moved = kept; moved != sliding_.end(); ++moved) {
    lines_[static_cast<std::size_t>(*moved)].kind = Kind::kBounded;
  }
  iterated_.insert(iterated_.begin(), kept, sliding_.end());
  sliding_.erase(kept, sliding_.end());
  return true;
}

double CondensedSolver::BySliding(Eigen::Index i) const {
  double velocity = 0.0;
  for (const Eigen::Index k : sliding_) {
    velocity += A_(column_[static_cast<std::size_t>(i)], column_[static_cast<std::size_t>(k)]) * impulse_[k];
  }
  return velocity;
}

void CondensedSolver::ColumnsOf(const std::vector<Eigen::Index>& lines, std::vector<Eigen::Index>& columns) const {
  columns.clear();
  for (const Eigen::Index i : lines) columns.push_back(column_[static_cast<std::size_t>(i)]);
}

bool CondensedSolver::MoveSaturated() {
  const auto beyond = [&](Eigen::Index i) {
    const Line& line = lines_[static_cast<std::size_t>(i)];
    const double own = OwnImpulse(line, impulse_[i]);
    return own < line.row->m_lowerLimit || own > line.row->m_upperLimit;
  };
  const auto kept = std::stable_partition(direct_.begin(), direct_.end(), [&](Eigen::Index i) { return !beyond(i); });
  if (kept == direct_.end()) return false;
  for (auto moved = kept; moved != direct_.end(); ++moved) {
    Line& line = lines_[static_cast<std::size_t>(*moved)];
    impulse_[*moved] = Bounded(*line.row, OwnImpulse(line, impulse_[*moved]));
    line.kind = Kind::kBounded;
  }
  // First, so that friction lines stay in pairs behind their normals.
  const auto first = iterated_.insert(iterated_.begin(), kept, direct_.end());
  const auto moved = direct_.end() - kept;
  direct_.erase(kept, direct_.end());
  for (auto i = first; i != first + moved; ++i) {
    if (Line& line = lines_[static_cast<std::size_t>(*i)]; line.loss >= 0) Part(line);
  }
  return true;
}

}  // namespace gaitwright::bullet
