// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <vector>

#include "optimisation/centroidal/rigid_body_problem.h"
#include "optimisation/centroidal/rigid_body_unknowns.h"

/// Single rigid bodies for tests.
namespace gaitwright::rigid_bodies {

/// A contact interval of a foot, at a share of the path.
struct Step {
  int foot;
  double start_s, end_s, share;
};

inline RigidFoot PointFoot(const Vector3& nominal_B, const Vector3& half_box) {
  RigidFoot foot;
  foot.p_CF_nominal_B = nominal_B;
  foot.workspace_B = BoxAbout(nominal_B, half_box);
  return foot;
}

/// A body above its feet that moves `distance_m` forward on level ground, from rest to rest, by steps. Footholds at the
/// start are fixed, the others are free.
inline RigidBodyProblem Going(double mass_kg, const Vector3& inertia, const std::vector<RigidFoot>& feet,
                              double distance_m, double duration_s, const std::vector<Step>& steps) {
  RigidBodyProblem problem;
  problem.mass_kg = mass_kg;
  problem.inertia_B = inertia.asDiagonal();
  problem.feet = feet;
  const Vector3 up = -feet.front().p_CF_nominal_B.z() * Vector3::UnitZ();
  problem.start.p_WC = up;
  problem.goal.p_WC = up + distance_m * Vector3::UnitX();
  problem.duration_s = duration_s;
  for (const Step& step : steps) {
    RigidStance stance;
    stance.foot = step.foot;
    stance.start_s = step.start_s;
    stance.end_s = step.end_s;
    stance.held = step.start_s == 0.0;
    stance.friction = 0.6;
    stance.X_WF.translation() =
        up + step.share * distance_m * Vector3::UnitX() + feet[static_cast<std::size_t>(step.foot)].p_CF_nominal_B;
    problem.stances.push_back(stance);
  }
  return problem;
}

/// One leg that stands, hops once for 0.25 s, and stands.
inline RigidBodyProblem Hopper(double distance_m = 0.3) {
  return Going(20.0, {1.2, 5.5, 6.0}, {PointFoot({0.0, 0.0, -0.58}, {0.25, 0.15, 0.2})}, distance_m, 1.25,
               {{0, 0.0, 0.5, 0.0}, {0, 0.75, 1.25, 1.0}});
}

/// Two feet that step in turn, with both on the ground between.
inline RigidBodyProblem Walker(double distance_m = 0.6) {
  const Vector3 box(0.25, 0.15, 0.15);
  return Going(20.0, {1.2, 5.5, 6.0}, {PointFoot({0.0, 0.2, -0.65}, box), PointFoot({0.0, -0.2, -0.65}, box)},
               distance_m, 1.9,
               {{0, 0.0, 0.3, 0.0}, {0, 0.55, 1.2, 0.5}, {0, 1.45, 1.9, 1.0}, {1, 0.0, 0.7, 0.0}, {1, 1.0, 1.9, 1.0}});
}

/// Four feet, diagonals in turn without any time between.
inline RigidBodyProblem Trotter(double distance_m = 0.5) {
  const Vector3 box(0.15, 0.10, 0.08);
  std::vector<RigidFoot> feet;
  for (const double x : {0.18, -0.18}) {
    for (const double y : {0.13, -0.13}) feet.push_back(PointFoot({x, y, -0.28}, box));
  }
  std::vector<Step> steps;
  for (int foot = 0; foot < 4; ++foot) {
    if (foot == 0 || foot == 3) {
      steps.insert(steps.end(), {{foot, 0.0, 0.2, 0.0}, {foot, 0.45, 0.7, 0.5}, {foot, 0.95, 1.4, 1.0}});
    } else {
      steps.insert(steps.end(), {{foot, 0.0, 0.45, 0.0}, {foot, 0.7, 0.95, 0.75}, {foot, 1.2, 1.4, 1.0}});
    }
  }
  return Going(12.0, {0.14, 0.36, 0.39}, feet, distance_m, 1.4, steps);
}

/// The walker with soles of four corners.
inline RigidBodyProblem SoledWalker(double distance_m = 0.6) {
  RigidBodyProblem problem = Walker(distance_m);
  for (RigidFoot& foot : problem.feet)
    foot.contacts_F = {{0.1, 0.04, 0.0}, {0.1, -0.04, 0.0}, {-0.06, -0.04, 0.0}, {-0.06, 0.04, 0.0}};
  return problem;
}

/// The trotter standing on all its feet, with free footholds.
inline RigidBodyProblem Stander() {
  RigidBodyProblem problem = Trotter(0.0);
  std::erase_if(problem.stances, [](const RigidStance& s) { return s.start_s > 0.0; });
  problem.duration_s = 0.4;
  for (RigidStance& stance : problem.stances) {
    stance.end_s = problem.duration_s;
    stance.held = false;
  }
  return problem;
}

/// Unknowns of a motionless stander whose foot forces vary. Their course over time does not depend on the nodes.
inline VectorX Wavering(const RigidBodyProblem& problem, const RigidBodyUnknowns& unknowns) {
  VectorX x = VectorX::Zero(unknowns.size());
  for (std::size_t i = 2; i < unknowns.nodes_s().size(); ++i)
    x.segment<3>(unknowns.ControlPoint(i)) = problem.start.p_WC;
  for (const BoundForce& force : unknowns.BoundForces()) {
    if (force.force.parts.size() != 1) continue;
    const double t = unknowns.nodes_s()[force.at_node], phase = static_cast<double>(force.stance);
    x.segment<3>(force.force.parts[0].start) =
        Vector3(0.02 * std::sin(7.0 * t), 0.03 * std::cos(9.0 * t + phase), 0.25 + 0.02 * std::sin(11.0 * t + phase));
  }
  return x;
}

/// Adds limbs that swing: a smooth angular momentum with its rate at `count` uniform times.
inline void AddLegMotion(RigidBodyProblem& problem, int count) {
  for (int k = 0; k < count; ++k) {
    const double t = problem.duration_s * k / (count - 1);
    problem.leg_momentum_W.emplace_back(0.05 * std::sin(9.0 * t), 0.08 * (1.0 - std::cos(7.0 * t)),
                                        -0.03 * std::sin(5.0 * t));
    problem.leg_torque_W.emplace_back(0.45 * std::cos(9.0 * t), 0.56 * std::sin(7.0 * t), -0.15 * std::cos(5.0 * t));
  }
}

/// Adds contacts that move during each stance, differently and not uniformly.
inline void AddRolling(RigidBodyProblem& problem) {
  double distance = 0.004;
  for (RigidStance& stance : problem.stances) {
    stance.moved_W = {
        Vector3::Zero(), {distance, 0.002, 0.0}, {2.5 * distance, -0.001, 0.0}, {3.0 * distance, 0.003, 0.0}};
    distance += 0.001;
  }
}

/// Adds motors at the start, middle and end of each stance, each weaker than the one before: two rows for each point,
/// one vertical and one oblique.
inline void AddMotors(RigidBodyProblem& problem, double most_n) {
  for (RigidStance& stance : problem.stances) {
    const std::size_t points = problem.feet[static_cast<std::size_t>(stance.foot)].contacts_F.size();
    for (const double share : {1.0, 0.8, 0.6}) {
      const auto n = static_cast<Eigen::Index>(points);
      MotorLimits limits{MatrixX::Zero(2 * n, 3 * n), VectorX::Constant(2 * n, -0.5 * share * most_n),
                         VectorX::Constant(2 * n, share * most_n)};
      for (Eigen::Index i = 0; i < n; ++i) {
        limits.by_force.block<1, 3>(2 * i, 3 * i) << 0.0, 0.0, 1.0;
        limits.by_force.block<1, 3>(2 * i + 1, 3 * i) << 1.0, -0.4 - 0.1 * static_cast<double>(i), 0.2;
      }
      stance.motors.push_back(limits);
    }
  }
}

}  // namespace gaitwright::rigid_bodies
