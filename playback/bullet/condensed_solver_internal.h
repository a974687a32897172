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

/// Solves the rows of one multibody on static ground. Motors and gears are solved directly; contacts and stops are then
/// solved by projected Gauss-Seidel.
///
/// With M the mass matrix, J the rows, s the softness and p the impulses, the change x of the velocities is
/// M x = J^T p, and each row requires J x + s p = b within the bounds of p. Motors and gears are linear unless
/// saturated, so they are eliminated:
///   a row on one joint's rate, J = c, s > 0   p = (b - c x) / s: adds c^2 / s to the diagonal of M and c b / s to the
///                                             right-hand side; M keeps the zeros of the robot's tree
///   a row on one joint's rate, s = 0          x = b / c is known; the joint is removed from M, and p holds it
///   other rows (D), such as gears and twins   (A_DD + s_D) p_D = b_D - A_DI p_I, with A = J M^-1 J^T of this M
/// Motors of a transmission are in D. In addition to its own softness, the row of motor i has a shared softness
/// S_ij p_j (SharedMotors), which counts as part of A between the two rows.
/// Only contacts, stops and saturated motors (I) need iterations, in the small dense matrix
///   A'_II = A_II - A_ID (A_DD + s_D)^-1 A_DI.
/// A motor whose impulse exceeds its limit moves to I, and the step is solved again. Dry friction of a joint is in D if
/// it held the joint in the last step. If the joint slid, friction is a known impulse until the joint reverses; then it
/// is in I, and moves to D once when it holds the joint. Stiff motors need no iterations, whereas projected
/// Gauss-Seidel on all rows needs hundreds. Friction is a cone: the two rows of a contact are projected together.
/// Iterations start from the contact impulses of the last step and end after `solver_iterations` or at a relative
/// change of 1e-9. Contact points that cannot matter get no rows (ContactThinning).
class CondensedSolver : public btMultiBodyConstraintSolver {
 public:
  /// @param inertia  of the one multibody; must outlive this object.
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
    int normal;  ///< of friction: row of its normal
    double b, softness;
    double last = 0.0;         ///< of dry friction in a joint: its impulse in the last step
    bool rubs = false;         ///< the row is dry friction
    int coordinate = -1;       ///< the only coordinate in J, or -1
    double share = 0.0;        ///< J at this coordinate
    int last_coordinate = -1;  ///< last coordinate of the path that J is on, or -1
    bool is_soft = false;      ///< direct: in the diagonal of M
    bool holds = false;        ///< direct: its coordinate is taken out of M
    bool is_coupled = false;   ///< a line of shared_softness_
  };
  /// A row that is iterated on.
  struct Place {
    bool is_cone;     ///< first of the two rows of a contact's friction
    bool is_held;     ///< other rows hold its velocity, as dry friction does for a joint at its stop
    double softness;  ///< of the row
    double lowest, highest;
    double inverse_diagonal;  ///< of A' + softness
    double friction;
    Eigen::Index normal;  ///< of a cone: place of its normal
    Eigen::Matrix2d inverse;
    double largest;  ///< eigenvalue of the cone's block
  };

  SolverRows Rows();
  /// Softness that two motors of one transmission share, by their rows.
  struct SharedSoftness {
    Eigen::Index first, second;
    double softness;
  };

  bool Gather();
  void GatherSharedSoftness();
  void AddLines(btMultiBodyConstraintArray& rows, Kind kind, int normals_at);
  void WarmStart();
  /// @return whether all direct rows can be held.
  bool Condense();
  /// Adds direct rows on one coordinate to M, and the impulses of sliding rows to the right-hand side.
  void Fold();
  void TakeOutHeld();
  bool Eliminate();
  /// Adds the shared softness between two sets of rows, which may be equal. @param places  of rows in each set, or -1.
  void AddSharedSoftness(const std::vector<Eigen::Index>& row_places, const std::vector<Eigen::Index>& column_places,
                         MatrixX& matrix) const;
  void FillHalves(const std::vector<Eigen::Index>& lines, MatrixX& halves, VectorX& b);
  void FillHalfAlong(const Line& line, Eigen::Ref<VectorX> half, double& b);
  void FillPositions();
  void FillPlaces();
  void Iterate(int most);
  /// Computes the velocities and the impulses of the direct rows from those of the other rows.
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
  std::vector<Eigen::Index> direct_, iterated_, sliding_;  ///< rows
  std::vector<Eigen::Index> dense_;                        ///< the rows of direct_ that are in A_DD
  std::vector<Eigen::Index> position_;                     ///< by row: place in iterated_, or -1
  std::vector<Eigen::Index> dense_position_;               ///< by row: place in dense_, or -1
  std::vector<SharedSoftness> shared_softness_;
  std::vector<Place> places_;

  std::vector<double> M_;  ///< mass matrix with soft rows, without held coordinates
  TreeFactor factor_;      ///< of M_
  VectorX force_;          ///< of soft and sliding rows, without the part that depends on velocity
  VectorX free_;           ///< half of the velocity change due to force_: L^-T force_
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
