// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/rigid_body_problem.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

void CheckFinite(const RigidBodyState& state, const char* which) {
  if (!state.p_WC.allFinite() || !state.angles_rad.allFinite() || !state.v_WC.allFinite() || !state.w_WB_B.allFinite())
    throw InvalidArgument(fmt::format("rigid body: the {} state is not finite", which));
}

void CheckBody(const RigidBodyProblem& problem) {
  if (!(problem.mass_kg > 0.0) || !std::isfinite(problem.mass_kg))
    throw InvalidArgument(fmt::format("rigid body: a mass of {} kg", problem.mass_kg));
  if (!(problem.duration_s > 0.0) || !std::isfinite(problem.duration_s))
    throw InvalidArgument(fmt::format("rigid body: a duration of {} s", problem.duration_s));
  const Vector3 principal = Eigen::SelfAdjointEigenSolver<Matrix3>(problem.inertia_B).eigenvalues();
  if (!problem.inertia_B.allFinite() || !problem.inertia_B.isApprox(problem.inertia_B.transpose()) ||
      !(principal.minCoeff() > 0.0) || principal.sum() < 2.0 * principal.maxCoeff() * (1.0 - 1e-9))
    throw InvalidArgument("rigid body: the inertia is none that a body can have");
  CheckFinite(problem.start, "start");
  CheckFinite(problem.goal, "goal");
}

void CheckRegion(const RigidStance& stance, std::size_t number) {
  const auto n = stance.region_F.size();
  if (n == 1 || n == 2)
    throw InvalidArgument(fmt::format("rigid body: stance {} has a region of {} corners", number, n));
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2 edge = stance.region_F[(i + 1) % n] - stance.region_F[i];
    const Vector2 next = stance.region_F[(i + 2) % n] - stance.region_F[(i + 1) % n];
    if (!(edge.x() * next.y() - edge.y() * next.x() >= -1e-12))
      throw InvalidArgument(fmt::format("rigid body: the region of stance {} is not convex", number));
  }
}

void CheckWay(const BodyWay& way) {
  const auto n = way.time_s.size();
  if (n == 0) return;
  if (n < 2 || way.p_WC.size() != n || way.angles_rad.size() != n ||
      std::adjacent_find(way.time_s.begin(), way.time_s.end(), std::greater_equal<>()) != way.time_s.end())
    throw InvalidArgument(
        "rigid body: the first guess of its way needs a place and angles for each of its times in turn");
}

void CheckStances(const RigidBodyProblem& problem) {
  std::vector<double> free_from(problem.feet.size(), 0.0);
  bool starts = false, ends = false;
  for (std::size_t s = 0; s < problem.stances.size(); ++s) {
    const RigidStance& stance = problem.stances[s];
    if (stance.foot < 0 || stance.foot >= static_cast<int>(problem.feet.size())) {
      throw InvalidArgument(
          fmt::format("rigid body: stance {} names foot {} of {}", s, stance.foot, problem.feet.size()));
    }
    double& from = free_from[static_cast<std::size_t>(stance.foot)];
    if (!(stance.start_s >= from && stance.end_s > stance.start_s && stance.end_s <= problem.duration_s)) {
      throw InvalidArgument(fmt::format("rigid body: stance {} lasts from {} to {} s; foot {} is free from {} to {} s",
                                        s, stance.start_s, stance.end_s, stance.foot, from, problem.duration_s));
    }
    from = stance.end_s;
    if (!(stance.friction > 0.0)) throw InvalidArgument(fmt::format("rigid body: stance {} has no friction", s));
    if (!stance.X_WF.matrix().allFinite())
      throw InvalidArgument(fmt::format("rigid body: the foothold of stance {} is not finite", s));
    CheckRegion(stance, s);
    starts = starts || stance.start_s <= 0.0;
    ends = ends || stance.end_s >= problem.duration_s;
  }
  if (!starts || !ends)
    throw InvalidArgument(fmt::format("rigid body: no foot holds it at the {}", starts ? "end" : "start"));
}

}  // namespace

Matrix3 RotationOf(const Vector3& angles_rad) {
  return (Eigen::AngleAxisd(angles_rad.z(), Vector3::UnitZ()) * Eigen::AngleAxisd(angles_rad.y(), Vector3::UnitY()) *
          Eigen::AngleAxisd(angles_rad.x(), Vector3::UnitX()))
      .toRotationMatrix();
}

Matrix3 BodyRatesByAngleRates(const Vector3& angles_rad) {
  const double sr = std::sin(angles_rad.x()), cr = std::cos(angles_rad.x());
  const double sp = std::sin(angles_rad.y()), cp = std::cos(angles_rad.y());
  Matrix3 E;
  E << 1.0, 0.0, -sp,    //
      0.0, cr, sr * cp,  //
      0.0, -sr, cr * cp;
  return E;
}

std::vector<WorkspaceSide> BoxAbout(const Vector3& centre_B, const Vector3& half_size) {
  std::vector<WorkspaceSide> box;
  for (int axis = 0; axis < 3; ++axis) {
    box.push_back({Vector3::Unit(axis), centre_B[axis] + half_size[axis]});
    box.push_back({-Vector3::Unit(axis), half_size[axis] - centre_B[axis]});
  }
  return box;
}

void CheckRigidBodyProblem(const RigidBodyProblem& problem) {
  CheckBody(problem);
  for (std::size_t f = 0; f < problem.feet.size(); ++f) {
    if (problem.feet[f].contacts_F.empty() || !(problem.feet[f].force_max_n > 0.0))
      throw InvalidArgument(fmt::format("rigid body: foot {} can carry nothing", f));
  }
  CheckStances(problem);
  CheckWay(problem.way);
}

}  // namespace gaitwright
