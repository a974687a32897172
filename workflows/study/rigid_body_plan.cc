// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/rigid_body_plan.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "kinematics/base/version.h"
#include "kinematics/dynamics/contact_split.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/stability/polygon.h"
#include "kinematics/stability/zero_moment_point.h"
#include "kinematics/trajectory/swing_curve.h"
#include "optimisation/swing/free_swings.h"
#include "optimisation/swing/plan_swings.h"
#include "planning/audit/audit.h"
#include "planning/plan/robot_of_plan.h"
#include "planning/plan/sample_plan.h"
#include "planning/plan/support_plane.h"
#include "workflows/study/rigid_body_robot.h"

namespace gaitwright {
namespace {

/// The nearest patch whose plane contains a contact frame.
int PatchUnder(const Terrain& ground, const Pose& X_WF) {
  double nearest = std::numeric_limits<double>::infinity();
  int patch = -1;
  for (std::size_t i = 0; i < ground.patches.size(); ++i) {
    const TerrainPatch& of = ground.patches[i];
    const Vector3 p_T = of.X_WT.inverse() * X_WF.translation();
    const double beyond = of.outline_T.empty() ? 0.0 : std::max(0.0, -SignedDistance(of.outline_T, p_T.head<2>()));
    const double tilted = of.X_WT.linear().col(2).cross(X_WF.linear().col(2)).norm();
    const double off = beyond + std::abs(p_T.z()) + tilted;
    if (off >= nearest) continue;
    nearest = off;
    patch = static_cast<int>(i);
  }
  return patch;
}

/// Fills a plan from a motion of its problem, stage by stage.
class Converter {
 public:
  Converter(const RobotModel& robot, const Terrain& ground, const RigidBodyProblem& problem,
            const RigidBodyMotion& motion, double step_s)
      : robot_(robot), ground_(ground), problem_(problem), motion_(motion), scratch_(robot) {
    if (!problem.leg_momentum_W.empty())
      throw InvalidArgument("rigid body's plan: the problem has leg angular momentum, but its robot has massless legs");
    problem_foot_ = ProblemFeetOf(robot, problem);
    foot_of_.resize(problem_foot_.size());
    for (std::size_t f = 0; f < foot_of_.size(); ++f)
      foot_of_[static_cast<std::size_t>(problem_foot_[f])] = static_cast<int>(f);
    samples_ = Sample(motion, step_s);
    step_s_ = motion.duration_s() / static_cast<double>(samples_.size() - 1);
  }

  Result<MotionPlan> Run() {
    SetCommand();
    SetFootholds();
    const Result<std::vector<SwingTrajectory>> swings = Swings();
    if (!swings) return swings.failure();
    plan_.swings = *swings;
    SetRows();
    SetPendulum();
    return std::move(plan_);
  }

 private:
  double TimeOf(std::size_t row) const { return static_cast<double>(row) * step_s_; }
  const Foot& FootOf(const RigidStance& stance) const { return robot_.feet[FootIndex(stance)]; }
  std::size_t FootIndex(const RigidStance& stance) const {
    return static_cast<std::size_t>(foot_of_[static_cast<std::size_t>(stance.foot)]);
  }

  void SetCommand() {
    SetRobot(robot_, plan_);
    plan_.provenance = {Version(), "RigidBodyMotionPlan", {}, 0};
    plan_.terrain = ground_;
    const RigidBodyState &start = problem_.start, &goal = problem_.goal;
    plan_.goal = {goal.p_WC.x(), goal.p_WC.y(), goal.angles_rad.z()};
    const Vector2 along = (goal.p_WC - start.p_WC).head<2>();
    const double yaw = start.angles_rad.z(), c = std::cos(yaw), s = std::sin(yaw);
    WalkCommand command;
    command.extent = WalkCommand::Extent::kGoal;
    command.goal_x_m = c * along.x() + s * along.y();
    command.goal_y_m = c * along.y() - s * along.x();
    command.goal_yaw_rad = goal.angles_rad.z() - yaw;
    plan_.parts = {{{}, command, plan_.goal, 0.0, problem_.duration_s}};
  }

