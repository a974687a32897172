// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/robot_model.h"
#include "kinematics/spatial/pose.h"

namespace gaitwright {

class SquareSolver;

/// Desired motion of a foot at one time. The controlled frame is F of Foot: the middle of a sole, the centre of a
/// sphere.
///
/// A sphere rolls on its radius r: with normal n its centre moves by r w x n more than the material point under it, so
/// v_WF and a_WF are those of the material contact point (zero in stance, the swing's otherwise), and the position
/// wanted is p_WF + r log(R R_anchor^T) x n_anchor, R being the foot's rotation, R_anchor that at which p_WF was
/// reckoned, and n_anchor the mean normal since. Between grounds that slope differently the normal turns over.
struct FootTarget {
  Vector3 p_WF = Vector3::Zero();
  Matrix3 R_WF = Matrix3::Identity();          ///< sole, line
  Matrix3 R_anchor = Matrix3::Identity();      ///< sphere
  Vector3 normal_anchor_W = Vector3::UnitZ();  ///< sphere
  Vector3 normal_W = Vector3::UnitZ(), normal_rate_W = Vector3::Zero();
  Vector3 v_WF = Vector3::Zero(), w_WF = Vector3::Zero();
  Vector3 a_WF = Vector3::Zero(), alpha_WF = Vector3::Zero();
};

/// Where joints that no task takes shall be: those outside the legs, and in legs with freedoms to spare.
struct PostureTarget {
  VectorX q, v, a;  ///< of all independent joints, size n; all empty to use the initial guess, at rest
};

/// What the whole body shall do at one time.
struct BodyTarget {
  Vector3 p_WC = Vector3::Zero(), v_WC = Vector3::Zero(), a_WC = Vector3::Zero();
  Matrix3 R_WB = Matrix3::Identity();
  Vector3 w_WB = Vector3::Zero(), alpha_WB = Vector3::Zero();
  std::vector<FootTarget> feet;  ///< by foot of a leg
  PostureTarget posture;
};

/// Joint motion from the motion of centre of mass, base orientation and feet, for one model.
///
/// The tasks are rows in a fixed order: feet, centre of mass, base roll and pitch, base yaw. Rows are used from the
/// top while they are independent of those above and degrees of freedom are left; the rest is dropped (NAO has 17
/// degrees of freedom for 18 rows: its yaw follows from the coupled hip). Rows lie along the axes of the base's
/// heading, those of a foot's rotation along the axes of its F, so the dropped rows do not depend on the robot's
/// heading. Remaining degrees of freedom are held at the target's posture: joints outside the legs first, then those
/// that carry several legs. So the system is square: positions are solved to 1e-10, velocities and accelerations are
/// its exact derivatives. It allocates nothing after construction, except for failures.
///
/// Tuning: "does not converge" means a target out of reach: the failure names the foot that is farthest from its
/// target.
class WholeBodyIk {
 public:
  explicit WholeBodyIk(const RobotModel& model);
  ~WholeBodyIk();

  /// Moves q (the first guess; size nq) onto the target; joints that are held go to the target's posture, or stay where
  /// they are. @return the iterations taken. Failure kInfeasible names the
  /// foot and the distance left.
  Result<int> SolvePosition(const BodyTarget& target, VectorX& q);

  /// v and a at q for the target; SolvePosition first. The sizes are nv.
  void SolveRates(const BodyTarget& target, const VectorX& q, VectorX& v, VectorX& a);

  /// Where a foot's controlled frame and rotation are after SolvePosition.
  Pose FootPose(int foot) const;

  /// Rows that yielded and joints that are held, for people.
  const std::vector<std::string>& notes() const { return notes_; }
  const DynamicsScratch& scratch() const { return scratch_; }

 private:
  /// Three rows along three axes: a foot's position or rotation, the centre of mass or the base's rotation.
  struct Task {
    enum class Kind { kFootLinear, kFootAngular, kCentreOfMass, kBaseRotation } kind;
    int foot;                           // -1 for the whole body's
    Matrix3 axes_W;                     // columns, for the present target
    Vector3 value_W = Vector3::Zero();  // of the present right-hand side
  };
  struct Row {
    std::size_t task;
    int axis;
    std::string name;
  };

  void ListRows();
  void ChooseRows();
  void SetAxes(const BodyTarget& target);
  void UpdateJacobians(const BodyTarget& target);
  void AssembleSystem();
  Eigen::RowVectorXd RowJacobian(const Row& row) const;
  double Coefficient(const Row& row, int column) const;
  void FillRightHandSide();                      // from the tasks' values
  void TakeOutHeld(const VectorX& joint_rates);  // what held joints do of it
  Vector3 Error(const Task& task, const BodyTarget& target) const;
  Vector3 Rate(const Task& task, const BodyTarget& target) const;
  Vector3 AccelerationLessBias(const Task& task, const BodyTarget& target) const;
  Failure OutOfReach(const BodyTarget& target) const;

  const RobotModel* model_;
  DynamicsScratch scratch_;
  std::vector<Task> tasks_;
  std::vector<Row> rows_;     // chosen
  std::vector<int> columns_;  // free velocity coordinates
  std::vector<int> held_;     // independent joints that are not among them
  std::vector<MatrixX> foot_jacobians_;
  MatrixX com_jacobian_;
  VectorX rhs_, solution_, step_;
  std::unique_ptr<SquareSolver> system_;
  std::vector<std::string> notes_;
};

}  // namespace gaitwright
