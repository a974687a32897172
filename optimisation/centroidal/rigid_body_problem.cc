// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/rigid_body_problem.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "kinematics/base/result.h"
#include "kinematics/trajectory/swing_curve.h"

namespace gaitwright {
namespace {

Vector3 Between(const std::vector<double>& time_s, const std::vector<Vector3>& values, double at_s) {
  const auto after = std::upper_bound(time_s.begin() + 1, time_s.end() - 1, at_s);
  const auto k = static_cast<std::size_t>(after - time_s.begin());
  const double u = std::clamp((at_s - time_s[k - 1]) / (time_s[k] - time_s[k - 1]), 0.0, 1.0);
  return (1.0 - u) * values[k - 1] + u * values[k];
}

void CheckMotors(const RigidStance& stance, std::size_t points, std::size_t number) {
  for (const MotorLimits& limits : stance.motors) {
    const Eigen::Index rows = limits.by_force.rows();
    if (limits.by_force.cols() != static_cast<Eigen::Index>(3 * points) || limits.lower.size() != rows ||
        limits.upper.size() != rows || !limits.by_force.allFinite() ||
        !(limits.lower.array() <= limits.upper.array()).all())
      throw InvalidArgument(
          fmt::format("rigid body: the motor limits of stance {} have wrong sizes, a value that is not finite, or a "
                      "lower limit above the upper one",
                      number));
  }
}

/// For `count` uniform places: index of the one before `place`, and the fraction of the distance to the next one.
std::pair<std::size_t, double> PartOf(double place, std::size_t count) {
  const double last = static_cast<double>(count) - 1.0, at = std::clamp(place, 0.0, last);
  const double before = std::min(std::floor(at), last - 1.0);
  return {static_cast<std::size_t>(before), at - before};
}

void CheckFinite(const RigidBodyState& state, const char* which) {
  if (!state.p_WC.allFinite() || !state.angles_rad.allFinite() || !state.v_WC.allFinite() || !state.w_WB_B.allFinite())
    throw InvalidArgument(fmt::format("rigid body: the {} state is not finite", which));
}

void CheckRests(const RigidBodyProblem& problem) {
  double since_s = 0.0;
  for (const RigidRest& rest : problem.rests) {
    if (!(rest.start_s > since_s && rest.end_s > rest.start_s && rest.end_s < problem.duration_s) ||
        !rest.p_WC.allFinite() || !rest.angles_rad.allFinite()) {
      throw InvalidArgument(
          fmt::format("rigid body: the rest from {} s to {} s must lie within the motion of {} s and after the rest "
                      "before it, and have a finite pose",
                      rest.start_s, rest.end_s, problem.duration_s));
    }
    since_s = rest.end_s;
  }
}

void CheckBody(const RigidBodyProblem& problem) {
  if (!(problem.mass_kg > 0.0) || !std::isfinite(problem.mass_kg))
    throw InvalidArgument(fmt::format("rigid body: the mass is {} kg; it must be finite and above 0", problem.mass_kg));
  if (!(problem.duration_s > 0.0) || !std::isfinite(problem.duration_s))
    throw InvalidArgument(
        fmt::format("rigid body: the duration is {} s; it must be finite and above 0", problem.duration_s));
  if (!(problem.rise_max_m_s >= 0.0) || !std::isfinite(problem.rise_max_m_s))
    throw InvalidArgument(fmt::format(
        "rigid body: the largest rising speed is {} m/s; it must be finite and not negative", problem.rise_max_m_s));
  const Vector3 principal = Eigen::SelfAdjointEigenSolver<Matrix3>(problem.inertia_B).eigenvalues();
  if (!problem.inertia_B.allFinite() || !problem.inertia_B.isApprox(problem.inertia_B.transpose()) ||
      !(principal.minCoeff() > 0.0) || principal.sum() < 2.0 * principal.maxCoeff() * (1.0 - 1e-9))
    throw InvalidArgument(
        "rigid body: the inertia matrix is not physical (not symmetric positive definite, or violates the triangle "
        "inequality)");
  CheckFinite(problem.start, "start");
  CheckFinite(problem.goal, "goal");
  CheckRests(problem);
}

void CheckRegion(const RigidStance& stance, std::size_t number) {
  const auto n = stance.region_F.size();
  if (n == 1 || n == 2)
    throw InvalidArgument(
        fmt::format("rigid body: stance {} has a region of {} corners; accepted: none, or three or more", number, n));
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2 edge = stance.region_F[(i + 1) % n] - stance.region_F[i];
    const Vector2 next = stance.region_F[(i + 2) % n] - stance.region_F[(i + 1) % n];
    if (!(edge.x() * next.y() - edge.y() * next.x() >= -1e-12))
      throw InvalidArgument(fmt::format("rigid body: the region of stance {} is not convex", number));
  }
}

void CheckPath(const BodyTrajectory& path) {
  const auto n = path.time_s.size();
  if (n == 0) return;
  if (n < 2 || path.p_WC.size() != n || path.angles_rad.size() != n ||
      std::adjacent_find(path.time_s.begin(), path.time_s.end(), std::greater_equal<>()) != path.time_s.end())
    throw InvalidArgument(
        "rigid body: the initial guess of the path needs rising times, with a position and angles for each");
}

void CheckLegMotion(const RigidBodyProblem& problem) {
  const auto finite = [](const Vector3& v) { return v.allFinite(); };
  const std::vector<Vector3>& momentum = problem.leg_momentum_W;
  const std::vector<Vector3>& torque = problem.leg_torque_W;
  if (momentum.size() == 1 || torque.size() != momentum.size() ||
      !std::all_of(momentum.begin(), momentum.end(), finite) || !std::all_of(torque.begin(), torque.end(), finite))
    throw InvalidArgument(
        "rigid body: the leg angular momentum needs two or more finite values with their rates, or none");
  for (const RigidStance& stance : problem.stances) {
    if (stance.moved_W.size() == 1 || !std::all_of(stance.moved_W.begin(), stance.moved_W.end(), finite))
      throw InvalidArgument("rigid body: moving contacts need two or more finite positions, or none");
  }
}

void CheckStances(const RigidBodyProblem& problem) {
  std::vector<double> free_from(problem.feet.size(), 0.0);
  bool starts = false, ends = false;
  for (std::size_t s = 0; s < problem.stances.size(); ++s) {
    const RigidStance& stance = problem.stances[s];
    if (stance.foot < 0 || stance.foot >= static_cast<int>(problem.feet.size())) {
      throw InvalidArgument(fmt::format("rigid body: stance {} names foot {}, but there are {} feet", s, stance.foot,
                                        problem.feet.size()));
    }
    double& from = free_from[static_cast<std::size_t>(stance.foot)];
    if (!(stance.start_s >= from && stance.end_s > stance.start_s && stance.end_s <= problem.duration_s)) {
      throw InvalidArgument(
          fmt::format("rigid body: stance {} lasts from {} to {} s, but foot {} is free only from {} to {} s", s,
                      stance.start_s, stance.end_s, stance.foot, from, problem.duration_s));
    }
    from = stance.end_s;
    if (!(stance.friction > 0.0))
      throw InvalidArgument(
          fmt::format("rigid body: stance {} has the friction coefficient {}; it must be above 0", s, stance.friction));
    if (!stance.X_WF.matrix().allFinite())
      throw InvalidArgument(fmt::format("rigid body: the foothold of stance {} is not finite", s));
    CheckRegion(stance, s);
    CheckMotors(stance, problem.feet[static_cast<std::size_t>(stance.foot)].contacts_F.size(), s);
    starts = starts || stance.start_s <= 0.0;
    ends = ends || stance.end_s >= problem.duration_s;
  }
  if (!starts || !ends)
    throw InvalidArgument(fmt::format("rigid body: no foot is on the ground at the {}", starts ? "end" : "start"));
}

void CheckShares(const RigidSwing& swing) {
  const auto outside = [](double share) { return !(share >= 0.0 && share <= 1.0); };
  const auto no_plane = [&](const SwingPlane& plane) {
    return outside(plane.share) || !plane.normal_W.allFinite() || !std::isfinite(plane.offset_m);
  };
  if (std::any_of(swing.shares.begin(), swing.shares.end(), outside) ||
      std::any_of(swing.planes.begin(), swing.planes.end(), no_plane))
    throw InvalidArgument(fmt::format(
        "rigid body: the swing from stance {} has a phase fraction outside 0 to 1, or a plane that is not finite",
        swing.from));
}

void CheckSwings(const RigidBodyProblem& problem) {
  for (const RigidSwing& swing : problem.swings) {
    const std::size_t n = problem.stances.size();
    if (swing.from >= n || swing.to >= n || problem.stances[swing.from].foot != problem.stances[swing.to].foot ||
        !(problem.stances[swing.to].start_s > problem.stances[swing.from].end_s) || !std::isfinite(swing.lift_m) ||
        !(swing.cruise >= 0.0 && swing.cruise < 1.0))
      throw InvalidArgument(
          fmt::format("rigid body: the swing from stance {} to {} needs two stances of one foot in order, a finite "
                      "lift and a cruise share of 0 to below 1",
                      swing.from, swing.to));
    if (swing.free && (swing.detour_W.empty() || swing.detour_W.size() % 2 != 0))
      throw InvalidArgument(
          fmt::format("rigid body: the free swing from stance {} has {} control points; accepted: an "
                      "even number",
                      swing.from, swing.detour_W.size()));
    CheckShares(swing);
  }
}

void CheckClearances(const RigidBodyProblem& problem) {
  constexpr double kUnit = 1e-6;
  for (const RigidClearance& clearance : problem.clearances) {
    if (!(clearance.time_s >= 0.0 && clearance.time_s <= problem.duration_s) || !clearance.p_CQ_B.allFinite() ||
        !std::isfinite(clearance.offset_m) || !(std::abs(clearance.normal_W.norm() - 1.0) < kUnit)) {
      throw InvalidArgument(
          fmt::format("rigid body: a clearance plane for a point of the {} at {} s does not fit a motion of {} s",
                      clearance.of, clearance.time_s, problem.duration_s));
    }
  }
}

}  // namespace