  /// Sets the schedule, as one cycle of a gait, and its footholds.
  void SetFootholds() {
    std::vector<std::vector<ContactInterval>> intervals(robot_.feet.size());
    Gait& gait = plan_.parts.front().gait;
    gait.name = "scheduled";
    gait.cycle_s = problem_.duration_s;
    gait.phase.assign(robot_.feet.size(), 0.0);
    gait.duty_factor.assign(robot_.feet.size(), 0.0);
    for (std::size_t i = 0; i < problem_.stances.size(); ++i) {
      const RigidStance& stance = problem_.stances[i];
      if (!stance.moved_W.empty())
        throw InvalidArgument("rigid body's plan: the contacts move, but its robot's feet do not roll");
      intervals[FootIndex(stance)].push_back({stance.start_s, stance.end_s});
      gait.duty_factor[FootIndex(stance)] += (stance.end_s - stance.start_s) / problem_.duration_s;
      Pose X_WF = motion_.X_WF[i] * MiddleOf(stance);
      plan_.footsteps.footholds.push_back({static_cast<int>(FootIndex(stance)), X_WF, Vector3::Zero(),
                                           PatchUnder(ground_, X_WF), stance.start_s, stance.end_s});
    }
    for (auto& of_foot : intervals)
      std::sort(of_foot.begin(), of_foot.end(), [](const auto& a, const auto& b) { return a.start_s < b.start_s; });
    plan_.schedule = ScheduleFromIntervals(intervals, 0.0, problem_.duration_s);
    SortFootholds(plan_.footsteps);
  }

  /// Transform from the frame of the problem's foot to that of the robot's foot, in the middle of its sole.
  Eigen::Translation3d MiddleOf(const RigidStance& stance) const {
    return Eigen::Translation3d(FootOf(stance).X_BF.translation());
  }

  Result<std::vector<SwingTrajectory>> Swings() const {
    SwingOptions options;
    double room_m = std::numeric_limits<double>::infinity();
    for (const RigidFoot& foot : problem_.feet) {
      const auto [low_B, high_B] = BoxOf(foot.workspace_B);
      room_m = std::min(room_m, high_B.z() - low_B.z());
    }
    options.height_m = kLift * room_m;
    options.clearance_m = kClearance * room_m;
    options.control_points = 14;
    options.samples = 40;
    FormerMotion former;
    former.reach = [&](int foot, double time_s) { return ReachAt(foot, time_s); };
    former.swings = PlannedSwings();
    return PlanSwings(robot_, ground_, plan_.footsteps, options, former);
  }

  /// The swings that were planned together with the motion.
  std::vector<SwingTrajectory> PlannedSwings() const {
    std::vector<SwingTrajectory> swings;
    for (std::size_t i = 0; i < motion_.detours_W.size(); ++i) {
      if (motion_.detours_W[i].empty()) continue;
      swings.push_back(SwingOf(problem_, motion_, i));
      SwingTrajectory& swing = swings.back();
      const Eigen::Translation3d middle = MiddleOf(problem_.stances[problem_.swings[i].from]);
      swing.foot = foot_of_[static_cast<std::size_t>(swing.foot)];
      swing.X_WF_start = swing.X_WF_start * middle;
      swing.X_WF_end = swing.X_WF_end * middle;
    }
    return swings;
  }

  /// Margin of a swing foot to the ends of its workspace; small near its footholds, which may be close to these ends.
  double MarginAt(int foot, double time_s) const {
    constexpr double kLeast = 5e-4, kMost = 3e-3, kWithin = 0.04;  // [m], [m], [s]
    double away_s = kWithin;
    for (const Foothold& foothold : plan_.footsteps.footholds) {
      if (foothold.foot != foot) continue;
      away_s = std::min({away_s, std::abs(time_s - foothold.touchdown_s), std::abs(time_s - foothold.liftoff_s)});
    }
    return kLeast + away_s / kWithin * (kMost - kLeast);
  }

