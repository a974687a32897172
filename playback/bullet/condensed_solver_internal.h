// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>

#include <Eigen/Cholesky>
#include <vector>

#include "kinematics/spatial/pose.h"
#include "playback/bullet/contact_rows_internal.h"
#include "playback/bullet/contact_thinning_internal.h"
#include "playback/bullet/joint_space_inertia_internal.h"

namespace gaitwright::bullet {

/// Solves the rows of one multibody on static ground: motors and gears directly, contacts and stops by projected
/// Gauss-Seidel on what is left.
///
/// With M the mass matrix, rows J, softness s and impulses p, the change x of the velocities is M x = J^T p, and each
/// row asks J x + s p = b within the bounds of p. Motors and gears are linear unless saturated, so they are eliminated:
///   a row on one joint's rate, J = c, s > 0   p = (b - c x) / s, so that M gets c^2 / s on its diagonal and the
///                                             right-hand side c b / s: M keeps the zeros of the robot's tree
///   a row on one joint's rate, s = 0          x = b / c is known, the joint is taken out of M, p is what holds it
///   other rows (D), as gears and twins        (A_DD + s_D) p_D = b_D - A_DI p_I, with A = J M^-1 J^T of that M
/// Motors of a transmission are in D, and have a softness in common beside their own: S_ij p_j in the row of motor i
/// (SharedMotors), which counts as part of A between their two rows.
/// Only contacts, stops and saturated motors (I) are iterated on, in the small dense
///   A'_II = A_II - A_ID (A_DD + s_D)^-1 A_DI.
/// A motor that comes out beyond its limit moves to I, and the step is solved again. Dry friction of a joint is in D
/// where it held in the last step; where it slid it is a known impulse, until the joint turns back: then it is in I,
/// and taken into D once when it comes to hold. Stiff motors cost no iterations, which projected Gauss-Seidel on all
/// rows needs hundreds of. Friction is a cone: the two rows of a contact are projected together. Iterations start from
/// the contact's impulses of the last step and end at `solver_iterations` or a relative change of 1e-9. Points that
/// cannot matter get no rows, see ContactThinning.
class CondensedSolver : public btMultiBodyConstraintSolver {
 public:
  /// @param inertia  of the one multibody, which must outlive this.
  explicit CondensedSolver(JointSpaceInertia& inertia);

 protected:
  btScalar solveGroupCacheFriendlySetup(btCollisionObject** bodies, int num_bodies, btPersistentManifold** manifolds,
                                        int num_manifolds, btTypedConstraint** constraints, int num_constraints,
                                        const btContactSolverInfo& info, btIDebugDraw* debug) override;
  void convertContacts(btPersistentManifold** manifolds, int num_manifolds, const btContactSolverInfo& info) override;
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
    double last = 0.0;         ///< of dry friction in a joint: impulse of the last step
    bool rubs = false;         ///< it is one
    int coordinate = -1;       ///< the only one in J, or -1
    double share = 0.0;        ///< J there
    int last_coordinate = -1;  ///< on whose path J is, or -1
    bool is_soft = false;      ///< direct: in the diagonal of M
    bool holds = false;        ///< direct: its coordinate is taken out of M
    bool is_coupled = false;   ///< a line of shared_softness_
  };
  /// A line on which iterations go.
  struct Place {
    bool is_cone;     ///< the first of the two lines of a contact's friction
    bool is_held;     ///< its velocity is others', as that of a joint at its stop is dry friction's
    double softness;  ///< of the line
    double lowest, highest;
    double inverse_diagonal;  ///< of A' + softness
    double friction;
    Eigen::Index normal;  ///< of a cone: place of its normal
    Eigen::Matrix2d inverse;
    double largest;  ///< eigenvalue of the cone's block
  };

  SolverRows Rows();
  /// Softness that the drives of two motors of one transmission have in common, by their lines.
  struct SharedSoftness {
    Eigen::Index first, second;
    double softness;
  };

  bool Gather();
  void GatherSharedSoftness();
  void AddLines(btMultiBodyConstraintArray& rows, Kind kind, int normals_at);
  void WarmStart();
  /// @return whether the direct lines can be held, all of them.
  bool Condense();
  /// Takes direct lines on one coordinate into M, and what sliding lines give into the right-hand side.
  void Fold();
  void TakeOutHeld();
  bool Eliminate();
  /// Adds shared softness between two sets of lines, which may be the same. @param places  of lines in either, or -1.
  void AddSharedSoftness(const std::vector<Eigen::Index>& row_places, const std::vector<Eigen::Index>& column_places,
                         MatrixX& matrix) const;
  void FillHalves(const std::vector<Eigen::Index>& lines, MatrixX& halves, VectorX& b);
  void FillHalfAlong(const Line& line, Eigen::Ref<VectorX> half, double& b);
  void FillPositions();
  void FillPlaces();
  void Iterate(int most);
  /// Velocities and the impulses of direct lines, from those of the others.
  void Recover();
  void RecoverHolding();
  double SolveLine(Eigen::Index k);
  double SolveCone(Eigen::Index k);
  bool MoveTurned();
  bool TakeInStuck();
  bool MoveSaturated();
  Eigen::Map<const VectorX> JacobianOf(const Line& line) const;
  void AddForce(const Line& line, double impulse, VectorX& force) const;
  double Along(const Line& line, const VectorX& velocity) const;

  JointSpaceInertia& inertia_;
  ContactThinning thinning_;
  std::vector<Line> lines_;
  std::vector<Eigen::Index> direct_, iterated_, sliding_;  ///< lines
  std::vector<Eigen::Index> dense_;                        ///< those of direct_ that are in A_DD
  std::vector<Eigen::Index> position_;                     ///< by line: place in iterated_, or -1
  std::vector<Eigen::Index> dense_position_;               ///< by line: place in dense_, or -1
  std::vector<SharedSoftness> shared_softness_;
  std::vector<Place> places_;

  std::vector<double> M_;  ///< with soft lines and without held coordinates
  TreeFactor factor_;      ///< of it
  VectorX force_;          ///< of soft and sliding lines, without their part by velocity
  VectorX free_;           ///< half of the change of velocity that it makes: L^-T force_
  std::vector<char> is_held_;
  bool any_held_ = false;
  VectorX held_velocity_, scratch_;

  MatrixX halves_, halves_direct_;             ///< L^-T J^T by place, by place in dense_
  MatrixX A_direct_, coupling_, elimination_;  ///< A_DD + s, A_DI, its solution
  MatrixX A_small_;                            ///< A' by place
  VectorX b_direct_, b_small_, p_direct_, p_small_, w_small_, impulse_, velocity_;
  Eigen::LLT<MatrixX> dense_factor_;
};

}  // namespace gaitwright::bullet
