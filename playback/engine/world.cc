// SPDX-License-Identifier: BSD-3-Clause
#include "playback/engine/world.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/model/check_state.h"
#include "playback/engine/bounds_internal.h"

namespace gaitwright {
namespace {

void CheckSize(const VectorX& values, const char* what, int n) {
  if (values.size() != n) {
    throw InvalidArgument(fmt::format("the command has {} numbers for '{}'; {} are needed", values.size(), what, n));
  }
  if (!values.allFinite()) throw InvalidArgument(fmt::format("'{}' of the command is not finite", what));
}

}  // namespace

void CheckWorld(const RobotModel& model, const VectorX& q, const WorldOptions& wanted) {
  WorldOptions options = wanted;
  CheckOptions(options.Fields());
  if (q.size() != model.nq()) {
    throw InvalidArgument(
        fmt::format("the first configuration of '{}' has {} numbers; {} are needed", model.name, q.size(), model.nq()));
  }
  CheckState(model, q, VectorX::Zero(model.nv()));
  for (int dof : options.locked_dofs) {
    if (dof < 0 || dof >= model.num_dofs()) {
      throw InvalidArgument(fmt::format("locked joint {} does not exist; '{}' has joints 0 to {}", dof, model.name,
                                        model.num_dofs() - 1));
    }
  }
}

void CheckCommand(const JointCommand& command, int num_dofs) {
  CheckSize(command.q, "q", num_dofs);
  CheckSize(command.v, "v", num_dofs);
  CheckSize(command.tau_ff, "tau_ff", num_dofs);
  CheckSize(command.stiffness, "stiffness", num_dofs);
  CheckSize(command.damping, "damping", num_dofs);
  if (command.stiffness.size() > 0 && std::min(command.stiffness.minCoeff(), command.damping.minCoeff()) < 0.0) {
    throw InvalidArgument("the command has a negative stiffness or damping; 0 or more is accepted");
  }
}

std::vector<std::string> SolidNames(const Terrain& terrain, bool with_bumps) {
  std::vector<std::string> names;
  for (const Obstacle& obstacle : terrain.obstacles) names.push_back(obstacle.name);
  if (with_bumps) {
    names.emplace_back("ground");
    return names;
  }
  for (const TerrainPatch& patch : terrain.patches) names.push_back(patch.name);
  for (const HeightField& field : terrain.height_fields) names.push_back(field.name);
  for (std::string& name : names) {
    if (name.empty()) name = "ground";
  }
  return names;
}

double HighestDrop(const RobotModel& model, const VectorX& as_planned, const VectorX& now) {
  DynamicsScratch planned(model), actual(model);
  ForwardKinematics(model, as_planned, planned);
  ForwardKinematics(model, now, actual);
  double drop = 0.0;
  for (int foot = 0; foot < static_cast<int>(model.feet.size()); ++foot) {
    const std::vector<Vector3> wanted = ContactPoints(model, planned, foot), is = ContactPoints(model, actual, foot);
    for (std::size_t i = 0; i < is.size(); ++i) drop = std::max(drop, wanted[i].z() - is[i].z());
  }
  return drop;
}

Pose GroundTilt(const Terrain& terrain, const WorldOptions& options, const Vector2& start_W) {
  constexpr double kRadian = std::numbers::pi / 180.0;
  const Vector3 start(start_W.x(), start_W.y(), GroundAt(terrain, start_W).height_m);
  const double slope = options.ground_slope_deg * kRadian, uphill = options.ground_slope_direction_deg * kRadian;
  Pose X = Pose::Identity();
  const Vector3 axis = uphill == 0.0 ? Vector3::UnitY() : Vector3(-std::sin(uphill), std::cos(uphill), 0.0);
  X.linear() = Eigen::AngleAxisd(-slope, axis).toRotationMatrix();
  X.translation() = start - X.linear() * start;
  return X;
}

double FrictionOf(const Terrain& terrain, const WorldOptions& options, const Vector2& p_W) {
  return options.friction > 0.0 ? options.friction : GroundAt(terrain, p_W).friction;
}

bool IsPhysical(const World& world) {
  using engine::kMostForce, engine::kMostOfState, engine::Within;
  return Within(world.q(), kMostOfState) && Within(world.v(), kMostOfState) && Within(world.tau(), kMostForce) &&
         std::all_of(world.feet().begin(), world.feet().end(), [](const FootContact& foot) {
           return Within(foot.wrench.force_W, kMostForce) && Within(foot.wrench.moment_W, kMostForce);
         });
}

}  // namespace gaitwright
