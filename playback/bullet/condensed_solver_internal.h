// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>

#include <Eigen/Cholesky>
#include <vector>

#include "kinematics/spatial/pose.h"
#include "playback/bullet/contact_thinning_internal.h"

namespace gaitwright::bullet {

/// Solves the rows of one multibody on static ground: motors and gears directly, contacts and stops by projected
/// Gauss-Seidel on what is left.
///
/// With rows J, response U = M^-1 J^T, A = J U, softness s and impulses p, each row asks (A p + s p = b)_i within the
/// bounds of p_i. Motors and gears (D) are linear unless saturated, so they are eliminated:
///   (A_DD + s_D) p_D = b_D - A_DI p_I,   A'_II = A_II - A_ID (A_DD + s_D)^-1 A_DI,
/// and only contacts, stops and saturated motors (I) are iterated on, in the small dense A'. A motor that comes out
/// beyond its limit moves to I, and the step is solved again. Dry friction of a joint is in D where it held in the last
/// step; where it slid it is a known impulse, until the joint turns back: then it is in I, and taken into D once when
/// it comes to hold. Stiff motors cost no iterations, which projected Gauss-Seidel on all rows needs hundreds of.
/// Motors of a transmission have a softness in common beside their own, S_ij p_j in the row of motor i (SharedMotors),
/// which counts as part of A between their two rows. Friction is a cone: the two rows of a contact are projected
/// together. Iterations start from the contact's impulses of the last step and end at `solver_iterations` or a relative
/// change of 1e-9. Points that cannot matter get no rows, see ContactThinning.
class CondensedSolver : public btMultiBodyConstraintSolver {
 protected:
  btScalar solveGroupCacheFriendlySetup(btCollisionObject** bodies, int num_bodies, btPersistentManifold** manifolds,
                                        int num_manifolds, btTypedConstraint** constraints, int num_constraints,
                                        const btContactSolverInfo& info, btIDebugDraw* debug) override;
  btScalar solveGroupCacheFriendlyIterations(btCollisionObject** bodies, int num_bodies,
                                             btPersistentManifold** manifolds, int num_manifolds,
                                             btTypedConstraint** constraints, int num_constraints,
                                             const btContactSolverInfo& info, btIDebugDraw* debug) override;

 private:
  enum class Kind { kDirect, kBounded, kSliding, kNormal, kFriction };
  struct Line {
    btMultiBodySolverConstraint* row;
    Kind kind;
    int normal;  ///< of friction: the line of its normal
    double b, softness;
    double last = 0.0;       ///< of dry friction in a joint: impulse of the last step
    bool rubs = false;       ///< it is one
    Eigen::Index loss = -1;  ///< of a drive: line of the joint's loss, while both are solved as one
  };

  /// Softness that the drives of two motors of one transmission have in common, by their lines.
  struct SharedSoftness {
    Eigen::Index first, second;
    double softness;
  };

  btMultiBody* Gather();
  void GatherSharedSoftness();
  void AddSharedSoftness(MatrixX& of_direct, MatrixX& across, MatrixX& of_iterated) const;
  void GatherMatrices(Eigen::Index n);
  void AddLines(btMultiBodyConstraintArray& rows, Kind kind, int normals_at);
  void WarmStart();
  bool Condense();
  void Iterate(int most);
  double SolveLine(Eigen::Index k);
  double SolveCone(Eigen::Index k);
  void ChangeImpulse(Eigen::Index k, double change);
  /// A drive and the loss of its joint act on one velocity, so that their sum is as one softer row. Part undoes it.
  bool Join(std::size_t drive, std::size_t loss);
  void Part(Line& drive);
  /// What of a line's impulse is its row's own.
  double OwnImpulse(const Line& line, double impulse) const;
  /// Velocity along line i by the friction of joints that slide.
  double BySliding(Eigen::Index i) const;
  void ColumnsOf(const std::vector<Eigen::Index>& lines, std::vector<Eigen::Index>& columns) const;
  bool MoveTurned();
  bool TakeInStuck();
  bool MoveSaturated();

  ContactThinning thinning_;
  std::vector<Line> lines_;
  std::vector<Eigen::Index> direct_, iterated_, sliding_;  ///< lines
  std::vector<Eigen::Index> direct_columns_, iterated_columns_;
  std::vector<SharedSoftness> shared_softness_;
  std::vector<Eigen::Index> position_;         ///< by line: place in iterated_
  std::vector<Eigen::Index> direct_position_;  ///< by line: place in direct_
  std::vector<Eigen::Index> column_;           ///< by line: of J; lines of one joint share theirs
  MatrixX J_, U_, A_;                          ///< by column; A by column and column
  MatrixX A_direct_, coupling_, elimination_;  ///< A_DD + s, A_DI, its solution
  MatrixX A_small_;                            ///< A' by place
  VectorX b_direct_, b_small_, p_small_, w_small_, softness_small_, impulse_, impulse_by_column_;
  Eigen::LLT<MatrixX> factor_;
};

}  // namespace gaitwright::bullet