  /// The workspace of a robot's foot at the nearest row, reduced by a margin.
  std::vector<ReachSide> ReachAt(int foot, double time_s) const {
    const auto row = static_cast<std::size_t>(std::lround(time_s / step_s_));
    const RigidBodySample& sample = samples_[std::min(row, samples_.size() - 1)];
    const auto of = static_cast<std::size_t>(problem_foot_[static_cast<std::size_t>(foot)]);
    return SidesInWorld(problem_.feet[of].workspace_B, sample.p_WC, RotationOf(sample.angles_rad),
                        -MarginAt(foot, time_s));
  }

  /// The motion of a foot at a time, and the index of its present or last foothold.
  FrameMotion FootMotion(int foot, double time_s) const {
    for (const SwingTrajectory& swing : plan_.swings) {
      if (swing.foot == foot && time_s > swing.start_s && time_s < swing.end_s) return Evaluate(CurveOf(swing), time_s);
    }
    const int at = FootholdAt(plan_.footsteps, foot, time_s);
    FrameMotion still;
    still.X_WF = plan_.footsteps.footholds[static_cast<std::size_t>(at)].X_WF;
    return still;
  }

  void SetRows() {
    plan_.whole_body.step_s = plan_.centroidal.step_s = step_s_;
    for (std::size_t k = 0; k < samples_.size(); ++k) AddRow(k);
  }

  void AddRow(std::size_t k) {
    const RigidBodySample& sample = samples_[k];
    const Matrix3 R_WB = RotationOf(sample.angles_rad);
    const Vector3& w_B = sample.w_WB_B;
    const Vector3 alpha_B =
        motion_.inertia_B.inverse() * (R_WB.transpose() * sample.torque_W - w_B.cross(motion_.inertia_B * w_B));
    VectorX q = VectorX::Zero(robot_.nq()), v = VectorX::Zero(robot_.nv()), a = v;
    q.head<3>() = sample.p_WC;
    q.segment<4>(3) = Quaternion(R_WB).coeffs();
    v << sample.v_WC, R_WB * w_B, v.tail(robot_.num_dofs());
    a << sample.a_WC, R_WB * alpha_B, a.tail(robot_.num_dofs());
    std::vector<FrameMotion> feet;
    for (int f = 0; f < static_cast<int>(robot_.feet.size()); ++f) {
      feet.push_back(FootMotion(f, TimeOf(k)));
      PlaceLeg(f, sample.p_WC, R_WB, feet.back(), q);
    }
    MoveLegs(feet, q, v, a);
    AddForces(k, feet, q, v, a);
  }

  /// Positions of the prismatic joints and rotations of a sole, in closed form: R_BF = Rz Ry Rx.
  void PlaceLeg(int foot, const Vector3& p_WC, const Matrix3& R_WB, const FrameMotion& motion, VectorX& q) const {
    const Leg& leg = robot_.legs[static_cast<std::size_t>(foot)];
    const Foot& of_foot = robot_.feet[static_cast<std::size_t>(foot)];
    const auto joint = [&](std::size_t i) -> const Joint& {
      return robot_.joints[static_cast<std::size_t>(leg.joints[i])];
    };
    const auto value = [&](std::size_t i) -> double& { return q[7 + joint(i).dof]; };
    Vector3 link_W = motion.X_WF.translation();  // origin of the foot's link
    if (leg.joints.size() > 3) {
      const Matrix3 R = R_WB.transpose() * motion.X_WF.linear();
      link_W -= motion.X_WF.linear() * of_foot.X_BF.translation();
      value(3) = std::atan2(R(1, 0), R(0, 0));
      value(4) = std::asin(std::clamp(-R(2, 0), -1.0, 1.0));
      value(5) = std::atan2(R(2, 1), R(2, 2));
    }
    Vector3 slides = R_WB.transpose() * (link_W - p_WC);
    for (std::size_t i = 0; i < 3; ++i) slides -= joint(i).X_PJ.translation();
    for (std::size_t i = 0; i < 3; ++i) value(i) = slides[static_cast<Eigen::Index>(i)];
  }

