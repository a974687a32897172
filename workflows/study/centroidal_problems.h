// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "optimisation/centroidal/rigid_body_problem.h"
#include "planning/plan/terrain.h"

namespace gaitwright {

/// A schedule of contact of a problem set: durations of contact and of swing in turn, by foot; all start in contact.
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

/// A set of problems for single rigid bodies: each robot by each of its schedules on each ground.
struct CentroidalProblemSet {
  std::vector<std::pair<std::string, CentroidalRobot>> robots;  ///< by name, in the order of the file
  std::vector<Terrain> grounds;
  double distance_m = 1.0, duration_s = 1.0, friction = 0.5;
};

/// How far, how fast and how rough: what is asked of every case.
struct CentroidalTask {
  double distance_m = 1.0, duration_s = 1.0, friction = 0.5;
  double higher_m = 0.0;  ///< the goal, than where it is as high over the ground as the start

  bool operator==(const CentroidalTask&) const = default;
};

/// Reads a set from a JSON file. Failure kBadInput names the file and what is wrong with it.
Result<CentroidalProblemSet> LoadCentroidalProblems(const std::string& path);

/// Where the set is that comes with the program.
std::string CentroidalProblemsPath();

/// A robot at rest over its feet that is to be at rest `distance_m` ahead, as high over the ground there as it was, and
/// higher_m more; its schedule is stretched to the duration. Feet are held at the start and not placed afterwards.
RigidBodyProblem CentroidalProblem(const CentroidalRobot& robot, const CentroidalSchedule& schedule,
                                   const Terrain& ground, const CentroidalTask& task);

/// The ground with its friction set.
Terrain WithFriction(Terrain ground, double friction);

}  // namespace gaitwright
