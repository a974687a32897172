// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/trajectory/swing_curve.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// A whole-body trajectory between its nodes.
struct WholeBodySample {
  VectorX q, v, a, tau;
  std::vector<ContactWrench> wrenches;
};

/// The state at a time. Joints and base position follow the quintic with q, v, a of both nodes; the base's rotation
/// follows the quintic of the rotation vector from the left node; torques and wrenches are linear. Before the first
/// node and after the last one, it is that node at rest. Does not allocate once `sample` has its sizes.
void SampleWholeBody(const WholeBodyTrajectory& trajectory, double time_s, WholeBodySample& sample);

/// A centroidal trajectory between its nodes.
struct CentroidalSample {
  Vector3 p_WC = Vector3::Zero(), v_WC = Vector3::Zero(), a_WC = Vector3::Zero();
  Vector2 p_WZ = Vector2::Zero();
};

/// The centroidal trajectory at a time: the quintic with p, v, a of both nodes; the ZMP is linear. Before the first
/// node and after the last one, it is that node at rest.
CentroidalSample SampleCentroidal(const CentroidalTrajectory& trajectory, double time_s);

/// Displacement of the centre of mass between two times [m].
Vector3 CentreDisplacement(const CentroidalTrajectory& trajectory, double from_s, double to_s);

/// The curve of a swing, for evaluation.
SwingCurve CurveOf(const SwingTrajectory& swing);

}  // namespace gaitwright
