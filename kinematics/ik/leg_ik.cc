// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/ik/leg_ik.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>
#include <utility>

#include "kinematics/ik/damped_search.h"
#include "kinematics/ik/six_joint_form.h"
#include "kinematics/ik/three_joint_form.h"
#include "kinematics/spatial/rotation.h"

namespace gaitwright {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kExact = 1e-11;    // [m, rad] accepted error of a closed form
constexpr double kSlack = 1e-9;     // [rad] a position may exceed a limit by rounding
constexpr int kStarts = 100;        // starts of the damped search
constexpr int kFreeStarts = 20;     // starts of the damped search without limits, which has few local minima
constexpr double kStraight = 0.02;  // [rad] a knee that bends less has no side

double Beyond(double value, double lower, double upper) { return std::max({0.0, lower - value, value - upper}); }

/// The angle plus full turns: within the limits or nearest to them, then nearest to a guess.
double NearestTurn(double angle_rad, double lower, double upper, double guess) {
  const double nearest = angle_rad + kTurn * std::round((guess - angle_rad) / kTurn);
  double best = nearest;
  for (const double other : {nearest - kTurn, nearest + kTurn}) {
    if (Beyond(other, lower, upper) + kSlack < Beyond(best, lower, upper)) best = other;
  }
  return best;
}

const char* NameOf(LegIk::Method method) {
  return method == LegIk::Method::kThreeJoint ? "three-joint"
         : method == LegIk::Method::kSixJoint ? "six-joint"
                                              : "damped";
}

std::shared_ptr<const LegClosedForm> FitForm(const LegChain& chain, LegIk::Method method) {
  if (method == LegIk::Method::kThreeJoint) return FitThreeJointForm(chain);
  if (method == LegIk::Method::kSixJoint) return FitSixJointForm(chain);
  return nullptr;
}

LegIk::Method MethodOf(const RobotModel& model, int leg) {
  const LegChain chain(model, leg);
  for (const auto method : {LegIk::Method::kThreeJoint, LegIk::Method::kSixJoint}) {
    if (FitForm(chain, method)) return method;
  }
  return LegIk::Method::kDamped;
}

Vector6 PositionsOf(const LegChain& chain, const VectorX& coordinates) {
  Vector6 positions = Vector6::Zero();
  for (std::size_t i = 0; i < chain.links.size(); ++i) {
    const LegChain::Link& link = chain.links[i];
    positions[static_cast<Eigen::Index>(i)] = link.multiplier * coordinates[link.coordinate] + link.offset;
  }
  return positions;
}

VectorX CoordinatesOf(const LegChain& chain, const Vector6& positions) {
  VectorX coordinates(chain.num_coordinates());
  for (std::size_t i = 0; i < chain.links.size(); ++i) {
    const LegChain::Link& link = chain.links[i];
    coordinates[link.coordinate] = (positions[static_cast<Eigen::Index>(i)] - link.offset) / link.multiplier;
  }
  return coordinates;
}

}  // namespace

LegIk::LegIk(const RobotModel& model, int leg) : LegIk(model, leg, MethodOf(model, leg)) {}

LegIk::LegIk(const RobotModel& model, int leg, Method method) : chain_(model, leg), method_(method) {
  if (method == Method::kDamped) return;
  form_ = FitForm(chain_, method);
  if (!form_) {
    throw InvalidArgument(fmt::format("foot '{}': its leg of {} joints does not fit the IK method '{}'; use '{}'",
                                      chain_.foot_name, chain_.links.size(), NameOf(method),
                                      NameOf(MethodOf(model, leg))));
  }
  const Vector6 a = PositionsOf(chain_, chain_.lower), b = PositionsOf(chain_, chain_.upper);
  lower_ = a.cwiseMin(b);
  upper_ = a.cwiseMax(b);
  bend_ = WrapAngle(PositionsOf(chain_, chain_.standing)[form_->knee()] - form_->straight_rad());
  const Leg& described = model.legs[static_cast<std::size_t>(leg)];
  const bool same_knee = described.knee_joint == described.joints[static_cast<std::size_t>(form_->knee())];
  if (std::abs(bend_) < kStraight && same_knee) bend_ = described.knee_sign;
}