  /// Joint rates of the legs for the given motion of the feet.
  void MoveLegs(const std::vector<FrameMotion>& feet, const VectorX& q, VectorX& v, VectorX& a) {
    ForwardKinematics(robot_, q, scratch_);
    std::vector<MatrixX> J(feet.size(), MatrixX(6, robot_.nv()));
    const auto each = [&](const auto& solve) {
      for (std::size_t f = 0; f < feet.size(); ++f) {
        const std::vector<int>& joints = robot_.legs[f].joints;
        const auto n = static_cast<Eigen::Index>(joints.size());
        MatrixX own(n, n);
        for (Eigen::Index i = 0; i < n; ++i)
          own.col(i) =
              J[f].col(6 + robot_.joints[static_cast<std::size_t>(joints[static_cast<std::size_t>(i)])].dof).head(n);
        solve(f, n, own.partialPivLu());
      }
    };
    const auto set = [&](std::size_t f, const VectorX& rates, VectorX& to) {
      for (std::size_t i = 0; i < robot_.legs[f].joints.size(); ++i)
        to[6 + robot_.joints[static_cast<std::size_t>(robot_.legs[f].joints[i])].dof] =
            rates[static_cast<Eigen::Index>(i)];
    };
    for (std::size_t f = 0; f < feet.size(); ++f)
      PointJacobian(robot_, scratch_, robot_.feet[f].body, robot_.feet[f].X_BF.translation(), J[f]);
    each([&](std::size_t f, Eigen::Index n, const auto& own) {
      Vector6 wanted;
      wanted << feet[f].v_WF, feet[f].w_WF;
      wanted -= J[f].leftCols<6>() * v.head<6>();
      set(f, own.solve(VectorX(wanted.head(n))), v);
    });
    ForwardVelocities(robot_, q, v, scratch_);
    each([&](std::size_t f, Eigen::Index n, const auto& own) {
      Vector6 wanted;
      wanted << feet[f].a_WF, feet[f].alpha_WF;
      wanted -= J[f].leftCols<6>() * a.head<6>() +
                PointBiasAcceleration(scratch_, robot_.feet[f].body, robot_.feet[f].X_BF.translation());
      set(f, own.solve(VectorX(wanted.head(n))), a);
    });
  }

  /// Adds the motion's contact forces, the joint torques and the centroidal row.
  void AddForces(std::size_t k, const std::vector<FrameMotion>& feet, const VectorX& q, const VectorX& v,
                 const VectorX& a) {
    const RigidBodySample& sample = samples_[k];
    VectorX tau;
    InverseDynamics(robot_, q, v, a, scratch_, tau);
    ContactsByFoot points(feet.size());
    for (std::size_t f = 0; f < feet.size(); ++f) points[f] = ContactPoints(robot_.feet[f], feet[f].X_WF);
    const PointWrench needed{scratch_.p_WB[0], tau.head<3>(), tau.segment<3>(3)};
    std::vector<ContactWrench> wrenches(feet.size());
    const auto& forces = motion_.intervals[sample.interval].forces;
    for (std::size_t i = 0; i < forces.size(); ++i) {
      const std::size_t f = FootIndex(problem_.stances[forces[i].stance]);
      wrenches[f].force_W += sample.force_W[i];
      wrenches[f].moment_W += (forces[i].p_W - feet[f].X_WF.translation()).cross(sample.force_W[i]);
      AddPointForce(robot_, scratch_, robot_.feet[f].body, forces[i].p_W, -sample.force_W[i], tau);
    }
    plan_.whole_body.q.push_back(q);
    plan_.whole_body.v.push_back(v);
    plan_.whole_body.a.push_back(a);
    plan_.whole_body.tau.push_back(tau.tail(robot_.num_dofs()));
    plan_.whole_body.wrenches.push_back(std::move(wrenches));
    plan_.centroidal.p_WC.push_back(sample.p_WC);
    plan_.centroidal.v_WC.push_back(sample.v_WC);
    plan_.centroidal.a_WC.push_back(sample.a_WC);
    plan_.centroidal.p_WZ.push_back(ZmpOf(k, needed, points));
  }