double RigidSwing::GoneAt(double share) const { return SmoothStep(share, cruise).value; }

Vector3 RigidSwing::OffAt(double share) const {
  const SwingCurve off{0.0, 1.0, Pose::Identity(), Pose::Identity(), lift_m, detour_W, cruise};
  return Evaluate(off, share).X_WF.translation();
}

Vector3 RigidStance::MovedAt(double time_s) const {
  if (moved_W.empty()) return Vector3::Zero();
  const auto steps = static_cast<double>(moved_W.size() - 1);
  const auto [k, u] = PartOf((time_s - start_s) / (end_s - start_s) * steps, moved_W.size());
  return (1.0 - u) * moved_W[k] + u * moved_W[k + 1];
}

const MotorLimits* RigidStance::MotorsAt(double time_s) const {
  if (motors.empty() || motors.front().lower.size() == 0) return nullptr;  // none has a limit
  const double last = static_cast<double>(motors.size()) - 1.0;
  const double at = std::clamp((time_s - start_s) / (end_s - start_s), 0.0, 1.0) * last;
  return &motors[static_cast<std::size_t>(std::lround(at))];
}

Vector3 BodyTrajectory::PlaceAt(double at_s) const { return Between(time_s, p_WC, at_s); }

Vector3 BodyTrajectory::AnglesAt(double at_s) const { return Between(time_s, angles_rad, at_s); }

