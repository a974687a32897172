// SPDX-License-Identifier: BSD-3-Clause
#include "python/bindings/policies.h"

#include <fmt/format.h>
#include <pybind11/eigen.h>
#include <pybind11/functional.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "kinematics/base/file.h"
#include "python/bindings/bindings.h"
#include "python/bindings/errors.h"
#include "python/bindings/options.h"
#include "python/bindings/plan.h"
#include "python/bindings/playback.h"
#include "python/bindings/terrain.h"

namespace gaitwright::python {
namespace {

namespace fs = std::filesystem;
namespace py = pybind11;

/// A network from an ONNX file. It never changes.
class OnnxNetwork {
 public:
  explicit OnnxNetwork(const fs::path& path)
      : network_(Value(Network::Read(Value(ReadBytes(path.string())), path.string()))) {}

  const Network& network() const { return network_; }

  Eigen::VectorXf Evaluate(const Eigen::VectorXf& input) const {
    if (input.size() != network_.input_size())
      throw InvalidArgument(
          fmt::format("the input has {} numbers; the network needs {}", input.size(), network_.input_size()));
    NetworkScratch scratch = network_.MakeScratch();
    Eigen::VectorXf output(network_.output_size());
    network_.Evaluate(input, scratch, output);
    return output;
  }

 private:
  Network network_;
};

/// A policy of the caller's: any callable that takes an array and returns one.
PolicyFunction FunctionOf(const py::object& policy) {
  const auto callable = py::cast<std::function<py::object(const Eigen::VectorXf&)>>(policy);
  return [callable](const Eigen::VectorXf& observation) -> Eigen::VectorXf {
    const py::gil_scoped_acquire python;
    const py::object action = callable(observation);
    const py::array_t<float, py::array::c_style | py::array::forcecast> numbers(action);
    return Eigen::Map<const Eigen::VectorXf>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
  };
}

/// The policy: the path of a file, or a callable.
void SetPolicy(const py::object& policy, PolicyRequest& request) {
  if (py::isinstance<py::str>(policy) || py::hasattr(policy, "__fspath__")) {
    request.network_path = py::cast<fs::path>(policy).string();
    return;
  }
  request.function = FunctionOf(policy);
  const py::object named = py::hasattr(policy, "__name__") ? policy : py::object(py::type::of(policy));
  request.name = py::cast<std::string>(named.attr("__name__"));
}

std::shared_ptr<Policy> FitGiven(const SharedRobot& robot, const py::object& policy, const fs::path& contract,
                                 const fs::path& commands, double speed, double lateral_speed, double yaw_rate,
                                 const std::optional<double>& duration, const std::vector<std::string>& joint_order,
                                 const py::object& terrain) {
  PolicyRequest request;
  SetPolicy(policy, request);
  request.contract_path = contract.string();
  request.commands_path = commands.string();
  request.command = {0.0, speed, lateral_speed, yaw_rate};
  request.duration_s = duration;
  request.joint_order = joint_order;
  request.ground = TerrainOf(terrain, *robot);
  if (!request.commands_path.empty() && !request.command.AsVector().isZero(0.0))
    throw InvalidArgument("give either commands, or speed, lateral_speed and yaw_rate");
  const py::gil_scoped_release others_go_on;
  return std::make_shared<Policy>(robot, Value(PreparePolicy(*robot, request)));
}

Playback PlayFitted(const Policy& policy, const py::dict& options, const std::optional<std::string>& engine) {
  PlayRequest play = PlayRequestOf(options);
  if (engine) play.play.world.engine = *engine;
  const py::gil_scoped_release others_go_on;
  UsePolicy(policy.prepared(), play);
  return {policy.plan(), Value(PlayWalk(policy.model(), policy.plan()->motion(), play))};
}

}  // namespace

void BindPolicies(py::module_& module) {
  py::class_<OnnxNetwork>(module, "Network", "A feed-forward network from an ONNX file; call it with an observation.")
      .def(py::init<const fs::path&>(), py::arg("path"))
      .def_property_readonly("input_size", [](const OnnxNetwork& n) { return n.network().input_size(); })
      .def_property_readonly("output_size", [](const OnnxNetwork& n) { return n.network().output_size(); })
      .def_property_readonly(
          "notes", [](const OnnxNetwork& n) { return n.network().notes(); }, "Texts that the exporter added, by key.")
      .def("__call__", &OnnxNetwork::Evaluate, py::arg("observation"), "The output for one observation.")
      .def("__repr__", [](const OnnxNetwork& n) {
        return fmt::format("<gaitwright.Network: {} inputs, {} outputs, {}>", n.network().input_size(),
                           n.network().output_size(), n.network().operators());
      });
  py::class_<Policy, std::shared_ptr<Policy>>(module, "Policy",
                                              R"(A learned policy that fits a robot, with its commands.

Its text is the table of joints, gains and observations that the robot gets: read it before hardware. `trials` takes a
policy instead of a plan.)")
      .def(py::init(&FitGiven), py::arg("robot").none(false), py::arg("policy").none(false), py::arg("contract"),
           py::kw_only(), py::arg("commands") = "", py::arg("speed") = 0.0, py::arg("lateral_speed") = 0.0,
           py::arg("yaw_rate") = 0.0, py::arg("duration") = py::none(),
           py::arg("joint_order") = std::vector<std::string>(), py::arg("terrain") = "flat",
           R"(Reads a policy and fits it to the robot.

Args:
    policy: path of an ONNX file, or any callable that takes an observation (array of float32) and returns an action.
    contract: path of the policy's contract, such as Unitree's deploy.yaml.
    commands: path of a file of velocity commands over time; or a constant command as ``speed``, ``lateral_speed``
        [m/s] and ``yaw_rate`` [rad/s].
    duration: of a playback [s]; default 10, or 5 after the last command of a file.
    joint_order: names of the joints in the order of the contract's stiffness, if the contract does not have them.
    terrain: a `Terrain`, or the name or file of one.)")
      .def_property_readonly("plan", &Policy::plan, "The commands as a plan.")
      .def("play", PlayFitted, py::kw_only(), py::arg("options") = py::dict(), py::arg("engine") = py::none(),
           "Plays the policy in physics and scores it; options and engine as for `play`.")
      .def("to_json", [](const Policy& p) { return PolicyJson(p.model(), *p.prepared().policy); })
      .def("__str__", [](const Policy& p) { return PolicyText(p.model(), *p.prepared().policy); });
}

}  // namespace gaitwright::python
