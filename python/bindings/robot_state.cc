// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <optional>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/dynamics_derivatives.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/dynamics/forward_dynamics.h"
#include "kinematics/ik/leg_ik.h"
#include "kinematics/model/check_state.h"
#include "python/bindings/arrays.h"
#include "python/bindings/bindings.h"
#include "python/bindings/errors.h"
#include "python/bindings/robot.h"

namespace gaitwright::python {
namespace {

namespace py = pybind11;

void CheckSize(const char* name, const VectorX& vector, Eigen::Index size) {
  if (vector.size() != size)
    throw InvalidArgument(fmt::format("{} has {} numbers; {} are needed", name, vector.size(), size));
  if (!vector.allFinite()) throw InvalidArgument(fmt::format("{} contains a value that is not finite", name));
}

/// A robot in a state, with its kinematics and dynamics.
class RobotState {
 public:
  RobotState(SharedRobot robot, const std::optional<VectorX>& q, const std::optional<VectorX>& v)
      : robot_(std::move(robot)), scratch_(*robot_) {
    Set(q ? *q : StandingConfiguration(*robot_), v);
  }

  void Set(const VectorX& q, const std::optional<VectorX>& v) {
    const VectorX rates = v ? *v : VectorX(VectorX::Zero(robot_->nv()));
    CheckState(*robot_, q, rates);
    q_ = q;
    v_ = rates;
    ForwardVelocities(*robot_, q_, v_, scratch_);
  }

  const SharedRobot& robot() const { return robot_; }
  const VectorX& q() const { return q_; }
  const VectorX& v() const { return v_; }

  Eigen::Matrix4d PoseOf(const std::string& link) const {
    const Frame& frame = FrameOf(link);
    return FramePose(scratch_, frame.body, frame.X_BF).matrix();
  }
  MatrixX JacobianOf(const std::string& link, const Vector3& point) const {
    const Frame& frame = FrameOf(link);
    MatrixX J(6, robot_->nv());
    PointJacobian(*robot_, scratch_, frame.body, frame.X_BF * point, J);
    return J;
  }
  Vector6 VelocityOf(const std::string& link, const Vector3& point) const {
    const Frame& frame = FrameOf(link);
    return PointVelocity(scratch_, frame.body, frame.X_BF * point);
  }
  Vector6 BiasOf(const std::string& link, const Vector3& point) const {
    const Frame& frame = FrameOf(link);
    return PointBiasAcceleration(scratch_, frame.body, frame.X_BF * point);
  }
  Eigen::Matrix4d ContactOf(const std::string& foot) const {
    return ContactFrame(*robot_, scratch_, FootIndex(*robot_, foot)).matrix();
  }
  RowMatrix ContactPointsOf(const std::string& foot) const {
    return Rows(ContactPoints(*robot_, scratch_, FootIndex(*robot_, foot)));
  }

  Vector3 Centre() const { return CentreOfMass(*robot_, scratch_); }
  Vector6 Momentum() const { return CentroidalMomentum(*robot_, scratch_); }
  double Energy() const { return MechanicalEnergy(*robot_, scratch_); }
  MatrixX CentreJacobian() {
    MatrixX J(3, robot_->nv());
    CentreOfMassJacobian(*robot_, scratch_, J);
    return J;
  }
  // The following functions compute the kinematics again, in a separate workspace.
  MatrixX Mass() const {
    DynamicsScratch work(*robot_);
    MatrixX M(robot_->nv(), robot_->nv());
    MassMatrix(*robot_, q_, work, M);
    return M;
  }
  VectorX Forces(const std::optional<VectorX>& a) const {
    const VectorX accelerations = a ? *a : VectorX(VectorX::Zero(robot_->nv()));
    CheckSize("a", accelerations, robot_->nv());
    DynamicsScratch work(*robot_);
    VectorX tau(robot_->nv());
    InverseDynamics(*robot_, q_, v_, accelerations, work, tau);
    return tau;
  }

  VectorX Accelerations(const VectorX& tau, const std::optional<VectorX>& rotor_inertia) const {
    CheckSize("tau", tau, robot_->nv());
    const VectorX rotors = rotor_inertia ? *rotor_inertia : VectorX();
    if (rotor_inertia) CheckSize("rotor_inertia", rotors, robot_->num_dofs());
    VectorX a;
    ForwardDynamics(*robot_).Compute(q_, v_, tau, a, rotors);
    return a;
  }
  py::tuple Derivatives(const std::optional<VectorX>& a) const {
    const VectorX accelerations = a ? *a : VectorX(VectorX::Zero(robot_->nv()));
    CheckSize("a", accelerations, robot_->nv());
    InverseDynamicsDerivatives result;
    DynamicsDerivatives(*robot_).Compute(q_, v_, accelerations, result);
    return py::make_tuple(result.by_q, result.by_v, result.M);
  }

 private:
  const Frame& FrameOf(const std::string& link) const {
    return robot_->frames[static_cast<std::size_t>(robot_->FrameIndex(link))];
  }

