// SPDX-License-Identifier: BSD-3-Clause
// The rows of a plan from a trajectory of the whole body over knots.
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/spatial/rotation.h"
#include "kinematics/stability/zero_moment_point.h"
#include "optimisation/pipeline/finish_motion_internal.h"
#include "optimisation/pipeline/mean_height.h"
#include "optimisation/whole_body/solve_whole_body.h"
#include "planning/plan/sample_plan.h"
#include "planning/plan/support_plane.h"

namespace gaitwright {
namespace {

/// Forces at a time between knots, on the feet that press at either of two knots: linear.
class ForcesBetween {
 public:
  explicit ForcesBetween(const FinishedTrajectory& finished) : finished_(finished) {}

  /// Sets contacts() and forces(), in units of the weight.
  void At(double time_s) {
    const std::vector<double>& times = finished_.problem.time_s;
    const auto above = std::upper_bound(times.begin() + 1, times.end() - 1, time_s);
    const auto right = static_cast<std::size_t>(above - times.begin()), left = right - 1;
    const double u = std::clamp((time_s - times[left]) / (times[right] - times[left]), 0.0, 1.0);
    contacts_.clear();
    forces_.setZero(0);
    AddKnot(left, 1.0 - u);
    AddKnot(right, u);
  }

  const std::vector<KnotContact>& contacts() const { return contacts_; }
  const VectorX& forces() const { return forces_; }
  VectorX& forces() { return forces_; }

 private:
  void AddKnot(std::size_t k, double share) {
    Eigen::Index from = 0;
    for (const PressingFoot& foot : finished_.problem.knots[k].pressing) {
      const auto size = static_cast<Eigen::Index>(3 * foot.contact.points_F.size());
      Eigen::Index to = 0;
      const auto same = std::find_if(contacts_.begin(), contacts_.end(), [&](const KnotContact& known) {
        if (known.foot == foot.contact.foot) return true;
        to += static_cast<Eigen::Index>(3 * known.points_F.size());
        return false;
      });
      if (same == contacts_.end()) {
        contacts_.push_back(foot.contact);
        forces_.conservativeResize(to + size);
        forces_.tail(size).setZero();
      }
      forces_.segment(to, size) += share * finished_.forces[k].segment(from, size);
      from += size;
    }
  }

