// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/body_tree.h"
#include "kinematics/spatial/rotation.h"
#include "optimisation/trajectory/motor_rows_internal.h"
#include "optimisation/whole_body/finish_problem_internal.h"
#include "planning/plan/heel_off_internal.h"
#include "planning/plan/sample_plan.h"
#include "planning/plan/sole_support.h"

namespace gaitwright {
namespace {

constexpr double kSameKnot = 1e-9;    // [s]
constexpr double kStanceTilt = 1e-3;  // [rad] of soles without ankle roll: with more they would stand on an edge

/// Rows of a foot's position along the heading's axes, and of its rotation along its own.
MatrixX FootRowsOf(const RobotModel& model, const DynamicsScratch& scratch, int foot) {
  const Foot& of = model.feet[static_cast<std::size_t>(foot)];
  const Pose X_WF = FramePose(scratch, of.body, of.X_BF);
  MatrixX J(6, model.nv());
  PointJacobian(model, scratch, of.body, of.X_BF.translation(), J);
  J.topRows<3>() += of.radius * Skew(Vector3::UnitZ()) * J.bottomRows<3>();
  J.bottomRows<3>() = (X_WF.linear().transpose() * J.bottomRows<3>()).eval();
  return J;
}

/// The rows of a plan's whole body at a time, with the velocity and acceleration of a motion that starts and ends at
/// rest.
VectorJet ReferenceAt(const MotionPlan& plan, const TurningChart& chart, double time_s, const VectorX& near) {
  WholeBodySample sample;
  SampleWholeBody(plan.whole_body, time_s, sample);
  return JetOf(chart, sample.q, sample.v, sample.a, near);
}

TurningChart ChartOf(const RobotModel& model, const MotionPlan& plan) {
  std::vector<Matrix3> R_WB;
  for (const VectorX& q : plan.whole_body.q) R_WB.push_back(BaseRotation(q));
  return TurningChart::For(R_WB, BaseRotation(StandingConfiguration(model)));
}

PressingFoot PressingOf(const RobotModel& model, const MotionPlan& plan, const FootCourse::Place& place,
                        const Polygon& support_F, double friction_use) {
  const Foothold& foothold = plan.footsteps.footholds[place.foothold];
  const Foot& foot = model.feet[static_cast<std::size_t>(foothold.foot)];
  PressingFoot pressing;
  pressing.axes_W = foothold.X_WF.linear();
  pressing.friction = friction_use * FrictionOf(plan.terrain, foothold.patch);
  pressing.contact.foot = foothold.foot;
  pressing.contact.offset_W = -foot.radius * pressing.axes_W.col(2);
  if (!foot.has_sole()) return pressing;
  pressing.contact.points_F.clear();
  for (const Vector2& corner : place.on_edge ? FrontEdge(foot.sole_F) : support_F)
    pressing.contact.points_F.emplace_back(corner.x(), corner.y(), 0.0);
  return pressing;
}

/// Whether a foot is about to lift off or touch down. Feet that are free in the air are held at rest there.
bool IsNearEnd(const MotionPlan& plan, int foot, double time_s) {
  constexpr double kNear = 0.012;  // [s]
  return std::any_of(plan.swings.begin(), plan.swings.end(), [&](const SwingTrajectory& swing) {
    return swing.foot == foot && (std::abs(time_s - swing.start_s) < kNear || std::abs(time_s - swing.end_s) < kNear);
  });
}

FootGoal GoalOf(const Foot& foot, const FootCourse& course, const FootCourse::Place& place, double yaw_rad) {
  FootGoal goal;
  goal.foot = course.foot();
  goal.normal_W = place.X_WF.linear().col(2);
  goal.p_W = place.X_WF.translation() + foot.radius * goal.normal_W;
  goal.R_W = place.X_WF.linear();
  goal.axes_W = YawRotation(yaw_rad);
  goal.swings = place.swings;
  return goal;
}

/// The largest step of knots for the swings between two times.
double LargestStepIn(const MotionPlan& plan, double start_s, double end_s, int least_per_swing) {
  double step_s = std::numeric_limits<double>::infinity();
  for (const SwingTrajectory& swing : plan.swings) {
    const bool during = swing.start_s < end_s - kSameKnot && swing.end_s > start_s + kSameKnot;
    if (during && least_per_swing > 0) step_s = std::min(step_s, (swing.end_s - swing.start_s) / least_per_swing);
  }
  return step_s;
}

/// Times at which contacts change after the start, in order: ends of phases, and heels that rise; and other times.
std::vector<double> ChangesOf(const MotionPlan& plan, std::vector<double> changes) {
  for (const ContactPhase& phase : plan.schedule.phases) changes.push_back(phase.end_s);
  for (const Foothold& foothold : plan.footsteps.footholds) {
    if (foothold.heel_off_s) changes.push_back(*foothold.heel_off_s);
  }
  std::sort(changes.begin(), changes.end());
  const auto same = [](double a, double b) { return b - a < kSameKnot; };
  changes.erase(std::unique(changes.begin(), changes.end(), same), changes.end());
  std::erase_if(changes, [&](double time_s) { return time_s < plan.schedule.start_s() + kSameKnot; });
  return changes;
}

bool HeelRises(const MotionPlan& plan, double time_s) {
  return std::any_of(plan.footsteps.footholds.begin(), plan.footsteps.footholds.end(), [&](const Foothold& foothold) {
    return StandsOnEdge(foothold, time_s) && time_s < foothold.liftoff_s;
  });
}

/// Joints that the plan holds still and whose dry friction takes most of what their motors have: any motion, however
/// small, would need that friction.
std::vector<bool> StillJoints(const BodyProblem& problem) {
  constexpr double kStill = 1e-9;  // [rad] or [m]
  const MotorRows motors(*problem.model, problem.use);
  std::vector<bool> still;
  for (int dof = 0; dof < problem.model->num_dofs(); ++dof) {
    const double place = problem.knots.front().reference.x[6 + dof];
    still.push_back(motors.Sticks(dof) && std::ranges::all_of(problem.knots, [&](const BodyKnot& knot) {
                      return std::abs(knot.reference.x[6 + dof] - place) < kStill;
                    }));
  }
  return still;
}

}  // namespace

std::vector<double> KnotTimesOf(const MotionPlan& plan, double knot_step_s, int least_per_swing,
                                const std::vector<double>& also_s) {
  constexpr double kRounding = 1e-6;  // of a step
  constexpr double kOfHeelOff = 0.5;  // soles turn far in a short time
  std::vector<double> times{plan.schedule.start_s()};
  const double row_s = plan.whole_body.step_s;
  const auto on_row = [&](double time_s) {
    return plan.schedule.start_s() + row_s * std::round((time_s - plan.schedule.start_s()) / row_s);
  };
  const auto is_on_row = [&](double time_s) { return std::abs(on_row(time_s) - time_s) < kSameKnot; };
  double start_s = plan.schedule.start_s();
  for (const double end_s : ChangesOf(plan, also_s)) {
    const double length = end_s - start_s;
    const bool on_rows = is_on_row(start_s) && is_on_row(end_s);
    double step_s = HeelRises(plan, 0.5 * (start_s + end_s)) ? kOfHeelOff * knot_step_s : knot_step_s;
    if (const double largest_s = LargestStepIn(plan, start_s, end_s, least_per_swing); largest_s < step_s)
      step_s = on_rows ? row_s * std::max(1.0, std::floor(largest_s / row_s + kRounding)) : largest_s;
    const int pieces = std::max(1, static_cast<int>(std::ceil(length / step_s - kRounding)));
    for (int i = 1; i <= pieces; ++i) {
      const double even = start_s + length * i / pieces, row = on_rows ? on_row(even) : even;
      const double time_s = i == pieces ? end_s : row;
      if (time_s > times.back() + kSameKnot) times.push_back(time_s);
    }
    start_s = end_s;
  }
  return times;
}

std::vector<std::array<bool, 6>> FreeFootRows(const RobotModel& model) {
  constexpr double kDependent = 1e-3;    // of a row's length, left after those before are taken out
  constexpr double kOfBaseAlone = 0.02;  // of a row that no joint moves
  const std::vector<bool> of_leg = DofsOfLegs(model);
  std::vector<int> columns{0, 1, 2, 3, 4, 5};
  for (int dof = 0; dof < model.num_dofs(); ++dof) {
    if (of_leg[static_cast<std::size_t>(dof)]) columns.push_back(6 + dof);
  }
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  std::vector<Eigen::RowVectorXd> basis;
  std::vector<std::array<bool, 6>> rows;
  for (int foot = 0; foot < static_cast<int>(model.legs.size()); ++foot) {
    const Foot& of = model.feet[static_cast<std::size_t>(foot)];
    const MatrixX J = FootRowsOf(model, scratch, foot);
    std::array<bool, 6> free{true, true, true, of.type == FootType::kSole, of.has_sole(), of.has_sole()};
    for (std::size_t i = 0; i < free.size(); ++i) {
      if (!free[i]) continue;
      Eigen::RowVectorXd row = J.row(static_cast<Eigen::Index>(i))(columns);
      const double length = row.norm(), of_joints = row.tail(row.size() - 6).norm();
      for (const auto& direction : basis) row -= row.dot(direction) * direction;
      free[i] = basis.size() < columns.size() &&
                row.norm() >= (of_joints < kOfBaseAlone * length ? kOfBaseAlone : kDependent) * length;
      if (free[i]) basis.push_back(row.normalized());
    }
    rows.push_back(free);
  }
  return rows;
}

BodyProblem ProblemOf(const RobotModel& model, const MotionPlan& plan, const std::vector<FootCourse>& courses,
                      const std::vector<double>& knots_s, const FinishSettings& settings) {
  BodyProblem problem;
  problem.model = &model;
  problem.chart = ChartOf(model, plan);
  problem.time_s = knots_s;
  problem.weights = settings.weights;
  problem.use = settings.use;
  const std::vector<std::array<bool, 6>> rows = FreeFootRows(model);
  const std::vector<Polygon> supports_F = SupportsOf(model, plan.terrain, plan.footsteps);
  VectorX near = VectorX::Zero(model.nv());
  for (const double time_s : knots_s) {
    BodyKnot knot;
    knot.reference = ReferenceAt(plan, problem.chart, time_s, near);
    near = knot.reference.x;
    const double yaw_rad = YawOf(problem.chart.At({near.segment<3>(3)}).R);
    const MotionPart* part = PartAt(plan.parts, time_s);
    for (std::size_t i = 0; i < courses.size(); ++i) {
      const FootCourse::Place place = courses[i].At(time_s);
      const auto foot = static_cast<std::size_t>(courses[i].foot());
      knot.feet.push_back(GoalOf(model.feet[foot], courses[i], place, yaw_rad));
      const bool tumbles =
          place.swings && part != nullptr && TurnsOver(part->gait) && !IsNearEnd(plan, courses[i].foot(), time_s);
      knot.feet.back().rows = tumbles ? std::array<bool, 6>{} : rows[i];
      if (model.feet[foot].type == FootType::kLine && !place.swings) {
        knot.feet.back().rows[3] = true;
        knot.feet.back().below[3] = knot.feet.back().above[3] = kStanceTilt;
      }
      if (!place.presses) continue;
      knot.pressing.push_back(PressingOf(model, plan, place, supports_F[place.foothold], settings.friction_use));
    }
    problem.knots.push_back(std::move(knot));
  }
  problem.still = StillJoints(problem);
  for (BodyKnot* end : {&problem.knots.front(), &problem.knots.back()}) {
    end->pins_motion = true;
    end->reference.rate.setZero();
    end->reference.acceleration.setZero();
  }
  problem.knots.front().pins_place = true;
  return problem;
}

void SetRolledGoals(const RobotModel& model, const WholeBodyTrajectory& motion, const FootRolls& rolls,
                    const std::vector<FootCourse>& courses, BodyProblem& problem) {
  DynamicsScratch scratch(model);
  WholeBodySample sample;
  for (std::size_t k = 0; k < problem.knots.size(); ++k) {
    const double time_s = problem.time_s[k], at = (time_s - motion.start_s) / motion.step_s;
    const auto row = static_cast<std::size_t>(std::clamp(std::floor(at + kSameKnot), 0.0, motion.size() - 1.0));
    SampleWholeBody(motion, time_s, sample);
    ForwardKinematics(model, sample.q, scratch);
    for (std::size_t i = 0; i < courses.size(); ++i) {
      FootGoal& goal = problem.knots[k].feet[i];
      const Foot& foot = model.feet[static_cast<std::size_t>(goal.foot)];
      if (foot.radius == 0.0) continue;
      goal.R_roll = FramePose(scratch, foot.body, foot.X_BF).linear();
      goal.p_W = courses[i].At(time_s).X_WF.translation() + foot.radius * goal.normal_W +
                 rolls.At(foot, i, row, goal.R_roll, goal.normal_W);
    }
  }
}

MatrixX FirstPoints(const BodyProblem& problem) {
  const Eigen::Index coordinates = problem.model->nv();
  MatrixX values(coordinates, static_cast<Eigen::Index>(problem.knots.size()));
  for (std::size_t k = 0; k < problem.knots.size(); ++k)
    values.col(static_cast<Eigen::Index>(k)) = problem.knots[k].reference.x;
  return ChainSpline(problem.time_s).Through(values, VectorX::Zero(coordinates), VectorX::Zero(coordinates));
}

std::vector<Vector3> RolledAtTouchdowns(const MotionPlan& plan, const FootCourse& course,
                                        const std::vector<Vector3>& roll_W) {
  const WholeBodyTrajectory& motion = plan.whole_body;
  std::vector<Vector3> rolled_W;
  for (const std::size_t index : course.footholds()) {
    const double time_s = plan.footsteps.footholds[index].touchdown_s;
    const double row = std::clamp((time_s - motion.start_s) / motion.step_s, 0.0, motion.size() - 1.0);
    rolled_W.push_back(roll_W[static_cast<std::size_t>(std::lround(row))]);
  }
  return rolled_W;
}

std::vector<VectorX> FirstForces(const RobotModel& model, const MotionPlan& plan, const BodyProblem& problem) {
  std::vector<VectorX> all;
  WholeBodySample sample;
  for (std::size_t k = 0; k < problem.knots.size(); ++k) {
    const std::vector<PressingFoot>& pressing = problem.knots[k].pressing;
    std::size_t points = 0;
    for (const PressingFoot& foot : pressing) points += foot.contact.points_F.size();
    VectorX forces(3 * static_cast<Eigen::Index>(points));
    SampleWholeBody(plan.whole_body, problem.time_s[k], sample);
    Eigen::Index at = 0;
    for (const PressingFoot& foot : pressing) {
      const auto index = static_cast<std::size_t>(foot.contact.foot);
      Vector3 force_W = foot.axes_W.col(2) / static_cast<double>(pressing.size());
      if (index < sample.wrenches.size() && !sample.wrenches[index].force_W.isZero())
        force_W = sample.wrenches[index].force_W / model.weight_n();
      for (std::size_t p = 0; p < foot.contact.points_F.size(); ++p, at += 3)
        forces.segment<3>(at) = force_W / static_cast<double>(foot.contact.points_F.size());
    }
    all.push_back(std::move(forces));
  }
  return all;
}

}  // namespace gaitwright
