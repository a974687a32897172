// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/standing_posture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "kinematics/model/body_tree.h"
#include "kinematics/model/hang_limbs.h"
#include "kinematics/model/leg_plane.h"
#include "kinematics/spatial/dense_solvers.h"
#include "kinematics/spatial/rotation.h"

namespace gaitwright {
namespace {

constexpr double kCrouchedShare = 0.62;  // hip to foot over straight length, for legs without a sole
constexpr double kUprightShare = 0.92;   // hip to ankle over straight length, for legs with a sole

double Clamped(const RobotModel& model, int dof, double value) {
  return std::clamp(value, model.dof_lower(dof), std::max(model.dof_lower(dof), model.dof_upper(dof)));
}

/// Difference of a foot from its desired pose: position, and rotation if it has a sole.
/// @param chain  joints from the base to the foot.
VectorX FootError(const RobotModel& model, const std::vector<int>& chain, const Foot& foot, const VectorX& joints,
                  const Pose& wanted) {
  const Pose X_OF = PoseAlong(model, chain, joints) * foot.X_BF;
  VectorX error = VectorX::Zero(foot.sole_F.empty() ? 3 : 6);
  error.head<3>() = wanted.translation() - X_OF.translation();
  if (!foot.sole_F.empty()) error.tail<3>() = 0.2 * RotationLog(wanted.linear() * X_OF.linear().transpose());
  return error;
}

/// Damped least squares on the leg's coordinates with finite differences.
/// @return the norm of the remaining error.
double MoveFoot(const RobotModel& model, const Leg& leg, const Pose& wanted, VectorX& joints) {
  const Foot& foot = model.feet[static_cast<std::size_t>(leg.foot)];
  std::set<int> unique;
  for (const int joint : leg.joints) unique.insert(model.joints[static_cast<std::size_t>(joint)].dof);
  const std::vector<int> dofs(unique.begin(), unique.end());
  const auto n = static_cast<Eigen::Index>(dofs.size());
  constexpr int kMost = 200;  // along limits the error falls slowly
  const std::vector<int> chain = ChainTo(model, foot.body);
  VectorX error = FootError(model, chain, foot, joints, wanted);
  for (int iteration = 0; iteration < kMost && error.norm() >= 1e-12; ++iteration) {
    MatrixX J(error.size(), n);
    for (Eigen::Index c = 0; c < n; ++c) {
      constexpr double kStep = 1e-7;
      VectorX moved = joints;
      moved[dofs[static_cast<std::size_t>(c)]] += kStep;
      J.col(c) = (error - FootError(model, chain, foot, moved, wanted)) / kStep;
    }
    const MatrixX normal = J.transpose() * J + 1e-9 * MatrixX::Identity(n, n);
    const VectorX step = SolveSymmetric(normal, J.transpose() * error);
    const double scale = std::min(1.0, 0.2 / std::max(step.cwiseAbs().maxCoeff(), 1e-12));
    const VectorX before = joints;
    for (Eigen::Index c = 0; c < n; ++c) {
      const int dof = dofs[static_cast<std::size_t>(c)];
      joints[dof] = Clamped(model, dof, joints[dof] + scale * step[c]);
    }
    if (joints == before) break;
    error = FootError(model, chain, foot, joints, wanted);
  }
  return error.norm();
}

/// A leg with its plane, and the positions of hip and foot at joint positions zero in the base frame.
struct BentLeg {
  BentLeg(const RobotModel& robot, const Leg& which)
      : model(robot),
        leg(which),
        foot(robot.feet[static_cast<std::size_t>(which.foot)]),
        plane(FindLegPlane(robot, which, foot)) {
    const std::vector<Pose> zero = BodyPoses(model, VectorX::Zero(model.num_dofs()));
    X_OE = zero[static_cast<std::size_t>(foot.body)];
    p_OF = (X_OE * foot.X_BF).translation();
    p_OH = zero[static_cast<std::size_t>(leg.hip_joint + 1)].translation();
    ankle_height = has_sole() ? std::abs((X_OE.linear() * foot.X_BF.translation()).z()) : foot.radius;
  }
  bool has_sole() const { return !foot.sole_F.empty(); }
  bool has_knee() const { return plane.joints.size() >= 2; }

