// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/derive_legs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "kinematics/model/apply_legs.h"
#include "kinematics/model/body_tree.h"
#include "kinematics/model/check_feet.h"
#include "kinematics/model/find_feet.h"
#include "kinematics/model/leg_plane.h"
#include "kinematics/model/lowest_reach.h"
#include "kinematics/model/shape_support.h"
#include "kinematics/model/standing_posture.h"
#include "kinematics/model/yaml_line.h"

namespace gaitwright {
namespace {

constexpr std::size_t kMostLegs = 64;  // bits in a set of feet

/// A limb and the lowest height of its end [m], above the origin of the base or, if the roots of limbs are higher,
/// above those roots. The origin of a base such as `base_footprint` may be on or below the ground.
struct LimbThatReaches {
  double lowest = 0.0;
  std::vector<int> chain;
};

constexpr std::size_t kMostShared = 2;  // joints that legs may have in common, such as a waist

/// Number of joints at the start of two chains that are the same.
std::size_t SharedJoints(const std::vector<int>& one, const std::vector<int>& other) {
  const auto [end, unused] = std::mismatch(one.begin(), one.end(), other.begin(), other.end());
  return static_cast<std::size_t>(end - one.begin());
}

/// Height of the root of a limb in the base frame [m].
double RootHeight(const RobotModel& model, const LimbThatReaches& limb) {
  return model.joints[static_cast<std::size_t>(limb.chain.front())].X_PJ.translation().z();
}

/// Lowest point of the shapes of the base in the base frame [m]; minus infinity if the base has no shape.
double BottomOfBase(const RobotModel& model) {
  double bottom = std::numeric_limits<double>::infinity();
  for (const Shape& shape : model.collision_shapes) {
    if (shape.body != 0) continue;
    const Vector3 down_S = -shape.X_BS.linear().row(2).transpose();
    bottom = std::min(bottom, (shape.X_BS * SupportPoint(shape, down_S)).z());
  }
  return std::isfinite(bottom) ? bottom : -bottom;
}

/// Keeps the limbs that reach below the origin of the base. If fewer than two do, because the origin is below the whole
/// robot, keeps the limbs that reach far below the shapes of the base. Then `lowest` becomes relative to the root of
/// the longest limb, if this root is above the origin.
/// @param limbs  lowest first.
void KeepThoseThatReachTheGround(const RobotModel& model, std::vector<LimbThatReaches>& limbs) {
  constexpr double kBelow =
      0.6;  // share of a leg that is below the shapes of the base; the arms of a bust are beside them
  if (limbs.empty()) return;
  const double from_m = std::max(0.0, RootHeight(model, limbs.front())), bottom_m = BottomOfBase(model);
  const auto below_origin = [](const LimbThatReaches& limb) { return limb.lowest < 0.0; };
  const bool any = std::count_if(limbs.begin(), limbs.end(), below_origin) >= 2;
  std::erase_if(limbs, [&](const LimbThatReaches& limb) {
    if (any || !(bottom_m > 0.0)) return !below_origin(limb);
    return bottom_m - limb.lowest < kBelow * (RootHeight(model, limb) - limb.lowest);
  });
  for (LimbThatReaches& limb : limbs) limb.lowest -= from_m;
}

/// Limbs with many joints in common are branches of one limb, such as the fingers of a hand or the toes of a foot.
/// Keeps only the branch that reaches lowest.
void DropBranches(std::vector<LimbThatReaches>& limbs) {
  std::vector<LimbThatReaches> kept;
  for (LimbThatReaches& limb : limbs) {
    const bool branch = std::any_of(kept.begin(), kept.end(), [&](const LimbThatReaches& other) {
      return SharedJoints(limb.chain, other.chain) > kMostShared;
    });
    if (!branch) kept.push_back(std::move(limb));
  }
  limbs = std::move(kept);
}

/// Legs come in pairs of left and right. If there is such a pair, a limb without a counterpart that has more joints
/// than the pair is an arm, a neck or a tail, even if it reaches low.
void DropArms(const RobotModel& model, std::vector<LimbThatReaches>& limbs) {
  constexpr double kSame = 0.1;  // share of the reach
  const std::vector<Pose> X_OB = BodyPoses(model, VectorX::Zero(model.num_dofs()));
  const auto mirrored = [&](const LimbThatReaches& limb) {
    return std::any_of(limbs.begin(), limbs.end(), [&](const LimbThatReaches& other) {
      const std::size_t shared = SharedJoints(limb.chain, other.chain);  // a waist, which carries both legs
      if (other.chain.size() != limb.chain.size() || shared > kMostShared || shared == limb.chain.size()) return false;
      const auto root = [&](const std::vector<int>& chain) -> Vector3 {
        return X_OB[static_cast<std::size_t>(chain[shared]) + 1].translation();
      };
      const Vector3 own = root(limb.chain), away = root(other.chain) - Vector3(own.x(), -own.y(), own.z());
      return away.norm() < -kSame * limb.lowest;
    });
  };
  std::size_t paired = 0, joints = 0;
  for (const LimbThatReaches& limb : limbs) {
    if (!mirrored(limb)) continue;
    ++paired;
    joints = std::max(joints, limb.chain.size());
  }
  if (paired < 2) return;
  std::vector<LimbThatReaches> legs;
  for (const LimbThatReaches& limb : limbs) {
    if (mirrored(limb) || limb.chain.size() <= joints) legs.push_back(limb);
  }
  limbs = std::move(legs);
}

/// The failure for too few legs: the robot has no moving joint, its limbs have one joint each, or they end too high.
Failure NoLegs(const RobotModel& model, std::size_t found) {
  const std::string count = fmt::format("robot '{}': {} legs found", model.name, found);
  const Failure failure{FailureKind::kBadInput, FailureCode::kNoLegs, "LoadRobot", "", {}};
  const auto refused = [&](const std::string& why, const std::string& hint) {
    Failure of = failure;
    of.message = count + why;
    of.suggestions = {hint};
    return of;
  };
  const std::string name_feet = "name the feet in robot.yaml: feet: [{link: NAME}, ...]";
  if (model.joints.empty())
    return refused(
        ": its description has no moving joints, and a leg is a chain of moving joints",
        "make the joints of the legs revolute, continuous or prismatic in the URDF; a robot.yaml cannot do this");
  if (Limbs(model).empty())
    return refused(fmt::format(": each of its limbs has one joint, such as '{}', and a stepping leg needs at least two",
                               model.joints.front().name),
                   name_feet + " for a robot that only stands; walking needs more joints in the URDF");
  return refused("; two or more chains of joints that end at the ground are needed", name_feet);
}

/// The body of a foot that the user names.
int EndOf(const RobotModel& model, const FootOverride& foot) {
  try {
    return model.frames[static_cast<std::size_t>(model.FrameIndex(foot.link))].body;
  } catch (const InvalidArgument& error) {
    RefuseYamlLine(foot.line, error.what());
  }
}

/// Sorts legs by row from front to rear, and from left to right within a row.
void SortLegs(RobotModel& model) {
  const std::vector<Pose> X_OB = BodyPoses(model, model.standing_joints);
  std::vector<Vector3> at;
  double low_x = std::numeric_limits<double>::infinity(), high_x = -low_x;
  for (const Foot& foot : model.feet) {
    at.push_back((X_OB[static_cast<std::size_t>(foot.body)] * foot.X_BF).translation());
    low_x = std::min(low_x, at.back().x());
    high_x = std::max(high_x, at.back().x());
  }
  const double length = std::max(model.leg_length_m(), 1e-6);
  const auto row = [&](int i) {
    return high_x - low_x < 0.2 * length ? 0L
                                         : std::lround((high_x - at[static_cast<std::size_t>(i)].x()) / (0.3 * length));
  };
  std::vector<int> order(model.feet.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    if (row(a) != row(b)) return row(a) < row(b);
    return at[static_cast<std::size_t>(a)].y() > at[static_cast<std::size_t>(b)].y();
  });
  const auto feet = model.feet;
  const auto legs = model.legs;
  for (std::size_t i = 0; i < order.size(); ++i) {
    model.feet[i] = feet[static_cast<std::size_t>(order[i])];
    model.legs[i] = legs[static_cast<std::size_t>(order[i])];
    model.legs[i].foot = static_cast<int>(i);
  }
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = 0; j < order.size(); ++j) {
      const Vector3 a = at[static_cast<std::size_t>(order[i])], b = at[static_cast<std::size_t>(order[j])];
      if (i != j && std::abs(a.x() - b.x()) + std::abs(a.y() + b.y()) < 0.1 * length)
        model.legs[i].mirror = static_cast<int>(j);
    }
  }
}

}  // namespace

