// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "optimisation/trajectory/body_problem_internal.h"
#include "tests/kinematics/made_robots.h"

/// Robots that stand and lift feet, as problems of the trajectory stage.
namespace gaitwright {

/// A robot in its standing posture over so many knots of 10 ms. All feet press, but in the middle third the feet with
/// even numbers are held where they are without force.
inline BodyProblem LiftingProblem(const RobotModel& model, int knots) {
  BodyProblem problem;
  problem.model = &model;
  const VectorX q = StandingConfiguration(model), none = VectorX::Zero(model.nv());
  problem.chart = TurningChart(TurningChart::First::kYaw, BaseRotation(q));
  DynamicsScratch scratch(model);
  ForwardKinematics(model, q, scratch);
  const VectorJet standing = JetOf(problem.chart, q, none, none, none);
  for (int k = 0; k < knots; ++k) {
    problem.time_s.push_back(0.01 * k);
    BodyKnot knot;
    knot.reference = standing;
    knot.pins_place = k == 0;
    knot.pins_motion = k == 0 || k + 1 == knots;
    const bool lifted = 3 * k > knots && 3 * k < 2 * knots;
    for (std::size_t f = 0; f < model.legs.size(); ++f) {
      const Foot& foot = model.feet[f];
      const Pose X_WF = FramePose(scratch, foot.body, foot.X_BF);
      FootGoal goal;
      goal.foot = static_cast<int>(f);
      goal.p_W = X_WF.translation();
      goal.R_W = goal.R_roll = X_WF.linear();
      goal.rows = {true, true, true, foot.has_sole(), foot.has_sole(), foot.has_sole()};
      goal.swings = lifted && f % 2 == 0;
      knot.feet.push_back(goal);
      if (goal.swings) continue;
      PressingFoot pressing;
      pressing.contact = {goal.foot, {Vector3::Zero()}, -foot.radius * Vector3::UnitZ()};
      if (foot.has_sole()) pressing.contact.points_F.clear();
      for (const Vector2& corner : foot.sole_F) pressing.contact.points_F.emplace_back(corner.x(), corner.y(), 0.0);
      knot.pressing.push_back(pressing);
    }
    problem.knots.push_back(knot);
  }
  return problem;
}

/// A problem of one of kAnyRobots with something of everything (rolled spheres and tilted ground, losses and curves, a
/// row that is left out, links that are kept apart and off a slope, points near places, weights by coordinate), and
/// random unknowns.
struct AnyProblem {
  explicit AnyProblem(const std::string& name) : model(AnyRobot(name)) {
    RandomState random(7);
    model.joints[2].damping = 0.4;
    model.motors[0].rotor_inertia = 0.05;
    model.motors[1].corner_speed = 5.0;
    model.motors[1].no_load_speed = 12.0;
    model.motors[3].acceleration_limit = 40.0;
    model.motors[2].jerk_limit = 900.0;
    model.motors[4].jerk_limit = 700.0;
    problem = LiftingProblem(model, 5);
    Eigen::Index size = model.nv() * (5 + 2);
    for (BodyKnot& knot : problem.knots) {
      for (FootGoal& goal : knot.feet) {
        goal.p_W += 0.01 * random.Vector(3);
        goal.R_roll = RotationExp(0.2 * random.Vector(3)) * goal.R_roll;
        goal.R_W = RotationExp(0.2 * random.Vector(3)) * goal.R_W;
        goal.axes_W = goal.R_W;
        goal.normal_W = goal.axes_W.col(2);
      }
      knot.feet.front().rows[1] = false;
      for (const PressingFoot& foot : knot.pressing)
        size += 3 * static_cast<Eigen::Index>(foot.contact.points_F.size());
    }
    problem.knots[2].pressing.front().axes_W = RotationExp({0.3, -0.1, 0.2});
    FixedSolids solids;
    solids.half_spaces.push_back({"slope", Vector3(0.1, -0.2, 1.0).normalized(), 0.1});
    problem.distances = &distances.emplace(model, solids);
    for (int pair = 0; pair < std::min(4, distances->num_pairs()); ++pair)
      problem.knots[1].apart.push_back({pair, 0.1});
    const int last = static_cast<int>(model.bodies.size()) - 1;
    problem.knots[3].apart = {{distances->num_pairs() - 1, 0.05}};
    problem.knots[3].points = {{last, {0.1, -0.2, 0.3}, {0.1, 0.0, 0.2}, false, 3.0}, {last, {}, {}, true, 0.5}};
    problem.knots[3].near_scale = VectorX::Ones(model.nv()) + random.Vector(model.nv()).cwiseAbs();
    z = 0.3 * random.Vector(size);
  }
  AnyProblem(const AnyProblem&) = delete;  // the problem refers to the model

  RobotModel model;
  std::optional<LinkDistances> distances;
  BodyProblem problem;
  VectorX z;
};

}  // namespace gaitwright
