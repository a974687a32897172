// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/robot_body.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/ik/leg_polytope.h"
#include "kinematics/model/actuator.h"
#include "kinematics/spatial/rotation.h"
#include "planning/paths/base_path.h"
#include "planning/plan/support_plane.h"

namespace gaitwright {
namespace {

/// Largest vertical force on a foot at the scratch's pose that the leg's motors hold [N].
double MostUpright(const RobotModel& model, const DynamicsScratch& scratch, int foot) {
  constexpr double kMost = 20.0;  // multiple of the weight; used if no motor limits the force
  const Foot& f = model.feet[static_cast<std::size_t>(foot)];
  MatrixX J = MatrixX::Zero(6, model.nv());
  PointJacobian(model, scratch, f.body, f.X_BF.translation(), J);
  double most = kMost * model.weight_n();
  for (int d = 0; d < model.num_dofs(); ++d) {
    const Actuator motor = ActuatorOf(model, d);
    const double arm = std::abs(motor.Effort(J.row(2).tail(model.num_dofs()).transpose()));
    if (arm > 1e-6) most = std::min(most, motor.effort_limit / arm);
  }
  return most;
}

RigidFoot RigidFootOf(const RobotModel& model, const DynamicsScratch& scratch, const StandingBody& body, int foot,
                      double reserve) {
  constexpr double kFarthest = 0.6;      // share of the leg length
  constexpr double kMarginInAir = 0.01;  // smaller margin, because no force acts on a foot in the air
  const Foot& described = model.feet[static_cast<std::size_t>(foot)];
  RigidFoot rigid;
  const Vector3 p_WC = CentreOfMass(model, scratch);
  rigid.p_CF_nominal_B = ContactFrame(model, scratch, foot).translation() - p_WC;
  if (described.has_sole()) {
    rigid.contacts_F.clear();
    for (const Vector2& corner : described.sole_F) rigid.contacts_F.emplace_back(corner.x(), corner.y(), 0.0);
  }
  rigid.radius_m = described.radius;
  rigid.force_max_n = MostUpright(model, scratch, foot);
  const double farthest = kFarthest * model.legs[static_cast<std::size_t>(foot)].length_m;
  // Shift of coordinates: from the controlled frame relative to the base, to the contact frame relative to the centre
  // of mass.
  const Vector3 shift = body.p_HC + described.radius * Vector3::UnitZ();
  const auto reach = [&](double kept, const Vector3& up_B) {
    LegWorkspace workspace(model, foot, kept);
    std::vector<WorkspaceSide> sides = LegPolytope(workspace, farthest, up_B);
    for (WorkspaceSide& side : sides) {
      side.normal = body.R_HB * side.normal;
      side.offset -= side.normal.dot(shift);
    }
    return sides;
  };
  rigid.workspace_B = reach(reserve, body.R_HB.transpose() * Vector3::UnitZ());
  rigid.workspace_in_air_B = reach(kMarginInAir, Vector3::Zero());
  return rigid;
}

/// Limits each foot to its side of the middle between the standing positions, so that feet do not collide.
void KeepApart(const RobotModel& model, std::vector<RigidFoot>& feet) {
  constexpr double kApart = 0.05;  // share of the leg length
  for (std::size_t i = 0; i < feet.size(); ++i) {
    for (std::size_t j = 0; j < feet.size(); ++j) {
      if (i == j) continue;
      const Vector3 a = feet[i].p_CF_nominal_B, b = feet[j].p_CF_nominal_B;
      Vector3 across(b.x() - a.x(), b.y() - a.y(), 0.0);
      const double margin = kApart * model.leg_length_m();
      if (across.norm() < 2.0 * margin) continue;
      across.normalize();
      const WorkspaceSide side{across, across.dot(0.5 * (a + b)) - margin};
      feet[i].workspace_B.push_back(side);
      feet[i].workspace_in_air_B.push_back(side);
    }
  }
}

RigidBodyState Standing(const StandingBody& body, const PlanarPose& at, double base_m) {
  RigidBodyState state;
  state.angles_rad.z() = at.yaw_rad;
  state.p_WC = Vector3(at.x_m, at.y_m, base_m) + YawRotation(at.yaw_rad) * (body.p_SB + body.p_HC);
  return state;
}

/// Final pose of the base: the goal, if its feet end near their standing positions there (the ground may shift
/// footholds); otherwise the pose above the feet.
PlanarPose EndOf(const RobotModel& model, const FootstepSkeleton& skeleton) {
  constexpr double kNear = 0.08;  // share of the leg length
  PlanarPose end = PoseAt(skeleton.path, skeleton.schedule.end_s());
  const Vector2 off(skeleton.goal.x_m - end.x_m, skeleton.goal.y_m - end.y_m);
  if (off.norm() > kNear * model.leg_length_m()) return end;
  end.x_m = skeleton.goal.x_m;
  end.y_m = skeleton.goal.y_m;
  return end;
}

/// Whether a foothold belongs to a stance in which all feet stand still.
bool StandsIn(const FootstepSkeleton& skeleton, const Foothold& foothold) {
  return std::any_of(skeleton.parts.begin(), skeleton.parts.end(), [&](const MotionPart& part) {
    return StandsStill(part.gait) && foothold.touchdown_s < part.end_s && foothold.liftoff_s > part.start_s;
  });
}

/// Time during which the body rests in an intermediate part that stands still: the part without the time to come to
/// rest after the feet, and the time to prepare for their next motion.
std::optional<ContactInterval> RestOf(const FootstepSkeleton& skeleton, const MotionPart& part) {
  constexpr double kLongest = 0.4, kShare = 0.4;  // [s], and share of the standing time
  const bool at_end = part.start_s <= skeleton.schedule.start_s() || part.end_s >= skeleton.schedule.end_s();
  if (at_end || !StandsStill(part.gait)) return std::nullopt;
  const double settling = std::min(kLongest, kShare * (part.end_s - part.start_s));
  return ContactInterval{part.start_s + settling, part.end_s - settling};
}

}  // namespace

Vector3 StandingCentreOfMass(const RobotModel& model) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  return CentreOfMass(model, scratch);
}

