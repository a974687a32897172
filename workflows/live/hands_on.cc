// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/live/hands_on.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "kinematics/base/result.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/dof_units.h"

namespace gaitwright {
namespace {

/// The force of a spring, limited to its largest force.
Vector3 ForceOf(const PullSpring& spring, const Vector3& stretch_W) {
  const Vector3 force = spring.n_per_m * stretch_W;
  return force.norm() > spring.most_n ? Vector3(spring.most_n / force.norm() * force) : force;
}

}  // namespace

PullSpring PullSpringFor(const RobotModel& model) {
  constexpr double kPerLeg = 2.0, kMost = 2.0;  // weights
  return {kPerLeg * model.weight_n() / model.leg_length_m(), kMost * model.weight_n()};
}

void HandsOn::Pull(HandId hand, int body, const Vector3& p_Body, const Vector3& by_W, bool along) {
  if (body < 0 || body >= static_cast<int>(model_.bodies.size()) || !p_Body.allFinite() || !by_W.allFinite())
    throw InvalidArgument(fmt::format("body {} cannot be pulled; accepted: bodies 0 to {}, at finite points", body,
                                      model_.bodies.size() - 1));
  auto grip = std::find_if(grips_.begin(), grips_.end(), [hand](const Grip& g) { return g.hand == hand; });
  if (grip == grips_.end()) {
    if (grips_.size() >= kMostGrips)
      throw InvalidArgument(fmt::format("at most {} pulls at a time are accepted", kMostGrips));
    grip = grips_.insert(grips_.end(), Grip{.hand = hand});
  }
  if (grip->body != body || grip->p_Body != p_Body) grip->from_W.reset();
  grip->body = body;
  grip->p_Body = p_Body;
  grip->by_W = by_W;
  grip->along = along;
}

void HandsOn::LetGo(HandId hand) {
  std::erase_if(grips_, [hand](const Grip& grip) { return grip.hand == hand; });
}

void HandsOn::GoAlong(const Vector3& displacement_W) {
  for (Grip& grip : grips_) {
    if (grip.along && grip.from_W) *grip.from_W += displacement_W;
  }
}

void HandsOn::Push(const Vector3& force_W, double until_s) {
  constexpr double kMost = 10.0;  // weights
  if (!(force_W.norm() <= kMost * model_.weight_n()))
    throw InvalidArgument(
        fmt::format("the push is {:.4g} N; at most {:.4g} N, {} times the robot's weight, is accepted", force_W.norm(),
                    kMost * model_.weight_n(), kMost));
  pushed_ = Pushed{force_W, until_s};
}

void HandsOn::Nudge(int dof, double by, double until_s) {
  constexpr double kMostTurn = 1.0, kMostShift = 0.3;
  if (dof < 0 || dof >= model_.num_dofs())
    throw InvalidArgument(fmt::format("joint {} does not exist; accepted: 0 to {}", dof, model_.num_dofs() - 1));
  const std::string unit = PositionUnit(model_, dof);
  const double most = unit == "m" ? kMostShift : kMostTurn;
  if (!(std::abs(by) <= most))
    throw InvalidArgument(fmt::format("joint {} is moved by {:.4g} {}; at most {} is accepted", dof, by, unit, most));
  nudged_ = Nudged{dof, by, until_s, {}};
}

void HandsOn::Off() {
  grips_.clear();
  pushed_.reset();
  nudged_.reset();
}

/// Offsets a joint command. Stance legs follow torques only, so the joint is held by its own gains during this time.
void HandsOn::Apply(Nudged& nudged, const World& world, const Gains& gains, JointCommand& command) {
  const int d = nudged.dof;
  if (!nudged.from) nudged.from = world.q()[7 + d];
  command.q[d] = *nudged.from + nudged.by;
  command.v[d] = 0.0;
  command.stiffness[d] = gains.stiffness[d];
  command.damping[d] = gains.damping[d];
}

void HandsOn::Apply(double time_s, const Gains& gains, World& world, JointCommand& command) {
  if (nudged_ && time_s >= nudged_->until_s) nudged_.reset();
  if (nudged_) Apply(*nudged_, world, gains, command);
  if (pushed_ && time_s >= pushed_->until_s) pushed_.reset();
  if (pushed_) world.PushBase(pushed_->force_W);
  if (grips_.empty()) return;
  DynamicsScratch scratch(model_);
  ForwardKinematics(model_, world.q(), scratch);
  for (Grip& grip : grips_) {
    const auto body = static_cast<std::size_t>(grip.body);
    const Vector3 p_W = scratch.p_WB[body] + scratch.R_WB[body] * grip.p_Body;
    if (!grip.from_W) grip.from_W = p_W;
    grip.force_W = ForceOf(spring_, *grip.from_W + grip.by_W - p_W);
    world.PushAt(grip.body, grip.force_W, p_W);
  }
}

}  // namespace gaitwright