  /// The ZMP; with almost no contact force it is undefined, and the last value is kept.
  Vector2 ZmpOf(std::size_t k, const PointWrench& needed, const ContactsByFoot& points) const {
    const GroundPlane plane = SupportPlaneAt(plan_.schedule, TimeOf(k), points);
    const double least = kPresses * robot_.weight_n(), upright = needed.force_W.z();
    if (upright < least || upright - plane.slope.dot(needed.force_W.head<2>()) < least)
      return plan_.centroidal.p_WZ.empty() ? Vector2(samples_[k].p_WC.head<2>()) : plan_.centroidal.p_WZ.back();
    return ZeroMomentPoint(needed.p_W, needed.force_W, needed.moment_W, plane).head<2>();
  }

  /// Sets the pendulum height to the mean height of the motion above the plane through all footholds; a swing foot
  /// counts at its position on the straight line between its footholds.
  void SetPendulum() {
    double height = 0.0;
    for (std::size_t k = 0; k < samples_.size(); ++k) {
      ContactsByFoot places(robot_.feet.size());
      for (std::size_t f = 0; f < places.size(); ++f)
        places[f].push_back(StraightPlace(static_cast<int>(f), TimeOf(k)));
      const GroundPlane plane = PlaneThrough(places, AllFeet(static_cast<int>(places.size())));
      height += samples_[k].p_WC.z() - plane.HeightAt(samples_[k].p_WC.head<2>());
    }
    plan_.centroidal.omega_rad_s = std::sqrt(kGravity * static_cast<double>(samples_.size()) / height);
  }

  Vector3 StraightPlace(int foot, double time_s) const {
    for (const SwingTrajectory& swing : plan_.swings) {
      if (swing.foot != foot || time_s <= swing.start_s || time_s >= swing.end_s) continue;
      const Vector3 &from = swing.X_WF_start.translation(), &to = swing.X_WF_end.translation();
      return from + (time_s - swing.start_s) / (swing.end_s - swing.start_s) * (to - from);
    }
    const int at = FootholdAt(plan_.footsteps, foot, time_s);
    return plan_.footsteps.footholds[static_cast<std::size_t>(at)].X_WF.translation();
  }

  static constexpr double kLift = 0.25, kClearance = 0.05;  // shares of the height of a workspace
  static constexpr double kPresses = 0.01;                  // share of the weight

  const RobotModel& robot_;
  const Terrain& ground_;
  const RigidBodyProblem& problem_;
  const RigidBodyMotion& motion_;
  DynamicsScratch scratch_;
  std::vector<int> problem_foot_, foot_of_;  // the problem's foot by the robot's foot, and the inverse
  std::vector<RigidBodySample> samples_;
  double step_s_ = 0.0;
  MotionPlan plan_;
};

}  // namespace

Result<MotionPlan> RigidBodyMotionPlan(const RobotModel& robot, const Terrain& ground, const RigidBodyProblem& problem,
                                       const RigidBodyMotion& motion, double step_s) {
  CheckRigidBodyProblem(problem);
  return Converter(robot, ground, problem, motion, step_s).Run();
}

Result<AuditReport> AuditRigidBody(const Terrain& ground, const RigidBodyProblem& problem,
                                   const RigidBodyMotion& motion) {
  const Result<RobotModel> robot = RigidBodyRobot(problem, "rigid-body");
  if (!robot) return robot.failure();
  const Result<MotionPlan> plan = RigidBodyMotionPlan(*robot, ground, problem, motion);
  if (!plan) return plan.failure();
  return Audit(*robot, *plan, {});
}

}  // namespace gaitwright
