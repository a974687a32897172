// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/can_walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/body_tree.h"
#include "kinematics/model/passive_joints.h"
#include "kinematics/spatial/dense_solvers.h"
#include "kinematics/stability/standing_width_internal.h"

namespace gaitwright {
namespace {

constexpr double kWeak = 0.02;  // smallest motion of a movable foot, in leg lengths per radian of its joints

Failure Cannot(FailureCode code, const std::string& message, const std::vector<Suggestion>& suggestions) {
  return {FailureKind::kInfeasible, code, "PlanFootsteps", message, suggestions};
}

/// Feet that are points at the origins of links, because no shape and no robot.yaml describes them.
std::vector<std::string> FeetWithoutShape(const RobotModel& model) {
  std::vector<std::string> names;
  for (const Foot& foot : model.feet) {
    const bool shaped = std::any_of(model.collision_shapes.begin(), model.collision_shapes.end(),
                                    [&](const Shape& shape) { return shape.body == foot.body; });
    if (!shaped && foot.type == FootType::kPoint) names.push_back(foot.name);
  }
  return names;
}

std::string FeetOf(const RobotModel& model) {
  std::vector<std::string> names;
  for (const Foot& foot : model.feet) names.push_back(foot.name);
  return QuotedList(names);
}

/// Why a robot that cannot stand still cannot walk either: only a biped can fall from foot to foot.
std::optional<Failure> LacksSupport(const RobotModel& model) {
  if (CanStandStill(model)) return std::nullopt;
  const std::vector<std::string> bare = FeetWithoutShape(model);
  if (bare.empty()) return model.legs.size() == 2 ? std::nullopt : ReasonCannotStand(model);
  std::string soles;
  for (const std::string& foot : bare)
    soles += fmt::format("{}{{link: '{}', sole_m: [[X, Y], ...]}}", soles.empty() ? "" : ", ", foot);
  return Cannot(
      FailureCode::kNoSupport,
      fmt::format("robot '{}' cannot stand still: its feet {} have neither collision nor visual geometry, so "
                  "each is a point without a sole",
                  model.name, QuotedList(bare)),
      {fmt::format("give the corners of each sole, in m in the link's frame, in robot.yaml: feet: [{}]", soles)});
}

/// The hip of a leg at joint positions zero, in the base frame O.
struct Hip {
  Vector3 p_O, axis_O;
};

/// Detects two legs on one side of the base with a common hip axis: they are halves of one leg with two motors at its
/// hip, joined at their ends. Other legs are never so close to each other.
std::optional<Failure> HasHalvesOfLegs(const RobotModel& model) {
  constexpr double kParallel = 0.995, kOffAxis = 0.05, kNear = 0.5;  // cosine; lengths in legs' lengths
  const std::vector<Pose> X_OB = BodyPoses(model, VectorX::Zero(model.num_dofs()));
  std::vector<std::optional<Hip>> hips;
  for (const Leg& leg : model.legs) {
    if (leg.hip_joint < 0) {
      hips.emplace_back();
      continue;
    }
    const auto hip = static_cast<std::size_t>(leg.hip_joint);
    hips.push_back(Hip{X_OB[hip + 1].translation(), X_OB[hip + 1].linear() * model.joints[hip].axis_J});
  }
  const double length = model.leg_length_m();
  for (std::size_t i = 0; i < hips.size(); ++i) {
    for (std::size_t j = i + 1; j < hips.size(); ++j) {
      if (!hips[i] || !hips[j] || hips[i]->p_O.y() * hips[j]->p_O.y() <= 0.0) continue;
      const Vector3 apart = hips[j]->p_O - hips[i]->p_O;
      if (std::abs(hips[i]->axis_O.dot(hips[j]->axis_O)) < kParallel || apart.norm() > kNear * length ||
          apart.cross(hips[i]->axis_O).norm() > kOffAxis * length)
        continue;
      return Cannot(
          FailureCode::kParallelLegs,
          fmt::format("legs '{}' and '{}' of robot '{}' share a hip axis on one side of the base: they seem to be two "
                      "halves of one leg, and the joint that closes their loop is missing in the description",
                      model.legs[i].name, model.legs[j].name, model.name),
          {"legs with closed loops are not supported; name one half of each leg in robot.yaml (feet), if its knee has "
           "a motor"});
    }
  }
  return std::nullopt;
}

/// Required motions of a foot: rows of its Jacobian in W, with lengths in leg lengths.
struct Demand {
  MatrixX J;
  std::vector<std::string> names;
};

enum class Walk { kForward, kSideways, kTurning };

const char* What(Walk walk) {
  return walk == Walk::kTurning ? "turn while it walks" : walk == Walk::kSideways ? "walk sideways" : "walk";
}

Demand DemandOf(const RobotModel& model, const DynamicsScratch& scratch, const Leg& leg, const std::vector<int>& dofs,
                Walk walk) {
  const Foot& foot = model.feet[static_cast<std::size_t>(leg.foot)];
  MatrixX whole = MatrixX::Zero(6, model.nv());
  PointJacobian(model, scratch, foot.body, foot.X_BF.translation(), whole);
  whole.topRows<3>() /= std::max(leg.length_m, 1e-6);
  Demand demand;
  demand.names = {"a joint to move its foot forward", "a joint to move its foot up"};
  std::vector<int> rows = {0, 2};
  if (walk != Walk::kForward) {
    rows.push_back(1);
    demand.names.emplace_back("a joint to move its foot sideways");
  }
  if (!foot.sole_F.empty()) {
    rows.push_back(4);
    demand.names.emplace_back("a joint to keep its sole level in pitch");
  }
  if (foot.type == FootType::kSole && walk != Walk::kForward) {
    rows.push_back(3);
    demand.names.emplace_back("a joint to keep its sole level in roll");
  }
  if (!foot.sole_F.empty() && walk == Walk::kTurning) {
    rows.push_back(5);
    demand.names.emplace_back("a joint to yaw its sole");
  }
  demand.J.resize(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(dofs.size()));
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t c = 0; c < dofs.size(); ++c)
      demand.J(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)) = whole(rows[r], 6 + dofs[c]);
  }
  return demand;
}

