// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <vector>

#include "kinematics/dynamics/contact_split.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/trajectory/swing_curve.h"
#include "optimisation/whole_body/solve_whole_body.h"
#include "planning/plan/sole_support.h"
#include "planning/plan/support_plane.h"

namespace gaitwright {
namespace {

constexpr double kLeastLoad = 1e-5;
constexpr double kRestRamp = 0.3;   // share of a foot's ramp: a body part that lies down does not hover
constexpr double kRestLoad = 20.0;  // factor of a foot's load: legs of a lying robot carry almost nothing

/// Share of the load of a foot at a time: rises from 0 after touch-down and falls to 0 before lift-off.
class LoadShare {
 public:
  LoadShare(const ContactSchedule& schedule, int foot, double ramp_s) {
    for (const ContactInterval& interval : IntervalsOf(schedule, foot)) {
      const auto length = [&](int phase) {
        const ContactPhase& p = schedule.phases[static_cast<std::size_t>(phase)];
        return p.end_s - p.start_s;
      };
      Ramp ramp{interval, 0.0, 0.0};
      if (interval.start_s > schedule.start_s()) {
        ramp.rise_s = std::min(ramp_s, length(PhaseAt(schedule, interval.start_s)));
      }
      if (interval.end_s < schedule.end_s()) {
        ramp.fall_s = std::min(ramp_s, length(PhaseAt(schedule, interval.end_s) - 1));
      }
      ramps_.push_back(ramp);
    }
  }

  double At(double time_s) const {
    for (const Ramp& ramp : ramps_) {
      if (time_s < ramp.interval.start_s - kTiny || time_s > ramp.interval.end_s + kTiny) continue;
      double load = 1.0;
      if (ramp.rise_s > 0.0) load = std::min(load, SmoothStep((time_s - ramp.interval.start_s) / ramp.rise_s).value);
      if (ramp.fall_s > 0.0) load = std::min(load, SmoothStep((ramp.interval.end_s - time_s) / ramp.fall_s).value);
      return std::max(load, kLeastLoad);
    }
    return 0.0;
  }

 private:
  static constexpr double kTiny = 1e-9;  // [s] tolerance of rounding for times on the grid
  struct Ramp {
    ContactInterval interval;
    double rise_s, fall_s;
  };
  std::vector<Ramp> ramps_;
};

/// Splits a wrench over the contacts; does nothing without contacts.
void Split(const std::vector<ContactPoint>& contacts, const PointWrench& needed, ContactSplitter& splitter,
           ContactSplit& split) {
  if (!contacts.empty()) return splitter.Solve(contacts, needed, split);
  split.force_W.clear();
  split.residual_force_W = needed.force_W;
  split.residual_moment_W = needed.moment_W;
}

/// ZMP of a wrench on a plane if the wrench presses on the plane; otherwise a given point.
Vector2 ZmpOf(const RobotModel& model, const PointWrench& wrench, const GroundPlane& plane, const Vector2& otherwise) {
  constexpr double kPresses = 0.01;  // share of the weight
  if (wrench.force_W.z() < kPresses * model.weight_n()) return otherwise;
  return ZeroMomentPoint(wrench.p_W, wrench.force_W, wrench.moment_W, plane).head<2>();
}

/// The points at which the feet press on the ground at one time.
struct PressingPoints {
  ContactsByFoot of_foot;              ///< of all feet, including those in the air
  std::vector<Vector3> origin_W;       ///< of each foot's contact frame
  std::vector<ContactPoint> contacts;  ///< of the feet that carry a load
  std::vector<std::size_t> foot;       ///< index of the foot of each contact
};

/// Computes contact points of the feet, and each foot's share of the load.
class PressingFeet {
 public:
  PressingFeet(const RobotModel& model, const WholeBodyProblem& problem, const WholeBodyOptions& options)
      : model_(model),
        problem_(problem),
        friction_use_(options.friction_use),
        support_F_(SupportsOf(model, *problem.terrain, *problem.footsteps)) {
    for (std::size_t f = 0; f < model.feet.size(); ++f) {
      const double ramp_s = (IsRest(f) ? kRestRamp : 1.0) * options.load_ramp_s;
      loads_.emplace_back(*problem.schedule, static_cast<int>(f), ramp_s);
    }
    points_.of_foot.resize(model.feet.size());
    points_.origin_W.resize(model.feet.size());
  }

  /// Needs ForwardKinematics on the scratch. The next call overwrites the result.
  const PressingPoints& At(double time_s, const DynamicsScratch& scratch) {
    points_.contacts.clear();
    points_.foot.clear();
    for (std::size_t f = 0; f < model_.feet.size(); ++f) AddFoot(f, time_s, scratch);
    return points_;
  }

