// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/base/version.h"
#include "python/bindings/bindings.h"

PYBIND11_MODULE(_core, module) {
  using namespace gaitwright::python;
  module.doc() = "Gaitwright's C++ core; use the package gaitwright.";
  BindErrors(module);
  BindRobot(module);
  BindRobotState(module);
  BindTerrain(module);
  BindPlan(module);
  BindAudit(module);
  BindControllers(module);
  BindWorld(module);
  BindPlayback(module);
  BindPlanning(module);
  BindTrials(module);
  BindTasks(module);
  BindPolicies(module);
  BindRepair(module);
  BindCompare(module);
  module.attr("__version__") = gaitwright::Version();
}
