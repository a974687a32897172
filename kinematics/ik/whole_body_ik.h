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
/// A sphere with radius r rolls. With normal n, its centre moves by r w x n relative to the material point at the
/// contact. So v_WF and a_WF are those of the material contact point: zero in stance, otherwise those of the swing. The
/// desired position is p_WF + r log(R R_anchor^T) x n_anchor, where R is the rotation of the foot, R_anchor its
/// rotation at which p_WF was computed, and n_anchor the mean normal since then. The normal rotates between grounds
/// with different slopes.
struct FootTarget {
  Vector3 p_WF = Vector3::Zero();
  Matrix3 R_WF = Matrix3::Identity();          ///< sole, line
  Matrix3 R_anchor = Matrix3::Identity();      ///< sphere
  Vector3 normal_anchor_W = Vector3::UnitZ();  ///< sphere
  Vector3 normal_W = Vector3::UnitZ(), normal_rate_W = Vector3::Zero();
  Vector3 v_WF = Vector3::Zero(), w_WF = Vector3::Zero();
  Vector3 a_WF = Vector3::Zero(), alpha_WF = Vector3::Zero();
};

/// Desired motion of joints that no task uses: joints outside the legs, and redundant joints of legs.
struct PostureTarget {
  VectorX q, v, a;  ///< all independent joints, size n; all empty to use the initial guess, at rest
};

/// Desired motion of the whole body at one time.
struct BodyTarget {
  Vector3 p_WC = Vector3::Zero(), v_WC = Vector3::Zero(), a_WC = Vector3::Zero();
  Matrix3 R_WB = Matrix3::Identity();
  Vector3 w_WB = Vector3::Zero(), alpha_WB = Vector3::Zero();
  std::vector<FootTarget> feet;  ///< by foot of a leg
  PostureTarget posture;
};

/// Joint motion from the motion of centre of mass, base orientation and feet, for one model.
///
/// The tasks are rows in a fixed order: feet, centre of mass, base roll and pitch, base yaw. A row is used if it is
/// independent of the rows above it and degrees of freedom are left. Other rows are dropped (NAO has 17 degrees of
/// freedom for 18 rows, and its yaw follows from the coupled hip). Rows are along the axes of the base's heading, and
/// for the rotation of a foot along the axes of F, so the dropped rows do not depend on the robot's heading. Remaining
/// degrees of freedom are held at the posture of the target: joints outside the legs first, then joints that carry
/// several legs. So the system is square: positions are solved to 1e-10, and velocities and accelerations are exact
/// derivatives. After construction, memory is only allocated for failures.
///
/// Tuning: if it does not converge, a target is out of reach; the failure names the foot that is farthest from its
/// target.
class WholeBodyIk {
 public:
  explicit WholeBodyIk(const RobotModel& model);
  ~WholeBodyIk();

  /// Changes q (the initial guess; size nq) to reach the target. Held joints go to the posture of the target, or keep
  /// their positions if it is empty. @return the number of iterations. Failure kInfeasible with the foot and its
  /// remaining distance.
  Result<int> SolvePosition(const BodyTarget& target, VectorX& q);

  /// Computes v and a (size nv) at q for the target. Call SolvePosition first.
  void SolveRates(const BodyTarget& target, const VectorX& q, VectorX& v, VectorX& a);

  /// Pose of a foot's controlled frame after SolvePosition.
  Pose FootPose(int foot) const;

  /// Notes about dropped rows and held joints, for the user.
  const std::vector<std::string>& notes() const { return notes_; }
  const DynamicsScratch& scratch() const { return scratch_; }

 private:
  /// Three rows along three axes: a foot's position or rotation, the centre of mass or the base's rotation.
  struct Task {
    enum class Kind { kFootLinear, kFootAngular, kCentreOfMass, kBaseRotation } kind;
    int foot;                           // -1 for a task of the whole body
    Matrix3 axes_W;                     // columns, for the current target
    Vector3 value_W = Vector3::Zero();  // current right-hand side
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
  void FillRightHandSide();                      // from the values of the tasks
  void TakeOutHeld(const VectorX& joint_rates);  // subtracts the effect of held joints
  Vector3 Error(const Task& task, const BodyTarget& target) const;
  Vector3 Rate(const Task& task, const BodyTarget& target) const;
  Vector3 AccelerationLessBias(const Task& task, const BodyTarget& target) const;
  Failure OutOfReach(const BodyTarget& target) const;

  const RobotModel* model_;
  DynamicsScratch scratch_;
  std::vector<Task> tasks_;
  std::vector<Row> rows_;     // rows that are used
  std::vector<int> columns_;  // free velocity coordinates
  std::vector<int> held_;     // independent joints that are held
  std::vector<MatrixX> foot_jacobians_;
  MatrixX com_jacobian_;
  VectorX rhs_, solution_, step_;
  std::unique_ptr<SquareSolver> system_;
  std::vector<std::string> notes_;
};

}  // namespace gaitwright