  SharedRobot robot_;
  DynamicsScratch scratch_;
  VectorX q_, v_;
};

VectorX SolveLeg(const SharedRobot& robot, const std::string& foot, const Eigen::Matrix4d& X_BF,
                 const std::optional<VectorX>& guess) {
  const LegIk ik(*robot, FootIndex(*robot, foot));
  const Pose target(X_BF);
  return Value(guess ? ik.Solve(target, *guess) : ik.Solve(target)).joints;
}

std::vector<std::string> LegJoints(const SharedRobot& robot, const std::string& foot) {
  std::vector<std::string> names;
  const LegIk ik(*robot, FootIndex(*robot, foot));
  for (const int dof : ik.dofs()) names.push_back(robot->dof_names[static_cast<std::size_t>(dof)]);
  return names;
}

}  // namespace

void BindRobotState(py::module_& module) {
  const py::arg_v no_point("point", Vector3(Vector3::Zero()), "(0, 0, 0)");
  py::class_<RobotState>(module, "RobotState", R"(Kinematics and dynamics of a robot in a state.

Everything is in world axes. A point is given in the axes of its link [m]; spatial vectors are linear, then angular.)")
      .def(py::init<SharedRobot, const std::optional<VectorX>&, const std::optional<VectorX>&>(),
           py::arg("robot").none(false), py::arg("q") = py::none(), py::arg("v") = py::none(),
           "Default of q: the nominal posture; default of v: at rest.")
      .def("set", &RobotState::Set, py::arg("q"), py::arg("v") = py::none(),
           "Sets another state; default of v: at rest.")
      .def_property_readonly("robot", &RobotState::robot)
      .def_property_readonly("q", [](const RobotState& s) { return VectorX(s.q()); })
      .def_property_readonly("v", [](const RobotState& s) { return VectorX(s.v()); })
      .def("pose", &RobotState::PoseOf, py::arg("link"), "Pose of a link in the world, 4 x 4.")
      .def("jacobian", &RobotState::JacobianOf, py::arg("link"), no_point,
           "Jacobian of a point fixed in a link, 6 x nv: [velocity; angular velocity] = J v.")
      .def("velocity", &RobotState::VelocityOf, py::arg("link"), no_point,
           "Velocity and angular velocity of a point fixed in a link, 6.")
      .def("bias_acceleration", &RobotState::BiasOf, py::arg("link"), no_point,
           "Acceleration of a point fixed in a link if the generalised accelerations are zero: the rate of J times v.")
      .def("contact_frame", &RobotState::ContactOf, py::arg("foot"),
           "Contact frame of a foot on level ground, 4 x 4: the sole's frame, or the contact point below a sphere.")
      .def("contact_points", &RobotState::ContactPointsOf, py::arg("foot"),
           "Contact points of a foot, k x 3: the corners of its sole, or its single contact point.")
      .def_property_readonly("centre_of_mass", &RobotState::Centre, "[m]")
      .def("centre_of_mass_jacobian", &RobotState::CentreJacobian, "3 x nv")
      .def_property_readonly("momentum", &RobotState::Momentum, "[linear; angular about the centre of mass].")
      .def_property_readonly("energy_j", &RobotState::Energy,
                             "Kinetic plus potential energy; the potential energy is zero at height 0.")
      .def("mass_matrix", &RobotState::Mass, "M of M a + h = tau, nv x nv.")
      .def("inverse_dynamics", &RobotState::Forces, py::arg("a") = py::none(),
           R"(Generalised forces, size nv, without contact forces: tau = M a + h(q, v), gravity included.

The first six are the wrench on the base: force, then moment about its origin. Without a, the result is h.)")
      .def("inverse_dynamics_derivatives", &RobotState::Derivatives, py::arg("a") = py::none(),
           R"(Derivatives of `inverse_dynamics` by q, by v and by a: three nv x nv arrays; the third is the mass matrix.

Columns of the first are in the order of v: position of the base origin [m], small rotation of the base about world axes
[rad], joints; the numbers of v and a are held constant.)")
      .def("forward_dynamics", &RobotState::Accelerations, py::arg("tau"), py::arg("rotor_inertia") = py::none(),
           R"(Generalised accelerations, size nv, for generalised forces `tau`: the inverse of `inverse_dynamics`.

`rotor_inertia` is the reflected rotor inertia by joint [kg m^2]; default: zero.)");
  module.def("leg_joints", LegJoints, py::arg("robot").none(false), py::arg("foot"),
             "Names of the joints between base and foot, in the order of `solve_leg`: those near the base first.");
  module.def("solve_leg", SolveLeg, py::arg("robot").none(false), py::arg("foot"), py::arg("pose_in_base"),
             py::arg("guess") = py::none(),
             R"(Inverse kinematics: joint positions that bring a foot to a pose in the base's frame, 4 x 4.

For a sole, position and orientation are matched; for a point or the centre of a sphere, only the position. Among
several solutions, those whose knee bends as in the guess are preferred, then the one nearest to the guess. The default guess is
the nominal posture.

Raises:
    InfeasibleError: out of reach, or prevented by a joint limit; the message names the distance or the joint.)");
}

}  // namespace gaitwright::python
