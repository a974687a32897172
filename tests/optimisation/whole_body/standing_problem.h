// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <vector>

#include "kinematics/dynamics/dynamics.h"
#include "optimisation/whole_body/solve_whole_body.h"
#include "planning/paths/standing_feet.h"

/// Robots that stand on the feet of their legs, as problems of the whole-body stage.
namespace gaitwright {

/// A robot that stands on level ground with its centre of mass at rest, for a number of samples.
struct StandingProblem {
  StandingProblem(const RobotModel& robot, int samples, double friction = 0.8)
      : model(robot), terrain(FlatTerrain(friction)) {
    centroidal.step_s = 0.005;
    DynamicsScratch scratch(model);
    ForwardKinematics(model, StandingConfiguration(model), scratch);
    centroidal.p_WC.assign(static_cast<std::size_t>(samples), CentreOfMass(model, scratch));
    centroidal.v_WC.assign(centroidal.p_WC.size(), Vector3::Zero());
    centroidal.a_WC = centroidal.v_WC;
    const std::vector<Pose> feet = StandingFeet(model);
    std::vector<std::vector<ContactInterval>> stays(model.feet.size());
    for (std::size_t f = 0; f < model.legs.size(); ++f) {
      stays[f] = {{0.0, end_s()}};
      footsteps.footholds.push_back({static_cast<int>(f), feet[f], Vector3::Zero(), 0, 0.0, end_s()});
    }
    schedule = ScheduleFromIntervals(stays, 0.0, end_s());
  }

  double end_s() const { return (centroidal.size() - 1) * centroidal.step_s; }

  /// Keeps references to this object.
  WholeBodyProblem Problem() const {
    return {&terrain, &schedule, &footsteps, &centroidal, &swings, [](double) { return BaseTurning{}; }};
  }

  /// The standing posture at each sample, with a constant acceleration of the base and zero speed.
  WholeBodySolution Still(const Vector3& acceleration = Vector3::Zero()) const {
    WholeBodySolution solution;
    solution.trajectory.step_s = centroidal.step_s;
    VectorX a = VectorX::Zero(model.nv());
    a.head<3>() = acceleration;
    for (int k = 0; k < centroidal.size(); ++k) {
      solution.trajectory.q.push_back(StandingConfiguration(model));
      solution.trajectory.v.push_back(VectorX::Zero(model.nv()));
      solution.trajectory.a.push_back(a);
    }
    return solution;
  }

  const RobotModel& model;
  Terrain terrain;
  ContactSchedule schedule;
  FootstepPlan footsteps;
  CentroidalTrajectory centroidal;
  std::vector<SwingTrajectory> swings;
};

}  // namespace gaitwright