 private:
  bool IsRest(std::size_t foot) const { return foot >= model_.legs.size(); }

  void AddFoot(std::size_t f, double time_s, const DynamicsScratch& scratch) {
    const int foot = static_cast<int>(f), at = FootholdAt(*problem_.footsteps, foot, time_s);
    if (at < 0) {  // a support link that never touches the ground
      points_.origin_W[f].setZero();
      return;
    }
    const auto index = static_cast<std::size_t>(at);
    const Foothold& foothold = problem_.footsteps->footholds[index];
    const Vector3 normal_W = foothold.X_WF.linear().col(2);
    const Pose X_WF = ContactFrame(model_, scratch, foot, normal_W);
    std::vector<Vector3>& points = points_.of_foot[f];
    points_.origin_W[f] = X_WF.translation();
    points.clear();
    for (const Vector2& p_F : support_F_[index]) points.push_back(X_WF * Vector3(p_F.x(), p_F.y(), 0.0));
    double load = loads_[f].At(time_s);
    if (load <= 0.0) return;
    if (problem_.load) load = std::max(kLeastLoad, problem_.load(foot, time_s));
    if (IsRest(f)) load *= kRestLoad;
    const double friction = friction_use_ * FrictionOf(*problem_.terrain, foothold.patch);
    for (const Vector3& p_W : points) {
      points_.contacts.push_back({p_W, normal_W, friction, static_cast<double>(points.size()) / load});
      points_.foot.push_back(f);
    }
  }

  const RobotModel& model_;
  const WholeBodyProblem& problem_;
  const double friction_use_;
  const std::vector<Polygon> support_F_;
  std::vector<LoadShare> loads_;
  PressingPoints points_;
};

}  // namespace

void AddContactForces(const RobotModel& model, const WholeBodyProblem& problem, const WholeBodyOptions& options,
                      WholeBodySolution& solution) {
  WholeBodyTrajectory& out = solution.trajectory;
  DynamicsScratch scratch(model);
  ContactSplitter splitter;
  ContactSplit split;
  PressingFeet feet(model, problem, options);
  VectorX tau;
  out.tau.clear();
  out.wrenches.clear();
  solution.zmp_W.clear();
  solution.pressure_W.clear();
  solution.residual_W.clear();
  solution.contact_W.assign(model.feet.size(), {});
  for (int k = 0; k < out.size(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    const double time_s = out.start_s + k * out.step_s;
    InverseDynamics(model, out.q[i], out.v[i], out.a[i], scratch, tau);
    const PressingPoints& pressing = feet.At(time_s, scratch);
    for (std::size_t f = 0; f < model.feet.size(); ++f) solution.contact_W[f].push_back(pressing.origin_W[f]);
    const GroundPlane plane = SupportPlaneAt(*problem.schedule, time_s, pressing.of_foot);
    const PointWrench needed{scratch.p_WB[0], tau.head<3>(), tau.segment<3>(3)};
    Split(pressing.contacts, needed, splitter, split);
    const PointWrench lacking{needed.p_W, split.residual_force_W, split.residual_moment_W};
    const PointWrench given{needed.p_W, needed.force_W - lacking.force_W, needed.moment_W - lacking.moment_W};
    const Vector2 below = CentreOfMass(model, scratch).head<2>();
    solution.zmp_W.push_back(ZmpOf(model, needed, plane, below));
    solution.pressure_W.push_back(ZmpOf(model, given, plane, below));
    solution.residual_W.push_back(lacking);
    std::vector<ContactWrench> wrenches(model.feet.size());
    for (std::size_t c = 0; c < pressing.contacts.size(); ++c) {
      const std::size_t f = pressing.foot[c];
      const Vector3& p_W = pressing.contacts[c].p_W;
      wrenches[f].force_W += split.force_W[c];
      wrenches[f].moment_W += (p_W - pressing.origin_W[f]).cross(split.force_W[c]);
      AddPointForce(model, scratch, model.feet[f].body, p_W, -split.force_W[c], tau);
    }
    out.tau.push_back(tau.tail(model.num_dofs()));
    out.wrenches.push_back(std::move(wrenches));
  }
}

std::vector<Vector2> HeldOverFlights(const std::vector<Vector2>& p_W, const std::vector<bool>& presses) {
  std::vector<std::size_t> pressing;
  for (std::size_t k = 0; k < presses.size(); ++k) {
    if (presses[k]) pressing.push_back(k);
  }
  std::vector<Vector2> held = p_W;
  std::size_t i = 0;
  for (std::size_t k = 0; k < held.size() && !pressing.empty(); ++k) {
    while (i + 1 < pressing.size() && pressing[i + 1] + pressing[i] <= 2 * k) ++i;
    held[k] = p_W[pressing[i]];
  }
  return held;
}

}  // namespace gaitwright