std::vector<int> EndBodies(const RobotModel& model) {
  std::vector<LimbThatReaches> limbs;
  for (const std::vector<int>& limb : Limbs(model)) limbs.push_back({LowestReach(model, limb), limb});
  std::stable_sort(limbs.begin(), limbs.end(), [](const auto& a, const auto& b) { return a.lowest < b.lowest; });
  KeepThoseThatReachTheGround(model, limbs);
  DropBranches(limbs);
  DropArms(model, limbs);
  constexpr double kShare = 0.25;  // a leg may end higher than the longest one by this share of its reach
  const double least = limbs.empty() ? 0.0 : limbs.front().lowest * (1.0 - kShare);
  std::erase_if(limbs, [least](const auto& limb) { return limb.lowest > least; });
  std::vector<int> ends;
  for (const LimbThatReaches& limb : limbs) ends.push_back(limb.chain.back() + 1);
  return ends;
}

Result<int> DeriveLegs(RobotModel& model, const LegChoices& given, const VectorX& standing) {
  const std::vector<FootOverride>& feet = given.feet;
  std::vector<int> ends;
  for (const FootOverride& foot : feet) {
    ends.push_back(EndOf(model, foot));
  }
  if (const auto failure = CheckNamedFeet(model, feet, ends)) return *failure;
  if (feet.empty()) ends = EndBodies(model);
  if (ends.size() < (feet.empty() ? 2U : 1U)) return NoLegs(model, ends.size());
  if (ends.size() > kMostLegs) {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kManyLegs,
                   "LoadRobot",
                   fmt::format("robot '{}' has {} legs; at most {} are accepted", model.name, ends.size(), kMostLegs),
                   {"name the walking legs in robot.yaml: feet: [{link: NAME}, ...]"}};
  }
  for (std::size_t i = 0; i < ends.size(); ++i) {
    Leg leg;
    leg.foot = static_cast<int>(i);
    leg.joints = ChainTo(model, ends[i]);
    model.feet.push_back(FindFoot(model, leg, given, feet.empty() ? nullptr : &feet[i], standing, ends.size() == 2));
    leg.name = model.feet.back().name;
    MeasureLeg(model, leg, model.feet.back());
    model.legs.push_back(leg);
  }
  ApplyLegs(given.legs, model);
  DeriveStanding(model, standing);
  SortLegs(model);
  if (given.mirror_pairs) ApplyMirrors(*given.mirror_pairs, model);
  return static_cast<int>(model.legs.size());
}

}  // namespace gaitwright
