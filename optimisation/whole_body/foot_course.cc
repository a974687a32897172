// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "kinematics/base/result.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/spatial/rotation.h"
#include "optimisation/whole_body/foot_course_internal.h"
#include "planning/plan/heel_off_internal.h"
#include "planning/plan/sample_plan.h"

namespace gaitwright {
namespace {

constexpr double kSameTime = 1e-9;  // [s]

}  // namespace

FootCourse::FootCourse(const RobotModel& model, const MotionPlan& plan, int foot)
    : plan_(plan),
      shape_(model.feet[static_cast<std::size_t>(foot)]),
      foot_(foot),
      start_s_(plan.schedule.start_s()),
      end_s_(plan.schedule.end_s()) {
  const auto& all = plan.footsteps.footholds;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].foot == foot) footholds_.push_back(i);
  }
  for (const SwingTrajectory& swing : plan.swings) {
    if (swing.foot == foot) swings_.push_back(CurveOf(swing));
  }
  if (footholds_.empty() || swings_.size() + 1 != footholds_.size()) {
    throw InvalidArgument("foot '" + model.feet[static_cast<std::size_t>(foot)].name +
                          "' of the plan needs footholds, and a swing between any two of them");
  }
  SetRolls(std::vector<Vector3>(footholds_.size(), Vector3::Zero()));
}

void FootCourse::SetRolls(const std::vector<Vector3>& roll_W) {
  path_W_.clear();
  for (std::size_t i = 0; i < footholds_.size(); ++i)
    path_W_.push_back(plan_.footsteps.footholds[footholds_[i]].X_WF.translation() - roll_W[i]);
}

FootCourse::Place FootCourse::At(double time_s) const {
  std::size_t stance = 0;
  while (stance + 1 < footholds_.size() && time_s > swings_[stance].end_s - kSameTime) ++stance;
  const Foothold& foothold = plan_.footsteps.footholds[footholds_[stance]];
  Place place;
  place.foothold = footholds_[stance];
  place.swings = stance < swings_.size() && time_s > swings_[stance].start_s + kSameTime;
  if (place.swings) {
    SwingCurve curve = swings_[stance];
    if (!foothold.heel_off_s) {
      curve.X_WF_start = foothold.X_WF;
      curve.X_WF_start.translation() = path_W_[stance];
    }
    curve.X_WF_end = plan_.footsteps.footholds[footholds_[stance + 1]].X_WF;
    curve.X_WF_end.translation() = path_W_[stance + 1];
    place.X_WF = Evaluate(curve, time_s).X_WF;
    return place;
  }
  place.X_WF = foothold.X_WF;
  place.X_WF.translation() = path_W_[stance];
  place.on_edge = StandsOnEdge(foothold, time_s) && stance < swings_.size();
  if (place.on_edge) place.X_WF = OnEdge(stance, time_s);
  const bool lands = stance > 0 && time_s < foothold.touchdown_s + kSameTime;
  const bool leaves = stance < swings_.size() && time_s > foothold.liftoff_s - kSameTime;
  place.presses = !lands && !leaves;
  return place;
}

Pose FootCourse::OnEdge(std::size_t stance, double time_s) const {
  const Foothold& foothold = plan_.footsteps.footholds[footholds_[stance]];
  const double pitch_rad = EdgeTurnOf(shape_, foothold.X_WF, swings_[stance].X_WF_start).pitch_rad;
  const double length_s = std::max(foothold.liftoff_s - *foothold.heel_off_s, kSameTime);
  return TurnedAboutEdge(shape_, foothold.X_WF,
                         pitch_rad * SmoothStep((time_s - *foothold.heel_off_s) / length_s).value);
}

std::vector<FootCourse> CoursesOf(const RobotModel& model, const MotionPlan& plan) {
  std::vector<FootCourse> courses;
  for (int foot = 0; foot < static_cast<int>(model.legs.size()); ++foot) courses.emplace_back(model, plan, foot);
  return courses;
}

Vector3 FootRolls::At(const Foot& foot, std::size_t index, std::size_t row, const Matrix3& R_WF_now,
                      const Vector3& normal_W) const {
  return roll_W[index][row] + foot.radius * RotationLog(R_WF_now * R_WF[index][row].transpose()).cross(normal_W);
}

FootRolls RollsOf(const RobotModel& model, const WholeBodyTrajectory& motion, const std::vector<FootCourse>& courses) {
  FootRolls rolls;
  rolls.roll_W.resize(courses.size());
  rolls.R_WF.resize(courses.size());
  DynamicsScratch scratch(model);
  std::vector<Vector3> normal_W(courses.size(), Vector3::UnitZ());
  for (std::size_t row = 0; row < motion.q.size(); ++row) {
    ForwardKinematics(model, motion.q[row], scratch);
    const double time_s = motion.start_s + static_cast<double>(row) * motion.step_s;
    for (std::size_t i = 0; i < courses.size(); ++i) {
      const Foot& foot = model.feet[static_cast<std::size_t>(courses[i].foot())];
      const Matrix3 R_WF = FramePose(scratch, foot.body, foot.X_BF).linear();
      const Vector3 now_W = courses[i].At(time_s).X_WF.linear().col(2);
      Vector3 roll_W = Vector3::Zero();
      if (row > 0) roll_W = rolls.At(foot, i, row - 1, R_WF, 0.5 * (normal_W[i] + now_W));
      normal_W[i] = now_W;
      rolls.roll_W[i].push_back(roll_W);
      rolls.R_WF[i].push_back(R_WF);
    }
  }
  return rolls;
}

}  // namespace gaitwright
