// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/mesh_file.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright::fuzz {

/// Laws of every accepted robot: masses and inertias are physical, indices in range, limits in order, names are
/// printable, it has a finite posture and stands in it. @throws BrokenLaw.
void CheckRobotLaws(const RobotModel& model);

/// Laws of every accepted mesh: indices in range, finite points, a hull with few points.
void CheckMeshLaws(const Mesh& mesh);

}  // namespace gaitwright::fuzz