  const RobotModel& model;
  const Leg& leg;
  const Foot& foot;
  LegPlane plane;
  Pose X_OE;
  Vector3 p_OF, p_OH;
  double ankle_height = 0.0;
};

/// Desired position of a foot without a sole, at a distance from its hip. It is below the hip. The foot of a sprawling
/// leg is as far out from the upright axis as it is below its hip, so that this axis moves it as far as the others do.
Vector3 PlaceBelow(const BentLeg& bent, double distance) {
  const Vector3& normal = bent.plane.normal_O;
  Vector3 place = bent.p_OH + normal * normal.dot(bent.p_OF - bent.p_OH) - distance * Vector3::UnitZ();
  if (!bent.plane.sprawls) return place;
  const double hip_out = bent.plane.outward_O.dot(bent.p_OH - bent.plane.p_OY);
  double angle = 0.0;
  while (angle < 1.2 && hip_out + distance * std::sin(angle) < distance * std::cos(angle)) angle += 1e-3;
  place += distance * (std::sin(angle) * bent.plane.outward_O + (1.0 - std::cos(angle)) * Vector3::UnitZ());
  return place;
}

/// Guess for a leg that hangs straight down at zero: its joints bend so that the leg has this share of its straight
/// length; prismatic joints are at half their stroke.
VectorX BentGuess(const BentLeg& bent, double share, VectorX joints) {
  const RobotModel& model = bent.model;
  for (const int j : bent.leg.joints) {
    const Joint& joint = model.joints[static_cast<std::size_t>(j)];
    if (!joint.is_prismatic()) continue;
    joints[joint.dof] = Clamped(model, joint.dof, 0.5 * (model.dof_lower(joint.dof) + model.dof_upper(joint.dof)));
  }
  if (!bent.has_knee()) return joints;
  const std::vector<Pose> zero = BodyPoses(model, VectorX::Zero(model.num_dofs()));
  const auto axis = [&](int j) -> Vector3 {
    return zero[static_cast<std::size_t>(j + 1)].linear() * model.joints[static_cast<std::size_t>(j)].axis_J;
  };
  const double bend = std::acos(share);
  const double signs[] = {-1.0, 2.0, -1.0};
  for (std::size_t i = 0; i < bent.plane.joints.size() && i < 3; ++i) {
    const int j = bent.plane.joints[i];
    const int dof = model.joints[static_cast<std::size_t>(j)].dof;
    const double same = axis(j).dot(axis(bent.plane.joints[1])) > 0.0 ? 1.0 : -1.0;
    joints[dof] = Clamped(model, dof, signs[i] * bend * bent.leg.knee_sign * same);
  }
  return joints;
}

/// A grid of guesses within the limits of a leg's first two bending joints, used if the first guess fails.
std::vector<VectorX> MoreGuesses(const BentLeg& bent, const VectorX& guess) {
  constexpr int kPlaces = 4;
  std::vector<VectorX> guesses;
  const auto place = [&](std::size_t i, int k) {
    const int dof = bent.model.joints[static_cast<std::size_t>(bent.plane.joints[i])].dof;
    const double low = std::max(bent.model.dof_lower(dof), -std::numbers::pi);
    const double high = std::min(bent.model.dof_upper(dof), std::numbers::pi);
    return std::pair(dof, low + (k + 0.5) / kPlaces * (high - low));
  };
  for (int k = 0; bent.has_knee() && k < kPlaces * kPlaces; ++k) {
    guesses.push_back(guess);
    for (const auto& [dof, angle] : {place(0, k / kPlaces), place(1, k % kPlaces)}) guesses.back()[dof] = angle;
  }
  return guesses;
}

/// Removes whole turns from revolute joints; the search may add them.
void Unwind(const RobotModel& model, const Leg& leg, VectorX& joints) {
  for (const int j : leg.joints) {
    const Joint& joint = model.joints[static_cast<std::size_t>(j)];
    const double angle = WrapAngle(joints[joint.dof]);
    const bool within = angle >= model.dof_lower(joint.dof) && angle <= model.dof_upper(joint.dof);
    if (!joint.is_prismatic() && !joint.is_mimic && within) joints[joint.dof] = angle;
  }
}

/// Moves the foot to a pose with the knee bent to its side. If no guess does this, takes a result that reaches the pose
/// with the knee bent to the wrong side, otherwise the nearest result, preferably with the knee bent to its side.
void ReachFrom(const BentLeg& bent, const VectorX& guess, const Pose& wanted, VectorX& joints) {
  constexpr double kMissed = 1e-6;
  std::vector<VectorX> guesses = MoreGuesses(bent, guess);
  guesses.insert(guesses.begin(), guess);
  std::pair<bool, double> best{true, std::numeric_limits<double>::infinity()};
  for (const VectorX& start : guesses) {
    VectorX tried = start;
    const double left = MoveFoot(bent.model, bent.leg, wanted, tried);
    Unwind(bent.model, bent.leg, tried);
    const bool bends_back = KneeBend(bent.model, bent.leg, bent.foot, tried) * bent.leg.knee_sign < 0.0;
    const std::pair<bool, double> rank{bends_back && bent.has_knee(), left};
    const bool missed = left > kMissed && best.second <= kMissed;
    if (missed || (rank >= best && !(left <= kMissed && best.second > kMissed))) continue;
    best = rank;
    joints = tried;
    if (!rank.first && left <= kMissed) return;
  }
}

/// Bends hip, knee and ankle of a leg and moves the foot below its hip, or outward for a sprawling leg.
/// @param share  distance from hip to foot over the straight length.
void BendLegTo(const BentLeg& bent, double share, VectorX& joints) {
  const RobotModel& model = bent.model;
  const Leg& leg = bent.leg;
  const VectorX guess = BentGuess(bent, share, joints);
  Pose wanted = Pose::Identity();
  wanted.translation() = bent.p_OF;
  const double straight = leg.length_m - bent.ankle_height;
  const bool slides = std::any_of(leg.joints.begin(), leg.joints.end(), [&](int joint) {
    return model.joints[static_cast<std::size_t>(joint)].is_prismatic();
  });
  if (bent.has_sole() && bent.has_knee()) {
    wanted.translation().z() = bent.p_OH.z() - share * straight - bent.ankle_height;
  } else if (bent.has_knee()) {
    wanted.translation() = PlaceBelow(bent, share * straight);
  } else if (slides) {
    const std::vector<Pose> X_OB = BodyPoses(model, guess);
    const Vector3 p_OF = (X_OB[static_cast<std::size_t>(bent.foot.body)] * bent.foot.X_BF).translation();
    const Vector3& normal = bent.plane.normal_O;
    const Vector3 in_plane = p_OF - bent.p_OH - normal * normal.dot(p_OF - bent.p_OH);
    wanted.translation() = bent.has_sole() ? p_OF : PlaceBelow(bent, in_plane.norm());
  }
  ReachFrom(bent, guess, wanted, joints);
}

/// Range of motion that a leg's posture leaves for steps, from none (0) to enough (1). For a leg with a sole, it is the
/// remaining share of the ankle's range; for other legs, the distance of the bending joints from their limits.
double RoomOf(const BentLeg& bent, const VectorX& joints) {
  constexpr double kOfAnkle = 0.4, kOfBending = 0.3;  // share of the limit, [rad]
  double room = 1.0;
  for (std::size_t i = 0; i < bent.plane.joints.size() && i < 3; ++i) {
    const Joint& joint = bent.model.joints[static_cast<std::size_t>(bent.plane.joints[i])];
    const double q = joints[joint.dof], lower = bent.model.dof_lower(joint.dof),
                 upper = bent.model.dof_upper(joint.dof);
    if (bent.has_sole() && i == 2) {
      if (q < 0.0) room = std::min(room, (1.0 - q / lower) / kOfAnkle);
      if (q > 0.0) room = std::min(room, (1.0 - q / upper) / kOfAnkle);
    } else if (!bent.has_sole() && !joint.is_prismatic()) {
      room = std::min(room, std::min(q - lower, upper - q) / kOfBending);
    }
  }
  return room;
}

/// Bends a leg by the usual share for its kind of foot, or less if a joint would have little range left.
void BendLeg(const RobotModel& model, const Leg& leg, VectorX& joints) {
  constexpr double kStep = 0.01;
  const BentLeg bent(model, leg);
  const double straightest = bent.has_sole() ? 0.97 : 0.9;
  const VectorX before = joints;
  double most = -std::numeric_limits<double>::infinity();
  VectorX tried;
  for (double share = bent.has_sole() ? kUprightShare : kCrouchedShare; share < straightest && most < 1.0;
       share += kStep) {
    tried = before;
    BendLegTo(bent, share, tried);
    const double room = RoomOf(bent, tried);
    if (room <= most) continue;
    most = room;
    joints = tried;
  }
}

Vector3 CentreOfMassInBase(const RobotModel& model, const VectorX& joints) {
  const std::vector<Pose> X_OB = BodyPoses(model, joints);
  Vector3 moment = Vector3::Zero();
  for (std::size_t b = 0; b < X_OB.size(); ++b) moment += model.bodies[b].mass * (X_OB[b] * model.bodies[b].p_BC);
  return moment / model.total_mass_kg;
}

/// Moves all feet to the height of the highest one if legs of different lengths end at different heights. Changes
/// nothing if a leg cannot do it.
void LevelFeet(const RobotModel& model, VectorX& joints) {
  constexpr double kLevel = 1e-4, kMissed = 1e-6;  // [m]
  const std::vector<Pose> X_OB = BodyPoses(model, joints);
  std::vector<Pose> X_OF;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Foot& foot : model.feet) {
    X_OF.push_back(X_OB[static_cast<std::size_t>(foot.body)] * foot.X_BF);
    low = std::min(low, X_OF.back().translation().z() - foot.radius);
    high = std::max(high, X_OF.back().translation().z() - foot.radius);
  }
  if (high - low < kLevel) return;
  VectorX moved = joints;
  for (std::size_t i = 0; i < X_OF.size(); ++i) {
    X_OF[i].translation().z() = high + model.feet[i].radius;
    if (MoveFoot(model, model.legs[i], X_OF[i], moved) > kMissed) return;
  }
  joints = moved;
}

/// Largest distance of the centre of mass from the middle of the feet. On soles, it is half of the distance to their
/// edges, because the ankle torque is small if the centre of mass is near the ankles. Without soles, it is zero.
Vector2 BalanceSlack(const RobotModel& model) {
  Vector2 slack = Vector2::Constant(std::numeric_limits<double>::infinity());
  for (const Foot& foot : model.feet) {
    Vector2 half = Vector2::Zero();
    for (const Vector2& corner : foot.sole_F) half = half.cwiseMax(corner.cwiseAbs());
    slack = slack.cwiseMin(0.5 * half);
  }
  return slack;
}

/// Moves all feet by the same distance so that the centre of mass is above their middle. Changes nothing if a leg
/// cannot do it.
void Balance(const RobotModel& model, VectorX& joints) {
  constexpr int kPasses = 20;
  constexpr double kMissed = 1e-6, kBalanced = 1e-7;
  const Vector2 slack = BalanceSlack(model);
  for (int pass = 0; pass < kPasses; ++pass) {
    const std::vector<Pose> X_OB = BodyPoses(model, joints);
    std::vector<Pose> X_OF;
    Vector3 off = CentreOfMassInBase(model, joints);
    for (const Foot& foot : model.feet) {
      X_OF.push_back(X_OB[static_cast<std::size_t>(foot.body)] * foot.X_BF);
      off -= X_OF.back().translation() / static_cast<double>(model.feet.size());
    }
    const Vector2 kept = off.head<2>().cwiseMax(-slack).cwiseMin(slack);
    off -= Vector3(kept.x(), kept.y(), off.z());
    if (off.norm() < kBalanced) return;
    VectorX moved = joints;
    for (std::size_t i = 0; i < X_OF.size(); ++i) {
      X_OF[i].translation() += off;
      if (model.feet[i].sole_F.empty()) X_OF[i].linear().setIdentity();
      if (MoveFoot(model, model.legs[i], X_OF[i], moved) > kMissed) return;
    }
    joints = moved;
  }
}

bool IsLegGiven(const RobotModel& model, const VectorX& given) {
  return std::any_of(model.legs.begin(), model.legs.end(), [&](const Leg& leg) {
    return std::any_of(leg.joints.begin(), leg.joints.end(), [&](int joint) {
      return std::isfinite(given[model.joints[static_cast<std::size_t>(joint)].dof]);
    });
  });
}

}  // namespace