void LegIk::Check(const Pose& X_BF_target, const VectorX& guess) const {
  if (guess.size() != chain_.num_coordinates()) {
    throw InvalidArgument(fmt::format("foot '{}': the guess has {} joints, but the leg has {}", chain_.foot_name,
                                      guess.size(), chain_.num_coordinates()));
  }
  if (!guess.allFinite() || !X_BF_target.matrix().allFinite()) {
    throw InvalidArgument(
        fmt::format("foot '{}': the {} is not finite", chain_.foot_name, guess.allFinite() ? "target" : "guess"));
  }
}

Result<LegIk::Solution> LegIk::Solve(const Pose& X_BF_target, const VectorX& guess) const {
  Check(X_BF_target, guess);
  if (!form_) return SolveDamped(X_BF_target, guess);
  const Vector6 at = PositionsOf(chain_, guess);
  const LegBranches branches = form_->Branches(X_BF_target, at);
  if (branches.count == 0) {
    const ReachGap gap = form_->Gap(X_BF_target);
    if (gap.kind == ReachGap::Kind::kNone) return SolveDamped(X_BF_target, guess);
    return OutOfReach(gap);
  }
  const Choice choice = Choose(branches, at);
  Solution solution{CoordinatesOf(chain_, choice.positions), choice.branches, 0};
  if (choice.branches == 0) return JointLimit(solution.joints);
  solution.joints = solution.joints.cwiseMax(chain_.lower).cwiseMin(chain_.upper);
  if (Reaches(X_BF_target, solution.joints)) return solution;
  DampedSearch exact = DescendToPose(chain_, X_BF_target, chain_.lower, chain_.upper, solution.joints);
  if (!exact.converged) return SolveDamped(X_BF_target, guess);
  solution.joints = std::move(exact.coordinates);
  solution.iterations = exact.iterations;
  return solution;
}

std::optional<VectorX> LegIk::SolveNear(const Pose& X_BF_target, const VectorX& guess) const {
  if (form_) {
    Result<Solution> solution = Solve(X_BF_target, guess);
    return solution ? std::optional(std::move(solution->joints)) : std::nullopt;
  }
  Check(X_BF_target, guess);
  DampedSearch found = DescendToPose(chain_, X_BF_target, chain_.lower, chain_.upper, guess);
  return found.converged ? std::optional(std::move(found.coordinates)) : std::nullopt;
}

LegIk::Choice LegIk::Choose(const LegBranches& branches, const Vector6& guess) const {
  const double slack = kSlack + 10.0 * form_->misfit();
  const double guessed = WrapAngle(guess[form_->knee()] - form_->straight_rad());
  const double wanted = std::abs(guessed) > kStraight ? guessed : bend_;
  const auto n = static_cast<Eigen::Index>(chain_.links.size());
  Choice best;
  int within = 0;
  for (std::size_t b = 0; b < branches.count; ++b) {
    Choice choice{branches.positions[b], 0.0, 0.0, false, 0};
    choice.bends_back = WrapAngle(choice.positions[form_->knee()] - form_->straight_rad()) * wanted < 0.0;
    for (Eigen::Index i = 0; i < n; ++i) {
      double& position = choice.positions[i];
      position = NearestTurn(position, lower_[i], upper_[i], guess[i]);
      choice.violation = std::max(choice.violation, Beyond(position, lower_[i], upper_[i]));
      choice.cost += (position - guess[i]) * (position - guess[i]);
    }
    if (choice.violation <= slack) {
      choice.violation = 0.0;
      ++within;
    }
    const auto rank = [](const Choice& c) { return std::tuple(c.violation, c.bends_back, c.cost); };
    if (b == 0 || rank(choice) < rank(best)) best = choice;
  }
  best.branches = within;
  return best;
}

bool LegIk::Reaches(const Pose& X_BF_target, const VectorX& joints) const {
  const Pose X_BF = chain_.FootPose(joints);
  return (X_BF.translation() - X_BF_target.translation()).lpNorm<Eigen::Infinity>() < kExact &&
         (chain_.num_rows == 3 || (X_BF.linear() - X_BF_target.linear()).lpNorm<Eigen::Infinity>() < kExact);
}

VectorX LegIk::Unlimited(bool upper) const {
  VectorX limits = upper ? chain_.upper : chain_.lower;
  for (const LegChain::Link& link : chain_.links) {
    if (link.turns) limits[link.coordinate] = (upper ? 1.0 : -1.0) * std::numeric_limits<double>::infinity();
  }
  return limits;
}

