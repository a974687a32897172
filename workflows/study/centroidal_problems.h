// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "optimisation/centroidal/rigid_body_problem.h"
#include "planning/plan/terrain.h"

namespace gaitwright {

/// A contact schedule of a problem set: alternating durations of contact and swing for each foot; all start in contact.
struct CentroidalSchedule {
  std::string name;
  std::vector<std::vector<double>> phase_durations_s;
};

/// A single rigid body of a problem set.
struct CentroidalRobot {
  double mass_kg = 1.0;
  Matrix3 inertia_B = Matrix3::Identity();
  std::vector<RigidFoot> feet;
  std::vector<CentroidalSchedule> schedules;
};

/// A set of problems for single rigid bodies: every combination of robot, schedule of the robot, and ground.
struct CentroidalProblemSet {
  std::vector<std::pair<std::string, CentroidalRobot>> robots;  ///< by name, in the order of the file
  std::vector<Terrain> grounds;
  double distance_m = 1.0, duration_s = 1.0, friction = 0.5;
};

/// Distance, duration and ground of every case.
struct CentroidalTask {
  double distance_m = 1.0, duration_s = 1.0, friction = 0.5;
  double higher_m = 0.0;  ///< extra height of the goal, relative to the start's height above the ground

  bool operator==(const CentroidalTask&) const = default;
};

/// Reads a set from a JSON file. Failure kBadInput names the file and the error.
Result<CentroidalProblemSet> LoadCentroidalProblems(const std::string& path);

/// Path of the built-in set.
std::string CentroidalProblemsPath();

/// A robot starts at rest above its feet and must end at rest `distance_m` forward, at its initial height above the
/// ground plus higher_m. Its schedule is scaled to the duration. Footholds are fixed at the start and free afterwards.
RigidBodyProblem CentroidalProblem(const CentroidalRobot& robot, const CentroidalSchedule& schedule,
                                   const Terrain& ground, const CentroidalTask& task);

/// The ground with the friction replaced.
Terrain WithFriction(Terrain ground, double friction);

}  // namespace gaitwright
