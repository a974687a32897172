// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

namespace gaitwright::python {

// The parts of the module, one file each; later parts use earlier ones.

/// Failures as exceptions of the package.
void BindErrors(pybind11::module_& module);
void BindRobot(pybind11::module_& module);
/// Kinematics, dynamics and inverse kinematics of a robot.
void BindRobotState(pybind11::module_& module);
void BindTerrain(pybind11::module_& module);
void BindPlan(pybind11::module_& module);
/// Planning of walks, and of motions over given footsteps.
void BindPlanning(pybind11::module_& module);
void BindAudit(pybind11::module_& module);
/// Physics, step by step.
void BindWorld(pybind11::module_& module);
void BindControllers(pybind11::module_& module);
/// Whole playbacks and their scores.
void BindPlayback(pybind11::module_& module);
void BindTrials(pybind11::module_& module);
/// Instructions in words, and motions that carry them out.
void BindTasks(pybind11::module_& module);
/// Learned policies.
void BindPolicies(pybind11::module_& module);
/// Repair of motions of other software.
void BindRepair(pybind11::module_& module);
/// Comparison of two motions.
void BindCompare(pybind11::module_& module);

}  // namespace gaitwright::python
