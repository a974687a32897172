// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/mesh_file.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright::fuzz {

/// What is true of every robot that was accepted: masses and inertias are physical, indices in range, limits in order,
/// names can be shown, it has a finite posture and stands in it. @throws BrokenLaw.
void CheckRobotLaws(const RobotModel& model);

/// Likewise of a mesh: indices in range, finite points, a hull of few of them.
void CheckMeshLaws(const Mesh& mesh);

}  // namespace gaitwright::fuzz
