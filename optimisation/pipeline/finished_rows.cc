// SPDX-License-Identifier: BSD-3-Clause
// The rows of a plan from a trajectory of the whole body over knots.
#include <algorithm>
#include <cmath>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/spatial/rotation.h"
#include "kinematics/stability/zero_moment_point.h"
#include "optimisation/pipeline/finish_motion_internal.h"
#include "optimisation/pipeline/mean_height.h"
#include "optimisation/whole_body/solve_whole_body.h"
#include "planning/plan/heel_off_internal.h"
#include "planning/plan/sample_plan.h"
#include "planning/plan/support_plane.h"

namespace gaitwright {
namespace {

/// Wrenches of a row's forces by foot, about the feet's contact frames.
std::vector<ContactWrench> WrenchesOf(const RobotModel& model, const std::vector<KnotContact>& contacts,
                                      const VectorX& forces_W, const KnotModel& knot) {
  std::vector<ContactWrench> wrenches(model.feet.size());
  Eigen::Index at = 0;
  KnotFoot foot;
  for (const KnotContact& contact : contacts) {
    ContactWrench& wrench = wrenches[static_cast<std::size_t>(contact.foot)];
    knot.FootAt(contact.foot, false, foot);
    for (const Vector3& p_F : contact.points_F) {
      const Vector3 f = forces_W.segment<3>(at);
      wrench.force_W += f;
      wrench.moment_W += (foot.R_WF * p_F).cross(f);
      at += 3;
    }
  }
  return wrenches;
}

/// Contact points of a foot: of a sole on its front edge, those of the edge.
std::vector<Vector3> PointsAt(const RobotModel& model, const DynamicsScratch& scratch, const FootstepPlan& footsteps,
                              int foot, double time_s) {
  const Foot& of = model.feet[static_cast<std::size_t>(foot)];
  const int index = FootholdAt(footsteps, foot, time_s);
  const bool on_edge =
      index >= 0 && of.has_sole() && StandsOnEdge(footsteps.footholds[static_cast<std::size_t>(index)], time_s);
  if (!on_edge) return ContactPoints(model, scratch, foot, NormalUnder(footsteps, foot, time_s));
  std::vector<Vector3> points;
  const Pose X_WF = FramePose(scratch, of.body, of.X_BF);
  for (const Vector2& p_F : FrontEdge(of.sole_F)) points.push_back(X_WF * Vector3(p_F.x(), p_F.y(), 0.0));
  return points;
}

}  // namespace

void SetRows(const RobotModel& model, const SolvedTrajectory& solved, double step_s, MotionPlan& plan) {
  WholeBodyTrajectory& out = plan.whole_body;
  const double end_s = out.end_s();
  const int rows = static_cast<int>(std::lround((end_s - out.start_s) / step_s)) + 1;
  out = {out.start_s, step_s, {}, {}, {}, {}, {}};
  KnotModel knot(model);
  VectorJet jet;
  ChartedState state;
  std::vector<KnotContact> contacts;
  VectorX forces_W, needed;
  for (int row = 0; row < rows; ++row) {
    const double time_s = out.start_s + row * step_s;
    solved.Sample(time_s, jet);
    StateOf(solved.problem().chart, jet, state);
    solved.ForcesAt(time_s, contacts, forces_W);
    forces_W *= model.weight_n();
    knot.Evaluate(state.q, state.v, state.a, contacts, forces_W, needed);
    out.q.push_back(state.q);
    out.v.push_back(state.v);
    out.a.push_back(state.a);
    out.tau.push_back(needed.tail(model.num_dofs()));
    out.wrenches.push_back(WrenchesOf(model, contacts, forces_W, knot));
  }
}

void SetFootholds(const FootRolls& rolls, const std::vector<FootCourse>& courses, MotionPlan& plan) {
  const WholeBodyTrajectory& motion = plan.whole_body;
  const auto row = [&](double time_s) {
    const double at = std::clamp((time_s - motion.start_s) / motion.step_s, 0.0, motion.size() - 1.0);
    return static_cast<std::size_t>(std::lround(at));
  };
  for (std::size_t i = 0; i < courses.size(); ++i) {
    for (std::size_t s = 0; s < courses[i].footholds().size(); ++s) {
      Foothold& foothold = plan.footsteps.footholds[courses[i].footholds()[s]];
      const Vector3 &from = rolls.roll_W[i][row(foothold.touchdown_s)], &to = rolls.roll_W[i][row(foothold.liftoff_s)];
      foothold.X_WF.translation() = courses[i].PathAt(s) + from;
      foothold.roll_W = to - from;
    }
  }
  for (const FootCourse& course : courses) {
    std::size_t s = 0;
    for (SwingTrajectory& swing : plan.swings) {
      if (swing.foot != course.foot()) continue;
      const Foothold& left = plan.footsteps.footholds[course.footholds()[s]];
      if (!left.heel_off_s) swing.X_WF_start.translation() = left.X_WF.translation() + left.roll_W;
      swing.X_WF_end.translation() = plan.footsteps.footholds[course.footholds()[++s]].X_WF.translation();
    }
  }
}

void SetCentroidal(const RobotModel& model, MotionPlan& plan) {
  constexpr double kPresses = 0.01;  // of the weight
  CentroidalTrajectory& c = plan.centroidal;
  const WholeBodyTrajectory& motion = plan.whole_body;
  c.start_s = motion.start_s;
  c.step_s = motion.step_s;
  c.p_WC.clear();
  c.v_WC.clear();
  c.a_WC.clear();
  DynamicsScratch scratch(model);
  VectorX needed;
  std::vector<Vector2> zmp_W;
  std::vector<bool> presses;
  ContactsByFoot points(model.feet.size());
  for (int row = 0; row < motion.size(); ++row) {
    const auto k = static_cast<std::size_t>(row);
    const double time_s = motion.start_s + row * motion.step_s;
    InverseDynamics(model, motion.q[k], motion.v[k], motion.a[k], scratch, needed);
    c.p_WC.push_back(CentreOfMass(model, scratch));
    c.v_WC.emplace_back(CentroidalMomentum(model, scratch).head<3>() / model.total_mass_kg);
    c.a_WC.emplace_back(needed.head<3>() / model.total_mass_kg - kGravity * Vector3::UnitZ());
    for (int f = 0; f < static_cast<int>(model.feet.size()); ++f)
      points[static_cast<std::size_t>(f)] = PointsAt(model, scratch, plan.footsteps, f, time_s);
    const GroundPlane plane = SupportPlaneAt(plan.schedule, time_s, points);
    presses.push_back(needed[2] > kPresses * model.weight_n() &&
                      needed[2] - plane.slope.dot(needed.head<2>()) > kPresses * model.weight_n());
    zmp_W.emplace_back(
        presses.back()
            ? ZeroMomentPoint(scratch.p_WB[0], needed.head<3>(), needed.segment<3>(3), plane).head<2>().eval()
            : c.p_WC.back().head<2>().eval());
  }
  c.p_WZ = HeldOverFlights(zmp_W, presses);
  c.omega_rad_s = std::sqrt(kGravity / MeanHeightOverFeet(c, plan.footsteps, static_cast<int>(model.feet.size())));
}

namespace {

/// Wrench on the base that a motion needs and its contact forces do not give.
Vector6 UnbalancedAt(const RobotModel& model, const MotionPlan& plan, double time_s, WholeBodySample& sample,
                     DynamicsScratch& scratch) {
  VectorX needed;
  SampleWholeBody(plan.whole_body, time_s, sample);
  InverseDynamics(model, sample.q, sample.v, sample.a, scratch, needed);
  Vector6 left = needed.head<6>();
  for (int f = 0; f < static_cast<int>(model.feet.size()); ++f) {
    const ContactWrench& wrench = sample.wrenches[static_cast<std::size_t>(f)];
    if (wrench.force_W.isZero()) continue;
    const Pose X_WF = ContactFrame(model, scratch, f, NormalUnder(plan.footsteps, f, time_s));
    left.head<3>() -= wrench.force_W;
    left.tail<3>() -= (X_WF.translation() - scratch.p_WB[0]).cross(wrench.force_W) + wrench.moment_W;
  }
  return left;
}

}  // namespace

PlanResidual ResidualOf(const RobotModel& model, const MotionPlan& plan) {
  constexpr double kStep = 1e-3;  // [s]
  const double weight = model.weight_n(), moment = weight * model.leg_length_m();
  const WholeBodyTrajectory& motion = plan.whole_body;
  DynamicsScratch scratch(model);
  WholeBodySample sample;
  PlanResidual residual;
  const int samples = static_cast<int>(std::floor((motion.end_s() - motion.start_s) / kStep + 1e-9));
  for (int i = 0; i <= samples; ++i) {
    const double time_s = motion.start_s + i * kStep;
    const Vector6 left = UnbalancedAt(model, plan, time_s, sample, scratch);
    const double force = left.head<3>().norm() / weight, turning = left.tail<3>().norm() / moment;
    if (std::max(force, turning) > residual.largest()) residual.at_s = time_s;
    residual.force = std::max(residual.force, force);
    residual.moment = std::max(residual.moment, turning);
  }
  return residual;
}

}  // namespace gaitwright
