// SPDX-License-Identifier: BSD-3-Clause
#include "python/bindings/controllers.h"

#include <fmt/format.h>
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <optional>

#include "kinematics/model/check_state.h"
#include "playback/control/gains.h"
#include "python/bindings/bindings.h"
#include "python/bindings/options.h"

namespace gaitwright::python {
namespace {

namespace py = pybind11;

/// A controller written in Python.
class PythonController : public Controller {
 public:
  JointCommand Update(const ControlInput& input) override {
    const py::gil_scoped_acquire python;
    const py::function update = py::get_override(static_cast<const Controller*>(this), "update");
    if (!update) throw InvalidArgument("a controller needs a method update(self, input) that gives a JointCommand");
    const py::object command = update(py::cast(input, py::return_value_policy::copy));
    if (!py::isinstance<JointCommand>(command))
      throw InvalidArgument(
          fmt::format("update() gave {}; a JointCommand is needed", py::repr(command).cast<std::string>()));
    return command.cast<JointCommand>();
  }
  void Reset() override { PYBIND11_OVERRIDE_NAME(void, Controller, "reset", Reset, ); }
  std::string Name() const override {
    const py::gil_scoped_acquire python;
    const auto* self = static_cast<const Controller*>(this);
    if (const py::function name = py::get_override(self, "name")) return name().cast<std::string>();
    return py::type::of(py::cast(self)).attr("__name__").cast<std::string>();
  }
};

/// Writes a vector in place, since Python arrays may view it. @throws InvalidArgument for another size.
template <auto Vector, class Owner>
void SetVector(Owner& owner, const VectorX& given) {
  VectorX& own = owner.*Vector;
  if (own.size() != 0 && given.size() != own.size())
    throw InvalidArgument(fmt::format("{} numbers are given; {} are needed", given.size(), own.size()));
  own = given;
}

/// A vector of a class as a property: an array that is a view of it.
template <auto Vector, class Owner>
void BindVector(py::class_<Owner>& bound, const char* name, const char* what = "") {
  bound.def_property(
      name, [](Owner& owner) -> VectorX& { return owner.*Vector; }, SetVector<Vector, Owner>, what);
}

/// Forces on the feet, feet x 3.
RowMatrix ForcesOf(const ControlInput& input) {
  std::vector<Vector3> forces;
  for (const ContactWrench& wrench : input.wrenches) forces.push_back(wrench.force_W);
  return Rows(forces);
}

std::vector<bool> ContactOf(const ControlInput& input) {
  std::vector<bool> touching;
  for (std::size_t foot = 0; foot < input.wrenches.size(); ++foot)
    touching.push_back(Contains(input.contact, static_cast<int>(foot)));
  return touching;
}

JointCommand MakeCommand(const VectorX& q, const std::optional<VectorX>& v, const std::optional<VectorX>& tau_ff,
                         const std::optional<VectorX>& stiffness, const std::optional<VectorX>& damping) {
  const auto or_none = [&](const std::optional<VectorX>& column) {
    return column ? *column : VectorX(VectorX::Zero(q.size()));
  };
  return {q, or_none(v), or_none(tau_ff), or_none(stiffness), or_none(damping)};
}

std::shared_ptr<OwnController> MakeOwn(const std::shared_ptr<Plan>& plan, const std::string& name,
                                       const py::dict& options) {
  PlayRequest request = PlayRequestOf(options);
  request.controller = name;
  return std::make_shared<OwnController>(plan, request);
}

py::tuple GainsOf(const RobotModel& model, const py::dict& options) {
  GainOptions gains;
  SetOptions(gains.Fields(), options);
  const Gains derived = DeriveGains(model, gains);
  return py::make_tuple(derived.stiffness, derived.damping);
}

ControlInput MakeInput(double time_s, double step_s, const VectorX& q, const VectorX& v, const RowMatrix& forces_n,
                       const std::vector<bool>& contact) {
  if (forces_n.cols() != 3 || forces_n.rows() != static_cast<Eigen::Index>(contact.size()))
    throw InvalidArgument(fmt::format("forces_n is {} x {}; {} x 3 are needed: one row for each foot of contact",
                                      forces_n.rows(), forces_n.cols(), contact.size()));
  ControlInput input{time_s, step_s, q, v, {}, 0};
  for (std::size_t foot = 0; foot < contact.size(); ++foot) {
    input.wrenches.push_back({forces_n.row(static_cast<Eigen::Index>(foot)).transpose(), Vector3::Zero()});
    if (contact[foot]) input.contact |= FootSet{1} << foot;
  }
  return input;
}

void BindInput(py::module_& module) {
  py::class_<ControlInput> input(module, "ControlInput", "Input of a controller at the start of a step.");
  input.def(py::init<>())
      .def(py::init(&MakeInput), py::arg("time_s"), py::arg("step_s"), py::arg("q"), py::arg("v"), py::arg("forces_n"),
           py::arg("contact"), "Makes an input, to call a controller without a playback.")
      .def_readwrite("time_s", &ControlInput::time_s,
                     "Time on the plan's clock [s]; it continues after the end of the plan.")
      .def_readwrite("step_s", &ControlInput::step_s)
      .def_readwrite("lead_steps", &ControlInput::lead_steps,
                     "Number of steps after time_s at which the motors compare their joints with the command: 1, or 0 "
                     "with play.actuation=torque.")
      .def_property_readonly("forces_n", ForcesOf, "Ground forces on the feet in the last step, feet x 3 [N].")
      .def_property_readonly("contact", ContactOf, "Whether each foot carried force in the last step.");
  BindVector<&ControlInput::q>(input, "q", "Measured state of the robot, nq.");
  BindVector<&ControlInput::v>(input, "v", "Measured velocities of the robot, nv.");
}

}  // namespace

void CheckInput(const RobotModel& model, const ControlInput& input) {
  CheckState(model, input.q, input.v);
  if (input.wrenches.size() != model.feet.size())
    throw InvalidArgument(
        fmt::format("forces_n has {} feet; '{}' has {}", input.wrenches.size(), model.name, model.feet.size()));
}

void BindControllers(py::module_& module) {
  BindInput(module);
  py::class_<JointCommand> command(module, "JointCommand", R"(Command to the motors until the next call, by joint::

    tau = tau_ff + stiffness (q - q_measured) + damping (v - v_measured), within the effort limit)");
  command.def(py::init(&MakeCommand), py::arg("q"), py::arg("v") = py::none(), py::arg("tau_ff") = py::none(),
              py::arg("stiffness") = py::none(), py::arg("damping") = py::none(), "Omitted arguments are zero.");
  BindVector<&JointCommand::q>(command, "q");
  BindVector<&JointCommand::v>(command, "v");
  BindVector<&JointCommand::tau_ff>(command, "tau_ff");
  BindVector<&JointCommand::stiffness>(command, "stiffness");
  BindVector<&JointCommand::damping>(command, "damping");
  py::class_<Controller, PythonController, std::shared_ptr<Controller>>(
      module, "Controller",
      R"(Computes a command from the state once per step.

Your own class must have ``update(self, input)``, which returns a `JointCommand`. It may have ``reset(self)``, which is
called before a playback, and ``name(self)``, the name in logs and reports; the default is the name of the class. Take
the time from ``input.time_s`` and do not count steps, because ``input.time_s`` may stand still.)")
      .def(py::init<>())
      .def("update", &Controller::Update, py::arg("input"))
      .def("reset", &Controller::Reset)
      .def("name", &Controller::Name);
  const py::class_<OwnController, Controller, std::shared_ptr<OwnController>> own(module, "OwnController",
                                                                                  "A built-in controller.");
  module.def("make_controller", MakeOwn, py::arg("plan").none(false), py::arg("name") = "stabilised",
             py::arg("options") = py::dict(),
             "Makes one of CONTROLLERS for a plan, to call step by step or to use in a playback.");
  module.def("derive_gains", GainsOf, py::arg("robot").none(false), py::arg("options") = py::dict(),
             "Stiffness and damping by joint, derived from the inertia that each joint moves.");
  module.attr("CONTROLLERS") = ControllerNames();
}

}  // namespace gaitwright::python
