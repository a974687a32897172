// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/spatial/pose.h"
#include "kinematics/stability/polygon.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Region of the ZMP in one contact phase: a convex set whose corners move linearly from start to end, with a preferred
/// point that moves in the same way.
struct ZmpPhase {
  double start_s = 0.0, end_s = 0.0;
  Polygon region_start, region_end;  ///< corners correspond one to one
  Vector2 preferred_start = Vector2::Zero(), preferred_end = Vector2::Zero();
};

/// The planar problem of the linear inverted pendulum with a known disturbance d(t):
///   c'' = w^2 (c - (p - d)),  p(t) in its region,  c and c' given at both ends (at rest).
/// d is the multibody ZMP minus the pendulum's, so p is the ZMP of the whole robot.
struct ZmpProblem {
  double start_s = 0.0, step_s = 0.005;
  int samples = 2;  ///< of the uniform grid, both ends included
  double omega_rad_s = 1.0;
  double com_height_m = 1.0;
  Vector2 start_W = Vector2::Zero(), end_W = Vector2::Zero();  ///< centre of mass at rest [m]
  std::vector<ZmpPhase> phases;
  std::vector<Vector2> zmp_offset;  ///< d by sample [m]
};

/// A planned centre of mass.
struct CentreOfMassPlan {
  CentroidalTrajectory trajectory;
  double margin_min_m = 0.0;  ///< smallest signed distance of the ZMP to the edge of regions with area
  std::string summary;
};

/// The corners of a phase's region at a time.
Polygon RegionAt(const ZmpPhase& phase, double time_s);

/// The preferred point at a time: smooth from start to end in a region with area, linear on a line. Both ends move with
/// the region's corners, so a point that starts and ends in the region stays in it.
Vector2 PreferredAt(const ZmpPhase& phase, double time_s);

/// Index of the phase at a time; a boundary belongs to the later one.
std::size_t ZmpPhaseAt(const ZmpProblem& problem, double time_s);

/// CoM, velocity and acceleration computed exactly from a ZMP that is linear between samples: the DCM backward from
/// rest at the end, the CoM forward from the start. Englsberger et al., T-RO 31(2), 2015, section III.
CentroidalTrajectory PendulumMotion(const ZmpProblem& problem, const std::vector<Vector2>& p_WZ);

/// Dependence of both ends of PendulumMotion on the ZMP, the same for x and y; u = p - d by sample:
///   DCM at the start = sum_k dcm_start[k] u_k + dcm_start_by_end * end_W
///   CoM at the end   = sum_k com_end[k] u_k + com_end_by_start * start_W + com_end_by_end * end_W
/// If the first equals the CoM at the start and the second equals `end_W`, the pendulum starts and ends at rest.
struct EndResponse {
  std::vector<double> dcm_start, com_end;
  double dcm_start_by_end = 0.0, com_end_by_start = 0.0, com_end_by_end = 0.0;
};

/// The response of a problem's grid and frequency; regions and references do not matter.
EndResponse RespondAtEnds(const ZmpProblem& problem);

}  // namespace gaitwright
