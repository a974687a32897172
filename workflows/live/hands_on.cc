// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/live/hands_on.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "kinematics/base/result.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/dof_units.h"

namespace gaitwright {
namespace {

/// A spring that pulls hard where the robot is heavy, and never harder than twice its weight.
Vector3 SpringForce(const RobotModel& model, const Vector3& way_W) {
  constexpr double kPerLeg = 2.0, kMost = 2.0;  // weights by leg length, weights
  const Vector3 force = kPerLeg * model.weight_n() / model.leg_length_m() * way_W;
  const double most = kMost * model.weight_n();
  return force.norm() > most ? Vector3(most / force.norm() * force) : force;
}

}  // namespace

void HandsOn::Pull(int body, const Vector3& p_Body, const Vector3& to_W) {
  if (body < 0 || body >= static_cast<int>(model_.bodies.size()) || !p_Body.allFinite() || !to_W.allFinite())
    throw InvalidArgument(fmt::format("there is nothing to pull at body {}", body));
  pulled_ = Pulled{body, p_Body, to_W};
}

void HandsOn::LetGo() {
  pulled_.reset();
  force_W_.reset();
}

void HandsOn::Push(const Vector3& force_W, double until_s) {
  constexpr double kMost = 10.0;  // weights
  if (!(force_W.norm() <= kMost * model_.weight_n()))
    throw InvalidArgument(fmt::format("a push has {} weights at most", kMost));
  pushed_ = Pushed{force_W, until_s};
}

void HandsOn::Nudge(int dof, double by, double until_s) {
  constexpr double kMostTurn = 1.0, kMostShift = 0.3;
  if (dof < 0 || dof >= model_.num_dofs()) throw InvalidArgument(fmt::format("there is no joint {} to be moved", dof));
  const std::string unit = PositionUnit(model_, dof);
  const double most = unit == "m" ? kMostShift : kMostTurn;
  if (!(std::abs(by) <= most)) throw InvalidArgument(fmt::format("this joint is moved by {} {} at most", most, unit));
  nudged_ = Nudged{dof, by, until_s, {}};
}

void HandsOn::Off() {
  LetGo();
  pushed_.reset();
  nudged_.reset();
}

void HandsOn::Add(const Vector3& force_W) { force_W_ = force_W_.value_or(Vector3::Zero()) + force_W; }

/// Legs that stand are moved by torques alone: the joint is held by its own gains for so long.
void HandsOn::Apply(Nudged& nudged, const BulletWorld& world, const Gains& gains, JointCommand& command) {
  const int d = nudged.dof;
  if (!nudged.from) nudged.from = world.q()[7 + d];
  command.q[d] = *nudged.from + nudged.by;
  command.v[d] = 0.0;
  command.stiffness[d] = gains.stiffness[d];
  command.damping[d] = gains.damping[d];
}

void HandsOn::Apply(double time_s, const Gains& gains, BulletWorld& world, JointCommand& command) {
  force_W_.reset();
  if (nudged_ && time_s >= nudged_->until_s) nudged_.reset();
  if (nudged_) Apply(*nudged_, world, gains, command);
  if (pushed_ && time_s >= pushed_->until_s) pushed_.reset();
  if (pushed_) {
    world.PushBase(pushed_->force_W);
    Add(pushed_->force_W);
  }
  if (!pulled_) return;
  DynamicsScratch scratch(model_);
  ForwardKinematics(model_, world.q(), scratch);
  const auto body = static_cast<std::size_t>(pulled_->body);
  const Vector3 p_W = scratch.p_WB[body] + scratch.R_WB[body] * pulled_->p_Body;
  const Vector3 force_W = SpringForce(model_, pulled_->to_W - p_W);
  world.PushAt(pulled_->body, force_W, p_W);
  Add(force_W);
}

}  // namespace gaitwright
