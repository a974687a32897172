// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/check/check_parts_internal.h"
#include "kinematics/dynamics/contact_split.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/ik/leg_ik.h"
#include "kinematics/stability/polygon.h"

namespace gaitwright {
namespace {

constexpr double kTight = 0.8;  // share of a torque limit above which standing gives a finding

constexpr double kBeforeGear = 3.0;  // share that a better posture cannot explain

/// The legs that carry the robot.
struct HeldStance {
  std::vector<int> legs;
  std::string words;  ///< "on foot 'l_sole' alone"
};

/// The effort of each joint that holds the robot still [N m or N], compared with its limit.
struct HeldLoad {
  VectorX efforts;
  double worst = 0.0;  ///< largest share of a limit over all joints
};

Vector2 MiddleOfFoot(const RobotModel& model, const DynamicsScratch& scratch, int leg) {
  const Foot& foot = model.feet[static_cast<std::size_t>(leg)];
  return FramePose(scratch, foot.body, foot.X_BF).translation().head<2>();
}

/// Stances on all legs and, for an even number of legs, on every second leg around the robot: one of two legs, the
/// diagonals of four, the tripods of six.
std::vector<HeldStance> StancesOf(const RobotModel& model, const DynamicsScratch& scratch) {
  const auto n = static_cast<int>(model.legs.size());
  std::vector<int> all(static_cast<std::size_t>(n));
  std::iota(all.begin(), all.end(), 0);
  std::vector<HeldStance> stances = {{all, "on all its feet"}};
  if (n % 2 != 0) return stances;
  Vector2 middle = Vector2::Zero();
  for (const int leg : all) middle += MiddleOfFoot(model, scratch, leg) / n;
  const auto turn = [&](int leg) {
    const Vector2 p = MiddleOfFoot(model, scratch, leg) - middle;
    return std::atan2(p.y(), p.x());
  };
  std::vector<int> around = all;
  std::sort(around.begin(), around.end(), [&](int a, int b) { return turn(a) < turn(b); });
  for (int first = 0; first < 2; ++first) {
    HeldStance stance;
    for (int i = first; i < n; i += 2) stance.legs.push_back(around[static_cast<std::size_t>(i)]);
    std::sort(stance.legs.begin(), stance.legs.end());
    for (const int leg : stance.legs) {
      stance.words += stance.words.empty()        ? (n == 2 ? "on foot " : "on feet ")
                      : leg == stance.legs.back() ? " and "
                                                  : ", ";
      stance.words += "'" + model.feet[static_cast<std::size_t>(leg)].name + "'";
    }
    stance.words += " alone";
    stances.push_back(stance);
  }
  return stances;
}

/// The contact points of a stance. Needs ForwardKinematics.
std::vector<Vector3> ContactsOf(const RobotModel& model, const DynamicsScratch& scratch, const HeldStance& stance) {
  std::vector<Vector3> points;
  for (const int leg : stance.legs) {
    for (const Vector3& p : ContactPoints(model, scratch, leg)) points.push_back(p);
  }
  return points;
}

/// Joint efforts at q that hold the robot on level ground, with vertical contact forces of least square sum.
HeldLoad LoadAt(const RobotModel& model, const VectorX& q, const HeldStance& stance, DynamicsScratch& scratch) {
  ForwardKinematics(model, q, scratch);
  std::vector<ContactPoint> contacts;
  std::vector<int> bodies;
  for (const int leg : stance.legs) {
    for (const Vector3& p : ContactPoints(model, scratch, leg)) {
      contacts.push_back({.p_W = p});
      bodies.push_back(model.feet[static_cast<std::size_t>(leg)].body);
    }
  }
  ContactSplit split;
  ContactSplitter().Solve(contacts, {CentreOfMass(model, scratch), model.weight_n() * Vector3::UnitZ()}, split);
  VectorX tau = VectorX::Zero(model.nv());
  AddHeldWeight(model, scratch, 1.0, tau);
  for (std::size_t i = 0; i < contacts.size(); ++i)
    AddPointForce(model, scratch, bodies[i], contacts[i].p_W, -split.force_W[i], tau);
  HeldLoad load{tau.tail(model.num_dofs())};
  for (int dof = 0; dof < model.num_dofs(); ++dof) {
    if (model.dof_effort_limit(dof) > 0.0)
      load.worst = std::max(load.worst, std::abs(load.efforts[dof]) / model.dof_effort_limit(dof));
  }
  return load;
}

/// q with the base moved horizontally by `by_W` and the feet of the stance fixed. Nothing if the legs do not reach so
/// far. Needs ForwardKinematics at q.
std::optional<VectorX> MovedOver(const RobotModel& model, const DynamicsScratch& scratch, const VectorX& q,
                                 const HeldStance& stance, const Vector2& by_W) {
  VectorX moved = q;
  moved.head<2>() += by_W;
  Pose X_WB = Pose::Identity();
  X_WB.linear() = scratch.R_WB[0];
  X_WB.translation() = scratch.p_WB[0] + Vector3(by_W.x(), by_W.y(), 0.0);
  for (const int leg : stance.legs) {
    const Foot& foot = model.feet[static_cast<std::size_t>(leg)];
    const LegIk ik(model, leg);
    VectorX guess(static_cast<Eigen::Index>(ik.dofs().size()));
    for (Eigen::Index i = 0; i < guess.size(); ++i) guess[i] = q[7 + ik.dofs()[static_cast<std::size_t>(i)]];
    const Result<LegIk::Solution> solution = ik.Solve(X_WB.inverse() * FramePose(scratch, foot.body, foot.X_BF), guess);
    if (!solution) return std::nullopt;
    for (Eigen::Index i = 0; i < guess.size(); ++i)
      moved[7 + ik.dofs()[static_cast<std::size_t>(i)]] = solution->joints[i];
  }
  return moved;
}

/// q with the centre of mass above a point of the ground and the feet of a stance fixed. The masses of the legs move
/// too, so this is iterative.
std::optional<VectorX> CentredOver(const RobotModel& model, const VectorX& q, const HeldStance& stance,
                                   const Vector2& target_W, DynamicsScratch& scratch) {
  constexpr int kSteps = 5;
  constexpr double kNear = 1e-3;  // [m]
  VectorX at = q;
  for (int i = 0; i < kSteps; ++i) {
    ForwardKinematics(model, at, scratch);
    const Vector2 by = target_W - CentreOfMass(model, scratch).head<2>();
    if (by.norm() < kNear) return at;
    const std::optional<VectorX> moved = MovedOver(model, scratch, at, stance, by);
    if (!moved) return std::nullopt;
    at = *moved;
  }
  return at;
}

/// Candidate positions of the centre of mass above a stance: the nearest one to its current position, the middle, above
/// the ankle, and between the middle and each corner. A robot can shift its weight to the one with the least effort.
std::vector<Vector2> PlacesOver(const RobotModel& model, const DynamicsScratch& scratch, const HeldStance& stance) {
  std::vector<Vector2> points;
  for (const Vector3& p : ContactsOf(model, scratch, stance)) points.emplace_back(p.head<2>());
  const Polygon support = ConvexHull(points);
  const Vector2 nearest = NearestPoint(support, CentreOfMass(model, scratch).head<2>());
  std::vector<Vector2> places = {nearest};
  if (stance.legs.size() == 1) {
    const Leg& leg = model.legs[static_cast<std::size_t>(stance.legs.front())];
    places.push_back(Centroid(support));
    places.push_back(NearestPoint(support, scratch.p_WB[static_cast<std::size_t>(leg.joints.back()) + 1].head<2>()));
  }
  for (const Vector2& corner : support) {
    for (const double share : {0.1, 0.2, 0.4, 0.7}) places.emplace_back(nearest + share * (corner - nearest));
  }
  return places;
}

/// The smallest load of the joints for a stance; nothing if the robot cannot move its centre of mass above it.
std::optional<HeldLoad> LeastLoad(const RobotModel& model, const VectorX& standing, const HeldStance& stance,
                                  DynamicsScratch& scratch) {
  if (stance.legs.size() == model.legs.size()) return LoadAt(model, standing, stance, scratch);
  ForwardKinematics(model, standing, scratch);
  std::optional<HeldLoad> least;
  for (const Vector2& place : PlacesOver(model, scratch, stance)) {
    const std::optional<VectorX> q = CentredOver(model, standing, stance, place, scratch);
    if (!q) continue;
    HeldLoad load = LoadAt(model, *q, stance, scratch);
    if (!least || load.worst < least->worst) least = std::move(load);
  }
  return least;
}

}  // namespace

void CheckHolding(const RobotModel& model, std::vector<Finding>& findings) {
  DynamicsScratch scratch(model);
  const VectorX standing = StandingConfiguration(model);
  ForwardKinematics(model, standing, scratch);
  std::vector<double> worst(static_cast<std::size_t>(model.num_dofs()), 0.0);
  std::vector<std::optional<Finding>> of_dof(worst.size());
  for (const HeldStance& stance : StancesOf(model, scratch)) {
    const std::optional<HeldLoad> load = LeastLoad(model, standing, stance, scratch);
    if (!load) continue;
    for (int dof = 0; dof < model.num_dofs(); ++dof) {
      const auto d = static_cast<std::size_t>(dof);
      const Joint& joint = model.LeaderOf(dof);
      const double effort = std::abs(load->efforts[dof]), limit = model.dof_effort_limit(dof);
      const double share = effort / limit;
      if (!(limit > 0.0) || !(share > kTight) || share <= worst[d]) continue;
      worst[d] = share;
      const char* unit = joint.is_prismatic() ? "N" : "N m";
      of_dof[d] = Finding{
          share > 1.0 ? FindingLevel::kError : FindingLevel::kWarning, FailureCode::kWeakMotor,
          RobotPart{PartKind::kJoint, joint.name}, 0,
          fmt::format(
              "to hold the robot still {}, it needs at least {:.3g} {}, which is {:.0f} % of its limit of {:.3g} {}{}",
              stance.words, effort, unit, 100.0 * share, limit, unit,
              share > kBeforeGear ? "; the limit may be that of the motor before its gear" : "")};
    }
  }
  for (std::optional<Finding>& finding : of_dof) {
    if (finding) findings.push_back(std::move(*finding));
  }
}

}  // namespace gaitwright
