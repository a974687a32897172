// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "kinematics/base/data_shape.h"

namespace gaitwright {

inline constexpr char kPlanFormat[] = "gaitwright-motion-plan";
inline constexpr std::size_t kMostHullPoints = 10000;
inline constexpr double kMostFriction = 100.0;                    ///< coefficient
inline constexpr double kLongestStep = 10.0, kLongestTime = 1e6;  ///< [s]
inline constexpr double kWidestGate = 10.0, kLongestWait = 60.0;  ///< [rad] or [m], [s]
inline constexpr int kMostFeet = 64;                              ///< size of FootSet
inline constexpr int kMostNodesAlong = 100000;                    ///< along one side of a height field
inline constexpr int kMostSteps = 1000000;

// Structures of the parts of a plan file.
DataShape MeshShape();
DataShape PlanarPoseShape();
DataShape CommandShape();
DataShape PlanPatchShape();
DataShape PlanHeightFieldShape();
DataShape PlanObstacleShape();
DataShape PlanMarkerShape();
DataShape PlanTerrainShape();
DataShape PlanGaitShape();
DataShape PlanPartShape();
DataShape PlanGateShape();
DataShape FootholdShape();
DataShape SwingShape();
DataShape ProvenanceShape();

}  // namespace gaitwright
