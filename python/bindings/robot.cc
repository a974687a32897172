// SPDX-License-Identifier: BSD-3-Clause
#include "python/bindings/robot.h"

#include <fmt/format.h>
#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <vector>

#include "kinematics/base/nearest_name.h"
#include "kinematics/model/actuator.h"
#include "kinematics/model/describe.h"
#include "kinematics/model/load_robot.h"
#include "kinematics/model/names_description.h"
#include "python/bindings/bindings.h"
#include "python/bindings/errors.h"

namespace gaitwright::python {
namespace {

namespace py = pybind11;

SharedRobot Load(const std::filesystem::path& named, const std::filesystem::path& beside, bool strict) {
  const std::string name_or_urdf = named.string(), yaml = beside.string();
  const bool is_file = NamesDescription(name_or_urdf);
  if (!is_file && !yaml.empty()) throw InvalidArgument("yaml is for the path of a URDF, not for a robot's name");
  return std::make_shared<RobotModel>(
      Value(is_file ? LoadRobot(name_or_urdf, RobotLoading{.yaml_path = yaml, .strict = strict})
                    : LoadNamedRobot(name_or_urdf)));
}

/// One value for every independent joint.
template <double (RobotModel::*Figure)(int) const>
VectorX ByDof(const RobotModel& model) {
  VectorX figures(model.num_dofs());
  for (int dof = 0; dof < model.num_dofs(); ++dof) figures[dof] = (model.*Figure)(dof);
  return figures;
}

std::vector<std::string> MotorsOf(const RobotModel& model) {
  std::vector<std::string> names;
  for (const Actuator& motor : ActuatorsOf(model)) names.push_back(motor.name);
  return names;
}

/// One value for every motor.
template <double Actuator::*Figure>
VectorX ByMotor(const RobotModel& model) {
  VectorX figures(model.num_dofs());
  for (int index = 0; index < model.num_dofs(); ++index) figures[index] = ActuatorOf(model, index).*Figure;
  return figures;
}

void CheckJoints(const RobotModel& model, const VectorX& values, const char* what) {
  if (values.size() == model.num_dofs()) return;
  throw InvalidArgument(
      fmt::format("{} has {} numbers; '{}' has {} joints", what, values.size(), model.name, model.num_dofs()));
}

VectorX MotorTorques(const RobotModel& model, const VectorX& torques) {
  CheckJoints(model, torques, "torques");
  VectorX of_motors(model.num_dofs());
  for (int index = 0; index < model.num_dofs(); ++index) of_motors[index] = ActuatorOf(model, index).Effort(torques);
  return of_motors;
}

VectorX MotorSpeeds(const RobotModel& model, const VectorX& rates) {
  CheckJoints(model, rates, "rates");
  VectorX of_motors(model.num_dofs());
  for (int index = 0; index < model.num_dofs(); ++index) of_motors[index] = ActuatorOf(model, index).Speed(rates);
  return of_motors;
}

VectorX ClampTorques(const RobotModel& model, const VectorX& torques) {
  CheckJoints(model, torques, "torques");
  return ClampedEfforts(model, torques);
}

/// Names of joints and motors, and the ratios R.
py::list TransmissionsOf(const RobotModel& model) {
  py::list all;
  for (const Transmission& transmission : model.transmissions) {
    std::vector<std::string> joints, motors;
    for (const int dof : transmission.dofs) joints.push_back(model.dof_names[static_cast<std::size_t>(dof)]);
    for (const TransmissionMotor& motor : transmission.motors) motors.push_back(motor.name);
    py::dict one;
    one["name"] = transmission.name;
    one["joints"] = joints;
    one["motors"] = motors;
    one["ratios"] = transmission.ratios;
    all.append(one);
  }
  return all;
}

std::vector<std::string> FeetOf(const RobotModel& model) {
  std::vector<std::string> names;
  for (const Foot& foot : model.feet) names.push_back(foot.name);
  return names;
}

std::vector<std::string> LegsOf(const RobotModel& model) {
  std::vector<std::string> names;
  for (const Leg& leg : model.legs) names.push_back(leg.name);
  return names;
}

std::vector<std::string> LinksOf(const RobotModel& model) {
  std::vector<std::string> names;
  for (const Frame& frame : model.frames) names.push_back(frame.name);
  return names;
}

}  // namespace

int FootIndex(const RobotModel& model, const std::string& name) {
  const std::vector<std::string> names = FeetOf(model);
  for (std::size_t foot = 0; foot < names.size(); ++foot)
    if (names[foot] == name) return static_cast<int>(foot);
  throw InvalidArgument(fmt::format("'{}' has no foot '{}'{}", model.name, name, NearestHint(name, names)));
}

void BindRobot(py::module_& module) {
  py::class_<RobotModel, SharedRobot>(module, "Robot", R"(A robot: joints, limits, legs and feet. It never changes.

State vectors have one order everywhere::

    q = [position of the base (3), its quaternion x y z w (4), joints (n)]
    v = [velocity of the base (3), its angular velocity (3), joint rates (n)], both in world axes

SI units; z of the world is up, x forward.)")
      .def_readonly("name", &RobotModel::name)
      .def_readonly("hash", &RobotModel::hash, "Hash of all data that the robot was made from.")
      .def_readonly("mass_kg", &RobotModel::total_mass_kg)
      .def_property_readonly("weight_n", &RobotModel::weight_n)
      .def_property_readonly("leg_length_m", &RobotModel::leg_length_m,
                             "Length of the longest leg when straight, from hip to contact.")
      .def_readonly("nominal_speed_m_s", &RobotModel::nominal_speed_m_s)
      .def_property_readonly("nq", &RobotModel::nq, "Size of q: 7 + n.")
      .def_property_readonly("nv", &RobotModel::nv, "Size of v: 6 + n.")
      .def_property_readonly("num_joints", &RobotModel::num_dofs, "Independent joints: n.")
      .def_readonly("joints", &RobotModel::dof_names, "Names of the independent joints, in the order of q.")
      .def_property_readonly("legs", LegsOf, "Names of the legs: front before rear, left before right.")
      .def_property_readonly(
          "feet", FeetOf,
          "Names of the feet: those of the legs in their order, then support contacts of trunk or limbs.")
      .def_property_readonly("links", LinksOf, "Names of all URDF links.")
      .def_property_readonly("lower", ByDof<&RobotModel::dof_lower>, "Lowest positions of the joints [rad] or [m].")
      .def_property_readonly("upper", ByDof<&RobotModel::dof_upper>, "Highest positions of the joints [rad] or [m].")
      .def_property_readonly("velocity_limit", ByDof<&RobotModel::dof_velocity_limit>,
                             "Velocity limits of the joints [rad/s] or [m/s]; infinite if unknown. For a joint driven "
                             "by a transmission: the\n"
                             "largest velocity that its motors allow, see motor_velocity_limit.")
      .def_property_readonly(
          "effort_limit", ByDof<&RobotModel::dof_effort_limit>,
          "Effort limits of the joints [N m] or [N]; infinite if unknown. For a joint driven by a transmission: the\n"
          "largest effort that its motors allow, see motor_effort_limit.")
      .def_property_readonly(
          "motors", MotorsOf,
          "Names of the motors, as many as joints. A motor has the name of its joint, except for motors of\n"
          "transmissions, which are at the positions of their joints.")
      .def_property_readonly("motor_velocity_limit", ByMotor<&Actuator::velocity_limit>,
                             "Velocity limits of the motors [rad/s] or [m/s]; infinite if unknown.")
      .def_property_readonly("motor_effort_limit", ByMotor<&Actuator::effort_limit>,
                             "Effort limits of the motors [N m] or [N]; infinite if unknown.")
      .def_property_readonly(
          "transmissions", TransmissionsOf,
          "Transmissions that drive several joints together: dictionaries with `name`, `joints`,\n"
          "`motors` and `ratios`, R: speeds of the motors = R @ rates of the joints, torques of the\n"
          "joints = R.T @ torques of the motors.")
      .def("motor_torques", MotorTorques, py::arg("torques"), "Motor torques for given joint torques.")
      .def("motor_speeds", MotorSpeeds, py::arg("rates"), "Motor speeds for given joint rates.")
      .def("clamp_torques", ClampTorques, py::arg("torques"),
           "Joint torques after each motor torque is limited to its effort limit.")
      .def_readonly("notes", &RobotModel::notes, "Notes on derived data and their sources, and on irregularities.")
      .def_property_readonly("standing", StandingConfiguration, "q of the nominal posture above the world's origin.")
      .def("describe", DescribeRobot, "Description of the robot and of derived data, as text.")
      .def("__repr__", [](const RobotModel& model) {
        return fmt::format("<gaitwright.Robot {}: {} legs, {} joints, {:.4g} kg>", model.name, model.legs.size(),
                           model.num_dofs(), model.total_mass_kg);
      });

  module.def("load_robot", Load, py::arg("name_or_urdf"), py::arg("yaml") = "", py::arg("strict") = false,
             R"(Loads a robot by its name (see `robot_names`), or from a URDF, xacro or MJCF file.

Args:
    name_or_urdf: a name or a path; a text is a path if it has a slash or ends in ``.urdf``, ``.xacro``, ``.xml`` or
        ``.mjcf``.
    yaml: path of a robot.yaml with data that cannot be derived; "" uses the robot.yaml beside the URDF, if it exists;
        "none" uses the URDF alone.
    strict: refuse a description that would need a repair.

Raises:
    BadInputError: the robot or the file does not exist or is wrong; the message says where.)");
  module.def("robot_names", RobotNames, "Names of the built-in robots.");
}

}  // namespace gaitwright::python