StandingBody BodyOf(const RobotModel& model, double reserve) {
  const VectorX standing = StandingConfiguration(model);
  DynamicsScratch scratch(model);
  ForwardKinematics(model, standing, scratch);
  StandingBody body;
  body.R_HB = BaseRotation(standing);
  body.p_HC = CentreOfMass(model, scratch) - standing.head<3>();
  body.inertia_H = LockedInertia(model, scratch);
  for (int f = 0; f < static_cast<int>(model.feet.size()); ++f)
    body.feet.push_back(RigidFootOf(model, scratch, body, f, reserve));
  KeepApart(model, body.feet);
  return body;
}

RigidBodyProblem ProblemOf(const RobotModel& model, const StandingBody& body, const Terrain& terrain,
                           const FootstepSkeleton& skeleton, const BodyPath& path) {
  constexpr double kPathStep = 0.05;  // [s]
  RigidBodyProblem problem;
  problem.mass_kg = model.total_mass_kg;
  problem.inertia_B = body.inertia_H;
  problem.feet = body.feet;
  const double start_s = skeleton.schedule.start_s();
  problem.duration_s = skeleton.schedule.end_s() - start_s;
  const auto at = [&](double time_s) {
    return Standing(body, PoseAt(skeleton.path, start_s + time_s),
                    model.standing_base_height_m + path.GroundAt(start_s + time_s).value);
  };
  problem.start = at(0.0);
  const double over_m = model.standing_base_height_m + path.GroundAt(skeleton.schedule.end_s()).value;
  problem.goal = Standing(body, EndOf(model, skeleton), over_m);
  const int steps = std::max(1, static_cast<int>(std::ceil(problem.duration_s / kPathStep)));
  for (int k = 0; k <= steps; ++k) {
    const double time_s = problem.duration_s * k / steps;
    problem.path.time_s.push_back(time_s);
    problem.path.p_WC.push_back(at(time_s).p_WC);
    problem.path.angles_rad.push_back(at(time_s).angles_rad);
  }
  problem.path.p_WC.back() = problem.goal.p_WC;
  problem.follows_yaw = true;
  for (const MotionPart& part : skeleton.parts) {
    if (const auto rest = RestOf(skeleton, part)) {
      const RigidBodyState still = at(0.5 * (rest->start_s + rest->end_s) - start_s);
      problem.rests.push_back({rest->start_s - start_s, rest->end_s - start_s, still.p_WC, still.angles_rad});
    }
  }
  const bool level = KindOfGround(terrain) == GroundKind::kFlat;
  for (const Foothold& foothold : skeleton.footsteps.footholds) {
    RigidStance stance;
    stance.foot = foothold.foot;
    stance.start_s = foothold.touchdown_s - start_s;
    stance.end_s = foothold.liftoff_s - start_s;
    stance.X_WF = foothold.X_WF;
    stance.friction = FrictionOf(terrain, foothold.patch);
    stance.held = !level || stance.start_s <= 0.0 || stance.end_s >= problem.duration_s || StandsIn(skeleton, foothold);
    problem.stances.push_back(stance);
  }
  return problem;
}

}  // namespace gaitwright