std::optional<Failure> LacksFreedom(const RobotModel& model, const DynamicsScratch& scratch, const Leg& leg,
                                    Walk walk) {
  std::vector<int> dofs;
  std::vector<std::string> names;
  for (const int j : leg.joints) {
    const int dof = model.joints[static_cast<std::size_t>(j)].dof;
    if (std::find(dofs.begin(), dofs.end(), dof) != dofs.end()) continue;
    dofs.push_back(dof);
    names.push_back(model.dof_names[static_cast<std::size_t>(dof)]);
  }
  const Demand demand = DemandOf(model, scratch, leg, dofs, walk);
  const LeftSingularVectors svd = LeftSingularVectorsOf(demand.J);
  const Eigen::Index needed = demand.J.rows();
  const VectorX& sigma = svd.values;
  const auto count = std::count_if(sigma.data(), sigma.data() + sigma.size(), [](double s) { return s >= kWeak; });
  if (count >= needed) return std::nullopt;
  Eigen::Index lacking = 0;
  svd.U.col(needed - 1).cwiseAbs().maxCoeff(&lacking);
  return Cannot(FailureCode::kFreedoms,
                fmt::format("leg '{}' cannot {}: it can move {} of {} degrees of freedom of its foot from the standing "
                            "posture, and it lacks {}; its joints are {}",
                            leg.name, What(walk), count, needed, demand.names[static_cast<std::size_t>(lacking)],
                            QuotedList(names)),
                {"give the leg such a joint, or free one that is fixed or mimics another",
                 "if the root link's axes do not point forward, left and up, set 'up' and 'ahead' in robot.yaml",
                 "if an arm was mistaken for a leg, name the feet in robot.yaml (feet: [...])"});
}

std::optional<Failure> LacksFreedom(const RobotModel& model, const DynamicsScratch& scratch, Walk walk) {
  for (const Leg& leg : model.legs) {
    if (auto lacks = LacksFreedom(model, scratch, leg, walk)) return lacks;
  }
  return std::nullopt;
}

std::optional<Failure> LacksMotor(const RobotModel& model) {
  const std::vector<int> leg_of = LegsOfDofs(model);
  std::vector<std::string> passive;
  int leg = -1;
  for (int dof = 0; dof < model.num_dofs(); ++dof) {
    const int own = leg_of[static_cast<std::size_t>(dof)];
    if (own < 0 || (leg >= 0 && own != leg) || !IsPassive(model, dof)) continue;
    leg = own;
    passive.push_back(model.dof_names[static_cast<std::size_t>(dof)]);
  }
  if (passive.empty()) return std::nullopt;
  return Cannot(
      FailureCode::kPassiveJoint,
      fmt::format(
          "leg '{}' cannot be held: {} {} no motor (effort limit 0), and the file names no spring or rod that holds {}",
          model.legs[static_cast<std::size_t>(leg)].name, QuotedList(passive), passive.size() == 1 ? "has" : "have",
          passive.size() == 1 ? "it" : "them"),
      {"if a stiff spring holds it, make the joint 'fixed'; if a motor drives it, give its torque (robot.yaml, limits: "
       "effort_nm, or transmissions if rods drive several joints)"});
}

DynamicsScratch Standing(const RobotModel& model) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  return scratch;
}

}  // namespace

std::optional<Failure> ReasonCannotWalk(const RobotModel& model) {
  if (auto halves = HasHalvesOfLegs(model)) return halves;
  if (auto lacks = LacksMotor(model)) return lacks;
  const DynamicsScratch scratch = Standing(model);
  if (auto lacks = LacksFreedom(model, scratch, Walk::kForward)) return lacks;
  return LacksSupport(model);
}

std::optional<Failure> ReasonCannotStand(const RobotModel& model) {
  if (CanStandStill(model)) return std::nullopt;
  return Cannot(FailureCode::kNoSupport,
                fmt::format("robot '{}' cannot stand still: its feet {} touch the ground in {}, on a strip {:.1f} mm "
                            "wide, but standing needs {:.1f} mm",
                            model.name, FeetOf(model), model.feet.size() == 2 ? "two points" : "points in line",
                            1e3 * StandingWidth(model), 1e3 * LeastStandingWidth(model)),
                {"give the robot soles (robot.yaml, feet: sole_m) or a third foot", "a gait without standing"});
}

std::optional<Failure> ReasonCannotSidestep(const RobotModel& model) {
  return LacksFreedom(model, Standing(model), Walk::kSideways);
}

std::optional<Failure> ReasonCannotTurn(const RobotModel& model) {
  return LacksFreedom(model, Standing(model), Walk::kTurning);
}

}  // namespace gaitwright
