// SPDX-License-Identifier: BSD-3-Clause
#include "planning/tasks/lying.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "kinematics/collision/shape_extent.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/ik/whole_body_ik.h"
#include "planning/tasks/free_path.h"

namespace gaitwright {
namespace {

/// Inverse kinematics with the feet at their standing positions and the body above them.
class BodyOverFeet {
 public:
  explicit BodyOverFeet(const RobotModel& model)
      : model_(model), ik_(model), q_standing_(StandingConfiguration(model)), scratch_(model) {
    ForwardKinematics(model, q_standing_, scratch_);
    p_WC_standing_ = CentreOfMass(model, scratch_);
    target_.R_WB = BaseRotation(q_standing_);
    for (std::size_t f = 0; f < model.legs.size(); ++f) {
      const Pose X_WF = FramePose(scratch_, model.feet[f].body, model.feet[f].X_BF);
      FootTarget foot;
      foot.p_WF = X_WF.translation();
      foot.R_WF = foot.R_anchor = X_WF.linear();
      target_.feet.push_back(foot);
    }
  }

  /// Finds the shift of the centre of mass (in `key`) and q that bring the base's origin to p_WB. False if out of
  /// reach.
  bool Reach(const Vector3& p_WB, const VectorX& joints, PostureKey& key, VectorX& q) {
    constexpr int kShortMoves = 10;
    target_.posture.q = joints;
    target_.posture.v = target_.posture.a = VectorX::Zero(model_.num_dofs());
    const Vector3 from = q_standing_.head<3>(), displacement = p_WB - from;
    q = q_standing_;
    key.shift = displacement;
    if (Bring(p_WB, key.shift, q)) return true;
    q = q_standing_;
    key.shift.setZero();
    for (int i = 1; i <= kShortMoves; ++i) {
      key.shift += displacement / kShortMoves;
      if (!Bring(from + i * displacement / kShortMoves, key.shift, q)) return false;
    }
    return true;
  }

  const VectorX& standing() const { return q_standing_; }
  DynamicsScratch& scratch() { return scratch_; }

 private:
  /// Solves from an initial guess of the centre of mass's shift and of q.
  bool Bring(const Vector3& p_WB, Vector3& shift, VectorX& q) {
    constexpr int kPasses = 30;
    constexpr double kThere = 1e-9;  // [m]
    for (int pass = 0; pass < kPasses; ++pass) {
      target_.p_WC = p_WC_standing_ + shift;
      if (!ik_.SolvePosition(target_, q)) return false;
      const Vector3 off = p_WB - q.head<3>();
      if (off.norm() < kThere) return true;
      shift += off;
    }
    return false;
  }

