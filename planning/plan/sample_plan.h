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

/// The state at a time: joints and base position by the quintic that has q, v, a of both nodes, the base's rotation by
/// the same quintic of the rotation vector from the left node, torques and wrenches linearly. Before the first node and
/// after the last one: that node at rest. No allocation once `sample` has its sizes.
void SampleWholeBody(const WholeBodyTrajectory& trajectory, double time_s, WholeBodySample& sample);

/// A centroidal trajectory between its nodes.
struct CentroidalSample {
  Vector3 p_WC = Vector3::Zero(), v_WC = Vector3::Zero(), a_WC = Vector3::Zero();
  Vector2 p_WZ = Vector2::Zero();
};

/// The centroidal trajectory at a time: the quintic that has p, v, a of both nodes; the ZMP linearly. Before
/// the first node and after the last one: that node at rest.
CentroidalSample SampleCentroidal(const CentroidalTrajectory& trajectory, double time_s);

/// How far the centre of mass goes between two times [m].
Vector3 CentreWay(const CentroidalTrajectory& trajectory, double from_s, double to_s);

/// A swing as a curve that can be evaluated.
SwingCurve CurveOf(const SwingTrajectory& swing);

}  // namespace gaitwright