  const FinishedTrajectory& finished_;
  std::vector<KnotContact> contacts_;
  VectorX forces_;
};

/// Changes forces at points least, in proportion to how they press, so that they give a wrench as far as they can.
void Balance(const MatrixX& by_force, const Vector6& lacking, double moment_scale, VectorX& forces) {
  constexpr double kLeast = 1e-9;
  VectorX pressing(forces.size());
  for (Eigen::Index i = 0; i < forces.size(); i += 3) pressing.segment<3>(i).setConstant(forces.segment<3>(i).norm());
  MatrixX G = -by_force.topRows<6>();
  Vector6 wanted = lacking;
  G.bottomRows<3>() /= moment_scale;
  wanted.tail<3>() /= moment_scale;
  const MatrixX WG = pressing.asDiagonal() * G.transpose();
  MatrixX square = G * WG;
  square.diagonal().array() += kLeast * std::max(1.0, square.trace());
  forces += WG * square.ldlt().solve(wanted);
}

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

}  // namespace

void SetRows(const RobotModel& model, const FinishedTrajectory& finished, double step_s, MotionPlan& plan) {
  WholeBodyTrajectory& out = plan.whole_body;
  const double end_s = out.end_s(), weight = model.weight_n();
  const int rows = static_cast<int>(std::lround((end_s - out.start_s) / step_s)) + 1;
  out = {out.start_s, step_s, {}, {}, {}, {}, {}};
  KnotModel knot(model);
  KnotForces at_row;
  ForcesBetween between(finished);
  VectorJet jet;
  ChartedState state;
  for (int row = 0; row < rows; ++row) {
    const double time_s = out.start_s + row * step_s;
    finished.spline.Sample(finished.points, time_s, jet);
    StateOf(finished.problem.chart, jet, state);
    between.At(time_s);
    const std::vector<KnotContact>& contacts = between.contacts();
    VectorX forces_W = weight * between.forces();
    if (forces_W.size() > 0) {
      knot.Differentiate(state.q, state.v, state.a, contacts, forces_W, at_row);
      Balance(at_row.by_force, at_row.needed.head<6>(), model.leg_length_m(), forces_W);
    }
    VectorX needed;
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
  for (std::size_t i = 0; i < courses.size(); ++i) {
    std::size_t s = 0;
    for (SwingTrajectory& swing : plan.swings) {
      if (swing.foot != courses[i].foot()) continue;
      const Foothold& left = plan.footsteps.footholds[courses[i].footholds()[s]];
      swing.X_WF_start.translation() = left.X_WF.translation() + left.roll_W;
      swing.X_WF_end.translation() = plan.footsteps.footholds[courses[i].footholds()[++s]].X_WF.translation();
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
      points[static_cast<std::size_t>(f)] = ContactPoints(model, scratch, f, NormalUnder(plan.footsteps, f, time_s));
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

/// Wrench on the base that a motion needs and its contact forces do not give, and what of it counts.
struct Unbalanced {
  Vector3 force_W, moment_W;
  double pressing = 0.0;  ///< vertical force of the contacts [N]
  double height_m = 0.0;  ///< of the base's origin over them
  double com_height_m = 0.0;

  /// How far it moves the zero-moment point off a line of support, over what the audit lets pass there.
  double Aside(const RobotModel& model) const {
    constexpr double kLeastLoad = 0.05, kLine = 2e-3, kSlight = 1e-3;  // as the audit has them
    const double weight = model.weight_n();
    if (pressing < kLeastLoad * weight) return 0.0;
    const Vector3 moment = moment_W + height_m * Vector3::UnitZ().cross(force_W);
    return moment.head<2>().norm() / pressing / std::max(kLine, kSlight * com_height_m * weight / pressing);
  }
};

Unbalanced UnbalancedAt(const RobotModel& model, const MotionPlan& plan, double time_s, WholeBodySample& sample,
                        DynamicsScratch& scratch) {
  VectorX needed;
  SampleWholeBody(plan.whole_body, time_s, sample);
  InverseDynamics(model, sample.q, sample.v, sample.a, scratch, needed);
  Unbalanced left{needed.head<3>(), needed.segment<3>(3)};
  double ground_m = scratch.p_WB[0].z();
  for (int f = 0; f < static_cast<int>(model.feet.size()); ++f) {
    const ContactWrench& wrench = sample.wrenches[static_cast<std::size_t>(f)];
    if (wrench.force_W.isZero()) continue;
    const Pose X_WF = ContactFrame(model, scratch, f, NormalUnder(plan.footsteps, f, time_s));
    left.force_W -= wrench.force_W;
    left.moment_W -= (X_WF.translation() - scratch.p_WB[0]).cross(wrench.force_W) + wrench.moment_W;
    left.pressing += wrench.force_W.z();
    ground_m = std::min(ground_m, X_WF.translation().z());
  }
  left.height_m = scratch.p_WB[0].z() - ground_m;
  left.com_height_m = CentreOfMass(model, scratch).z() - ground_m;
  return left;
}

}  // namespace

PlanResidual ResidualOf(const RobotModel& model, const MotionPlan& plan, const std::vector<double>& knots_s) {
  constexpr double kStep = 1e-3;     // [s]
  constexpr double kAside = 1.4e-3;  // that counts as much as what the audit lets pass
  const double weight = model.weight_n(), moment = weight * model.leg_length_m();
  const WholeBodyTrajectory& motion = plan.whole_body;
  DynamicsScratch scratch(model);
  WholeBodySample sample;
  PlanResidual residual;
  residual.by_interval.assign(knots_s.size() - 1, 0.0);
  std::size_t interval = 0;
  const int samples = static_cast<int>(std::floor((motion.end_s() - motion.start_s) / kStep + 1e-9));
  for (int i = 0; i <= samples; ++i) {
    const double time_s = motion.start_s + i * kStep;
    const Unbalanced left = UnbalancedAt(model, plan, time_s, sample, scratch);
    const double force = left.force_W.norm() / weight, turning = left.moment_W.norm() / moment;
    if (std::max(force, turning) > std::max(residual.force, residual.moment)) residual.at_s = time_s;
    residual.force = std::max(residual.force, force);
    residual.moment = std::max(residual.moment, turning);
    while (interval + 2 < knots_s.size() && time_s > knots_s[interval + 1]) ++interval;
    residual.by_interval[interval] =
        std::max({residual.by_interval[interval], force, turning, kAside * left.Aside(model)});
  }
  return residual;
}

}  // namespace gaitwright