  const RobotModel& model_;
  WholeBodyIk ik_;
  const VectorX q_standing_;
  DynamicsScratch scratch_;
  Vector3 p_WC_standing_;
  BodyTarget target_;
};

/// Smallest distance of a joint to its limits, as a share of its range; negative beyond a limit.
double RoomOf(const RobotModel& model, const VectorX& q, int& nearest) {
  double room = std::numeric_limits<double>::infinity();
  for (int d = 0; d < model.num_dofs(); ++d) {
    const double low = model.dof_lower(d), high = model.dof_upper(d);
    if (!std::isfinite(low) || !std::isfinite(high) || high <= low) continue;
    const double here = std::min(q[7 + d] - low, high - q[7 + d]) / (high - low);
    if (here >= room) continue;
    room = here;
    nearest = d;
  }
  return room;
}

/// Names a link other than a foot that would be below the ground on which the feet stand; empty if there is none.
std::string LinkInGround(const RobotModel& model, DynamicsScratch& scratch, const VectorX& q) {
  constexpr double kPressed = 3e-3;  // [m]
  ForwardKinematics(model, q, scratch);
  for (const Shape& shape : model.collision_shapes) {
    const bool of_foot = std::any_of(model.legs.begin(), model.legs.end(), [&](const Leg& leg) {
      return model.feet[static_cast<std::size_t>(leg.foot)].body == shape.body;
    });
    if (!of_foot && LowestPoint(scratch, shape).z() < -kPressed)
      return fmt::format("'{}' would be in the ground", shape.link);
  }
  return "";
}

double Along(const RobotModel& model) {
  double low = 0.0, high = 0.0;
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  for (std::size_t f = 0; f < model.legs.size(); ++f) {
    const double x = FramePose(scratch, model.feet[f].body, model.feet[f].X_BF).translation().x();
    low = std::min(low, x);
    high = std::max(high, x);
  }
  return high - low;
}

Failure CannotLie(const std::string& why) {
  return {FailureKind::kInfeasible, FailureCode::kLying, "FindLying", why, {}};
}

}  // namespace

Result<Lying> FindLying(const RobotModel& model, const VectorX& joints) {
  constexpr double kRoom = 0.03, kStep = 0.02, kFarthest = 0.6, kOver = 0.02;  // shares of range, leg's length
  if (model.feet.size() == model.legs.size())
    return CannotLie(fmt::format("robot '{}' has no flat surface under its body to lie on", model.name));
  BodyOverFeet body(model);
  PathCheck check(model, body.standing());
  const Foot& rest = model.feet[model.legs.size()];
  const double leg = model.leg_length_m();
  Vector3 p_WB = body.standing().head<3>();
  const double ground_m = -(BaseRotation(body.standing()) * rest.X_BF.translation()).z();
  Lying lying;
  lying.lying.joints = lying.over.joints = joints;
  double best = -std::numeric_limits<double>::infinity();
  int tightest = -1;
  std::string obstacle;  // the first one that was found
  const auto is_free = [&](const VectorX& q) {
    const auto pair = check.MeetingAt(q.tail(model.num_dofs()));
    const std::string met = pair ? fmt::format("'{}' and '{}' would collide", pair->link_a, pair->link_b)
                                 : LinkInGround(model, body.scratch(), q);
    if (obstacle.empty()) obstacle = met;
    return met.empty();
  };
  // Height of the body: 0 lying, 1 standing.
  const auto is_free_at = [&](double share, const Vector3& p_WL, PostureKey& key) {
    VectorX q;
    return body.Reach(p_WL + share * (body.standing().head<3>() - p_WL), joints, key, q) && is_free(q);
  };
  for (double distance = 0.0; distance <= kFarthest; distance += kStep) {
    for (const double side : {-1.0, 1.0}) {
      VectorX q;
      p_WB.x() = body.standing()[0] + side * distance * leg;
      p_WB.z() = ground_m;
      if (!body.Reach(p_WB, joints, lying.lying, q)) continue;
      int nearest = -1;
      const double room = RoomOf(model, q, nearest);
      if (room > best) {
        best = room;
        tightest = nearest;
      }
      if (room < kRoom || !is_free(q)) continue;
      const Vector3 p_over = p_WB + Vector3(0.0, 0.0, kOver * leg);
      PostureKey between = lying.over;
      if (is_free_at(0.2, p_over, between) && is_free_at(0.4, p_over, between) && is_free_at(0.6, p_over, between) &&
          is_free_at(0.8, p_over, between) && is_free_at(0.0, p_over, lying.over))
        return lying;
    }
  }
  std::string why = "its feet are too close below its hips";
  if (!obstacle.empty()) {
    why = obstacle;
  } else if (tightest >= 0) {
    why = fmt::format("joint '{}' limits the motion", model.dof_names[static_cast<std::size_t>(tightest)]);
  }
  return CannotLie(fmt::format("the legs of robot '{}' do not fold far enough to lie down: {}", model.name, why));
}

PostureMotion LieDown(const RobotModel& model, const PostureKey& from, const Lying& lying) {
  constexpr double kDown = 1.4, kTouch = 0.25, kStay = 0.5;  // [s]; kDown for a leg of 0.4 m
  constexpr double kFirmly = 0.7;  // share of the touch at constant speed, so that the body does not hover
  PostureMotion motion{"lie_down", {from, lying.over, lying.lying, lying.lying}};
  motion.keys[0].after_s = 0.0;
  motion.keys[1].after_s = kDown * std::sqrt(model.leg_length_m() / 0.4);
  motion.keys[2].after_s = kTouch;
  motion.keys[2].cruise = kFirmly;
  motion.keys[3].after_s = kStay;
  motion.rests = {{static_cast<int>(model.legs.size()), 2, 3}};
  return motion;
}

PostureMotion GetUp(const RobotModel& model, const PostureKey& standing, const Lying& lying, double tip_rad) {
  constexpr double kInit = 0.5, kLift = 1.0, kBalance = 0.6, kCruise = 0.5;  // [s]; kLift for a leg of 0.4 m
  constexpr double kRise = 0.03;  // share of the leg's length, so that hind legs need not fold further
  const double lift_s = kLift * std::sqrt(model.leg_length_m() / 0.4);
  PostureKey tipped = lying.over;
  tipped.turn_rad.y() = standing.turn_rad.y() - tip_rad;
  tipped.shift.z() += 0.5 * Along(model) * std::sin(tip_rad) + kRise * model.leg_length_m();
  PostureMotion motion{"stand_up", {lying.lying, lying.lying, lying.over, tipped, standing, standing}};
  const double times[] = {0.0, kInit, 0.5 * kInit, lift_s, lift_s, kBalance};
  for (std::size_t k = 0; k < motion.keys.size(); ++k) motion.keys[k].after_s = times[k];
  motion.keys[2].cruise = motion.keys[3].cruise = motion.keys[4].cruise = kCruise;
  motion.rests = {{static_cast<int>(model.legs.size()), 0, 1}};
  motion.sections = {{"init", 2, true}, {"lift front", 3, true}, {"lift rear", 4, true}, {"balance", 5, true}};
  return motion;
}

}  // namespace gaitwright
