// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <utility>

#include "playback/bullet/condensed_solver_internal.h"
#include "playback/bullet/joint_rows_internal.h"
#include "playback/bullet/shared_motors_internal.h"

namespace gaitwright::bullet {
namespace {

bool Holds(const btMultiBodySolverConstraint& row, double impulse) {
  return impulse > row.m_lowerLimit && impulse < row.m_upperLimit;
}

double Bounded(const btMultiBodySolverConstraint& row, double impulse) {
  return std::clamp<double>(impulse, row.m_lowerLimit, row.m_upperLimit);
}

}  // namespace

CondensedSolver::CondensedSolver(JointSpaceInertia& inertia) : inertia_(inertia), factor_(inertia.tree()) {}

btScalar CondensedSolver::solveGroupCacheFriendlySetup(btCollisionObject** bodies, int num_bodies,
                                                       btPersistentManifold** manifolds, int num_manifolds,
                                                       btTypedConstraint** constraints, int num_constraints,
                                                       const btContactSolverInfo& info, btIDebugDraw* debug) {
  thinning_.Thin(manifolds, num_manifolds, info.m_timeStep);
  return btMultiBodyConstraintSolver::solveGroupCacheFriendlySetup(bodies, num_bodies, manifolds, num_manifolds,
                                                                   constraints, num_constraints, info, debug);
}

void CondensedSolver::convertContacts(btPersistentManifold** manifolds, int num_manifolds,
                                      const btContactSolverInfo& info) {
  inertia_.Update();
  for (int i = 0; i < num_manifolds; ++i) {
    AddContactRows(*manifolds[i], inertia_, info, Rows());
  }
  for (int i = 0; i < m_tmpNumMultiBodyConstraints; ++i) {
    m_tmpMultiBodyConstraints[i]->createConstraintRows(m_multiBodyNonContactConstraints, m_data, info);
  }
}

btScalar CondensedSolver::solveGroupCacheFriendlyIterations(btCollisionObject** bodies, int num_bodies,
                                                            btPersistentManifold** manifolds, int num_manifolds,
                                                            btTypedConstraint** constraints, int num_constraints,
                                                            const btContactSolverInfo& info, btIDebugDraw* debug) {
  if (!Gather()) return 0.0;
  WarmStart();
  bool taken_in = false;
  do {
    if (!Condense()) {  // gears contradict each other: projected Gauss-Seidel finds a compromise
      NormaliseRows(inertia_, Rows());
      return btMultiBodyConstraintSolver::solveGroupCacheFriendlyIterations(
          bodies, num_bodies, manifolds, num_manifolds, constraints, num_constraints, info, debug);
    }
    Iterate(info.m_numIterations);
    Recover();
  } while (MoveTurned() || (!std::exchange(taken_in, true) && TakeInStuck()) || MoveSaturated());
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    lines_[i].row->m_appliedImpulse = impulse_[static_cast<Eigen::Index>(i)];
  }
  btMultiBody& body = *lines_.front().row->m_multiBodyA;
  body.applyDeltaVeeMultiDof2(velocity_.data(), 1.0);
  body.setPosUpdated(false);
  return 0.0;
}

Eigen::Map<const VectorX> CondensedSolver::JacobianOf(const Line& line) const {
  return Eigen::Map<const VectorX>(&m_data.m_jacobians[line.row->m_jacAindex], inertia_.size());
}

void CondensedSolver::AddForce(const Line& line, double impulse, VectorX& force) const {
  if (line.coordinate >= 0) {
    force[line.coordinate] += line.share * impulse;
  } else {
    force += impulse * JacobianOf(line);
  }
}

double CondensedSolver::Along(const Line& line, const VectorX& velocity) const {
  return line.coordinate >= 0 ? line.share * velocity[line.coordinate] : JacobianOf(line).dot(velocity);
}

SolverRows CondensedSolver::Rows() {
  return {m_multiBodyNonContactConstraints, m_multiBodyNormalContactConstraints, m_multiBodyFrictionContactConstraints,
          m_data};
}

bool CondensedSolver::Gather() {
  lines_.clear();
  direct_.clear();
  iterated_.clear();
  sliding_.clear();
  AddLines(m_multiBodyNonContactConstraints, Kind::kDirect, 0);
  const int normals_at = static_cast<int>(lines_.size());
  AddLines(m_multiBodyNormalContactConstraints, Kind::kNormal, 0);
  AddLines(m_multiBodyFrictionContactConstraints, Kind::kFriction, normals_at);
  impulse_.setZero(static_cast<Eigen::Index>(lines_.size()));
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const Kind kind = lines_[i].kind;
    auto& set = kind == Kind::kDirect ? direct_ : kind == Kind::kSliding ? sliding_ : iterated_;
    set.push_back(static_cast<Eigen::Index>(i));
  }
  GatherSharedSoftness();
  return !lines_.empty();
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
      lines_[i].is_coupled = lines_[j].is_coupled = true;
      shared_softness_.push_back({static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j),
                                  first->motors().SofteningOf(first->index(), second->index())});
    }
  }
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
    lines_.push_back({&row, is, normals_at + row.m_frictionIndex, row.m_rhs, row.m_cfm, Bounded(row, last), rubs});
    lines_.back().last_coordinate = inertia_.last_coordinate(row.m_linkA);
    if (!of_joint) continue;
    const auto& terms = static_cast<const JointSpaceConstraint*>(row.m_orgConstraint)->terms();
    const bool is_one = terms.size() == 1;
    lines_.back().coordinate = lines_.back().last_coordinate = is_one ? terms.front().coordinate : -1;
    if (is_one) lines_.back().share = terms.front().share;
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
    const Line& line = lines_[static_cast<std::size_t>(i)];
    const double left = line.b - Along(line, velocity_);  // the impulse pushes in the direction of its sign
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

bool CondensedSolver::MoveSaturated() {
  const auto beyond = [&](Eigen::Index i) {
    const Line& line = lines_[static_cast<std::size_t>(i)];
    return impulse_[i] < line.row->m_lowerLimit || impulse_[i] > line.row->m_upperLimit;
  };
  const auto kept = std::stable_partition(direct_.begin(), direct_.end(), [&](Eigen::Index i) { return !beyond(i); });
  if (kept == direct_.end()) return false;
  for (auto moved = kept; moved != direct_.end(); ++moved) {
    Line& line = lines_[static_cast<std::size_t>(*moved)];
    impulse_[*moved] = Bounded(*line.row, impulse_[*moved]);
    line.kind = Kind::kBounded;
    line.is_soft = line.holds = false;
  }
  // Kept rows go first, so that friction rows stay in pairs after their normals.
  iterated_.insert(iterated_.begin(), kept, direct_.end());
  direct_.erase(kept, direct_.end());
  return true;
}

}  // namespace gaitwright::bullet