LegMomentum::LegMomentum(const RigidBodyProblem& problem)
    : step_s_(problem.duration_s / std::max(1.0, static_cast<double>(problem.leg_momentum_W.size()) - 1.0)),
      momentum_W_(problem.leg_momentum_W),
      torque_W_(problem.leg_torque_W) {}

Vector3 LegMomentum::At(double time_s) const {
  if (momentum_W_.empty()) return Vector3::Zero();
  const auto [k, u] = PartOf(time_s / step_s_, momentum_W_.size());
  const double v = 1.0 - u;
  return v * v * (1.0 + 2.0 * u) * momentum_W_[k] + u * u * (1.0 + 2.0 * v) * momentum_W_[k + 1] +
         step_s_ * u * v * (v * torque_W_[k] - u * torque_W_[k + 1]);
}

Vector3 LegMomentum::RateAt(double time_s) const {
  if (momentum_W_.empty()) return Vector3::Zero();
  const auto [k, u] = PartOf(time_s / step_s_, momentum_W_.size());
  const double v = 1.0 - u;
  return 6.0 * u * v / step_s_ * (momentum_W_[k + 1] - momentum_W_[k]) + v * (1.0 - 3.0 * u) * torque_W_[k] +
         u * (3.0 * u - 2.0) * torque_W_[k + 1];
}

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
      throw InvalidArgument(fmt::format(
          "rigid body: foot {} cannot carry any load; it needs a contact point and a largest force above 0", f));
  }
  CheckStances(problem);
  CheckSwings(problem);
  CheckClearances(problem);
  CheckLegMotion(problem);
  CheckPath(problem.path);
}

}  // namespace gaitwright