void DeriveStanding(RobotModel& model, const VectorX& given) {
  VectorX joints(model.num_dofs());
  for (int dof = 0; dof < model.num_dofs(); ++dof) joints[dof] = Clamped(model, dof, 0.0);
  for (const Leg& leg : model.legs) BendLeg(model, leg, joints);
  for (int dof = 0; dof < model.num_dofs(); ++dof) {
    if (std::isfinite(given[dof])) joints[dof] = given[dof];
  }
  const std::vector<std::string> hung = HangLimbs(model, given, joints);
  model.notes.insert(model.notes.end(), hung.begin(), hung.end());
  if (!IsLegGiven(model, given)) {
    LevelFeet(model, joints);
    Balance(model, joints);
  }
  model.standing_joints = joints;
  const std::vector<Pose> X_OB = BodyPoses(model, joints);
  double lowest = std::numeric_limits<double>::infinity();
  for (Foot& foot : model.feet) {
    const Pose& X_OE = X_OB[static_cast<std::size_t>(foot.body)];
    if (foot.sole_F.empty()) foot.X_BF.linear() = X_OE.linear().transpose();
    lowest = std::min(lowest, (X_OE * foot.X_BF).translation().z() - foot.radius);
  }
  model.standing_base_height_m = -lowest;
  constexpr double kFroude = 0.15;  // speed over sqrt(g l), of a calm walk
  model.nominal_speed_m_s = kFroude * std::sqrt(kGravity * model.leg_length_m());
}

}  // namespace gaitwright