Result<LegIk::Solution> LegIk::SolveDamped(const Pose& X_BF_target, const VectorX& guess) const {
  DampedSearch found = SearchPose(chain_, X_BF_target, chain_.lower, chain_.upper, guess, kStarts);
  if (found.converged) return Solution{std::move(found.coordinates), 1, found.iterations};
  DampedSearch free =
      SearchPose(chain_, X_BF_target, Unlimited(false), Unlimited(true), found.coordinates, kFreeStarts);
  if (!free.converged) return OutOfReach(GapOf(X_BF_target, free));
  for (const LegChain::Link& link : chain_.links) {
    if (!link.turns || std::abs(link.multiplier) != 1.0) continue;
    const int c = link.coordinate;
    free.coordinates[c] = NearestTurn(free.coordinates[c], chain_.lower[c], chain_.upper[c], guess[c]);
  }
  return JointLimit(free.coordinates);
}

ReachGap LegIk::Gap(const Pose& X_BF_target) const {
  if (form_) return form_->Gap(X_BF_target);
  return GapOf(X_BF_target,
               SearchPose(chain_, X_BF_target, Unlimited(false), Unlimited(true), chain_.standing, kFreeStarts));
}

ReachGap LegIk::GapOf(const Pose& X_BF_target, const DampedSearch& best) const {
  if (best.converged) return {};
  const Vector3& hip = chain_.links.front().point_B;
  const double wanted = (X_BF_target.translation() - hip).norm();
  const double reached = (chain_.FootPose(best.coordinates).translation() - hip).norm();
  const auto kind = best.distance_m < 1e-6 ? ReachGap::Kind::kTurned
                    : wanted > reached     ? ReachGap::Kind::kTooFar
                                           : ReachGap::Kind::kTooNear;
  return {kind, best.distance_m, best.angle_rad};
}

Failure LegIk::OutOfReach(const ReachGap& gap) const {
  const double mm = 1e3 * gap.distance_m;
  std::string how, hint = "bring base and foot closer: lower the base or shorten the step";
  switch (gap.kind) {
    case ReachGap::Kind::kTooNear:
      how = fmt::format("it is too near the hip by {:.1f} mm", mm);
      hint = "raise the base or lift the foot less";
      break;
    case ReachGap::Kind::kTooNearAxis:
      how = fmt::format("it is too near the axis of joint '{}' by {:.1f} mm", chain_.links.front().name, mm);
      hint = "raise the base or lift the foot less";
      break;
    case ReachGap::Kind::kTurned:
      how = fmt::format("it is rotated {:.1f} deg farther than the leg allows there", kDegrees * gap.angle_rad);
      hint = "rotate the foot less relative to the base";
      break;
    default:
      how = fmt::format("it is too far from the hip by {:.1f} mm", mm);
  }
  if (gap.kind != ReachGap::Kind::kTurned && gap.angle_rad > 1e-6) {
    how += fmt::format(" and rotated by {:.1f} deg", kDegrees * gap.angle_rad);
  }
  return {FailureKind::kInfeasible,
          FailureCode::kOutOfReach,
          "LegIk",
          fmt::format("foot '{}' cannot reach its target: {}", chain_.foot_name, how),
          {hint}};
}

Failure LegIk::JointLimit(const VectorX& joints) const {
  const LegChain::Link* worst = &chain_.links.front();
  double most = -1.0;
  for (const LegChain::Link& link : chain_.links) {
    const int c = link.coordinate;
    const double beyond = std::abs(link.multiplier) * Beyond(joints[c], chain_.lower[c], chain_.upper[c]);
    if (beyond <= most) continue;
    most = beyond;
    worst = &link;
  }
  const int c = worst->coordinate;
  const double limit = joints[c] < chain_.lower[c] ? chain_.lower[c] : chain_.upper[c];
  const auto position = [&](double coordinate) { return worst->multiplier * coordinate + worst->offset; };
  return {FailureKind::kInfeasible,
          FailureCode::kJointLimit,
          "LegIk",
          fmt::format("foot '{}' {} its target only with joint '{}' at {:.3f} {}, beyond its limit of {:.3f}",
                      chain_.foot_name, form_ ? "reaches" : "was found to reach", worst->name, position(joints[c]),
                      worst->turns ? "rad" : "m", position(limit)),
          {"move the foot's target, or the base, so that the leg bends within its limits"}};
}

}  // namespace gaitwright
