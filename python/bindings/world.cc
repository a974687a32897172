// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <memory>
#include <optional>

#include "playback/play/make_world.h"
#include "python/bindings/arrays.h"
#include "python/bindings/bindings.h"
#include "python/bindings/in_use.h"
#include "python/bindings/options.h"
#include "python/bindings/robot.h"
#include "python/bindings/terrain.h"

namespace gaitwright::python {
namespace {

namespace py = pybind11;

/// A world with a robot in it. Only one thread at a time may use it.
class SteppedWorld {
 public:
  SteppedWorld(SharedRobot robot, const py::object& terrain, const std::optional<VectorX>& q, const py::dict& options,
               const std::optional<std::string>& engine)
      : robot_(std::move(robot)),
        options_(From(options, engine)),
        world_(MakeWorld(*robot_, TerrainOf(terrain, *robot_), Start(q), options_)) {}

  void Step(const JointCommand& command, int steps) {
    if (steps < 1) throw InvalidArgument(fmt::format("the number of steps is {}; it must be 1 or more", steps));
    const InUse::Turn turn(in_use_, kName);
    for (int i = 0; i < steps; ++i) world_->Step(command);
    time_s_ += steps * options_.step_s;
  }

  /// Returns the result of `ask`, called with the physics.
  template <class Ask>
  auto With(const Ask& ask) {
    const InUse::Turn turn(in_use_, kName);
    return ask(*world_);
  }
  double time_s() const { return time_s_; }
  double step_s() const { return options_.step_s; }

  /// The input of a controller.
  ControlInput Measured(const std::optional<double>& time_s) {
    const InUse::Turn turn(in_use_, kName);
    ControlInput input{time_s.value_or(time_s_), options_.step_s, world_->q(), world_->v(), {}, 0};
    input.lead_steps = options_.lead_steps();
    for (std::size_t foot = 0; foot < world_->feet().size(); ++foot) {
      input.wrenches.push_back(world_->feet()[foot].wrench);
      if (world_->feet()[foot].touching) input.contact |= FootBit(static_cast<int>(foot));
    }
    return input;
  }

  void Push(const Vector3& force, const std::string& link) {
    if (!force.allFinite()) throw InvalidArgument("a push is not finite");
    const Frame& frame = robot_->frames[static_cast<std::size_t>(robot_->FrameIndex(link))];
    With([&](gaitwright::World& world) { world.PushBody(frame.body, force); });
  }

 private:
  static constexpr const char* kName = "this World";

  static WorldOptions From(const py::dict& given, const std::optional<std::string>& engine) {
    WorldOptions options;
    SetOptions(options.Fields(), given);
    if (engine) options.engine = *engine;
    return options;
  }
  VectorX Start(const std::optional<VectorX>& q) const { return q ? *q : StandingConfiguration(*robot_); }

  SharedRobot robot_;
  WorldOptions options_;
  std::unique_ptr<gaitwright::World> world_;
  double time_s_ = 0.0;
  InUse in_use_;
};

RowMatrix ForcesOn(const gaitwright::World& world) {
  std::vector<Vector3> forces;
  for (const FootContact& foot : world.feet()) forces.push_back(foot.wrench.force_W);
  return Rows(forces);
}

std::vector<bool> Touching(const gaitwright::World& world) {
  std::vector<bool> touching;
  for (const FootContact& foot : world.feet()) touching.push_back(foot.touching);
  return touching;
}

}  // namespace

void BindWorld(py::module_& module) {
  py::class_<SteppedWorld>(module, "World", R"(A robot on a terrain in a physics engine, step by step.

The state is integrated semi-implicitly. Motors are implicit PD with feed-forward within their limits. The result is
deterministic. Only one thread at a time may use a world.)")
      .def(py::init<SharedRobot, const py::object&, const std::optional<VectorX>&, const py::dict&,
                    const std::optional<std::string>&>(),
           py::arg("robot").none(false), py::arg("terrain") = "flat", py::arg("q") = py::none(),
           py::arg("options") = py::dict(), py::arg("engine") = py::none(),
           "The terrain is as for `plan_walk`. Options are those of ``play --set`` without the prefix ``play.``, such "
           "as step_s and friction. The engine is \"bullet\" or \"mujoco\"; default: that of the options, otherwise "
           "\"bullet\".")
      .def("step", &SteppedWorld::Step, py::arg("command"), py::arg("steps") = 1,
           py::call_guard<py::gil_scoped_release>(), "Makes this number of steps with one command.")
      .def("measured", &SteppedWorld::Measured, py::arg("time_s") = py::none(),
           "Measured state, as the input of a controller at this time.")
      .def(
          "set_state",
          [](SteppedWorld& w, const VectorX& q, const VectorX& v) {
            w.With([&](gaitwright::World& b) { b.SetState(q, v); });
          },
          py::arg("q"), py::arg("v"))
      .def("push", &SteppedWorld::Push, py::arg("force_n"), py::arg("link"),
           "Adds a force for the coming step, at the centre of mass of the body that a link is part of.")
      .def_property_readonly("time_s", &SteppedWorld::time_s)
      .def_property_readonly("step_s", &SteppedWorld::step_s)
      .def_property_readonly(
          "q", [](SteppedWorld& w) { return w.With([](gaitwright::World& b) { return VectorX(b.q()); }); })
      .def_property_readonly(
          "v", [](SteppedWorld& w) { return w.With([](gaitwright::World& b) { return VectorX(b.v()); }); })
      .def_property_readonly(
          "tau", [](SteppedWorld& w) { return w.With([](gaitwright::World& b) { return VectorX(b.tau()); }); },
          "Joint torques of the last step [N m].")
      .def_property_readonly(
          "forces_n", [](SteppedWorld& w) { return w.With(ForcesOn); },
          "Ground forces on the feet in the last step, feet x 3 [N].")
      .def_property_readonly(
          "contact", [](SteppedWorld& w) { return w.With(Touching); },
          "Whether each foot carried force in the last step.")
      .def_property_readonly(
          "body_contacts",
          [](SteppedWorld& w) { return w.With([](gaitwright::World& b) { return b.body_contacts(); }); },
          "Links other than feet that touch the ground.");
}

}  // namespace gaitwright::python
