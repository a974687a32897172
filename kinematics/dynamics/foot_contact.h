// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// The contact frame of a foot at the scratch's pose. For a sole or line, it is the frame F. For a point or sphere, it
/// is at the contact point (`radius` below the centre along the normal) with the axes of F.
Pose ContactFrame(const RobotModel& model, const DynamicsScratch& scratch, int foot,
                  const Vector3& normal_W = Vector3::UnitZ());

/// The contact points of a foot in W [m]: the corners of its sole, or its single contact point.
std::vector<Vector3> ContactPoints(const RobotModel& model, const DynamicsScratch& scratch, int foot,
                                   const Vector3& normal_W = Vector3::UnitZ());

/// Contact points for a known contact frame.
std::vector<Vector3> ContactPoints(const Foot& foot, const Pose& X_WF);

/// Adds to `tau` (size nv) the generalised forces J^T f of a force at a point fixed in a body.
void AddPointForce(const RobotModel& model, const DynamicsScratch& scratch, int body, const Vector3& p_WQ,
                   const Vector3& force_W, VectorX& tau);

/// Adds to `tau` the generalised forces of a wrench on a body: force and moment about p_WQ.
void AddPointWrench(const RobotModel& model, const DynamicsScratch& scratch, int body, const Vector3& p_WQ,
                    const Vector6& force_and_moment_W, VectorX& tau);

/// Adds to `tau` (size nv) `share` times the generalised forces that hold all bodies against gravity at the poses of
/// ForwardKinematics. They equal InverseDynamics at rest.
void AddHeldWeight(const RobotModel& model, const DynamicsScratch& scratch, double share, VectorX& tau);

}  // namespace gaitwright
