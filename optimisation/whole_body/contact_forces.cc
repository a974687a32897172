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
constexpr double kRestRamp = 0.3;   // of a foot's ramp: what is to lie down does not hover
constexpr double kRestLoad = 20.0;  // of what a foot carries: legs of a robot that lies are nearly limp

/// Share of its load that a foot bears at a time: rises from 0 after touch-down and falls to 0 before lift-off.
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
  static constexpr double kTiny = 1e-9;  // [s] that a time may be off the grid by rounding
  struct Ramp {
    ContactInterval interval;
    double rise_s, fall_s;
  };
  std::vector<Ramp> ramps_;
};

/// The split over the contacts; over none, nothing is given.
void Split(const std::vector<ContactPoint>& contacts, const PointWrench& needed, ContactSplitter& splitter,
           ContactSplit& split) {
  if (!contacts.empty()) return splitter.Solve(contacts, needed, split);
  split.force_W.clear();
  split.residual_force_W = needed.force_W;
  split.residual_moment_W = needed.moment_W;
}

/// On a plane, of a wrench that presses on it; else a given point.
Vector2 ZmpOf(const RobotModel& model, const PointWrench& wrench, const GroundPlane& plane, const Vector2& otherwise) {
  constexpr double kPresses = 0.01;  // of the weight
  if (wrench.force_W.z() < kPresses * model.weight_n()) return otherwise;
  return ZeroMomentPoint(wrench.p_W, wrench.force_W, wrench.moment_W, plane).head<2>();
}

}  // namespace

void AddContactForces(const RobotModel& model, const WholeBodyProblem& problem, const WholeBodyOptions& options,
                      WholeBodySolution& solution) {
  WholeBodyTrajectory& out = solution.trajectory;
  DynamicsScratch scratch(model);
  ContactSplitter splitter;
  ContactSplit split;
  std::vector<LoadShare> loads;
  const int num_feet = static_cast<int>(model.feet.size());
  for (int f = 0; f < num_feet; ++f) {
    const bool rests = f >= static_cast<int>(model.legs.size());
    loads.emplace_back(*problem.schedule, f, (rests ? kRestRamp : 1.0) * options.load_ramp_s);
  }
  const std::vector<Polygon> support_F = SupportsOf(model, *problem.terrain, *problem.footsteps);
  ContactsByFoot points(model.feet.size());
  std::vector<Vector3> origin(model.feet.size());
  std::vector<ContactPoint> contacts;
  std::vector<int> foot_of;
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
    contacts.clear();
    foot_of.clear();
    for (int f = 0; f < num_feet; ++f) {
      const auto foot = static_cast<std::size_t>(f);
      const int at = FootholdAt(*problem.footsteps, f, time_s);
      if (at < 0) {  // a rest that is never lain on
        solution.contact_W[foot].emplace_back(Vector3::Zero());
        continue;
      }
      const auto index = static_cast<std::size_t>(at);
      const Foothold& foothold = problem.footsteps->footholds[index];
      const Vector3 normal_W = foothold.X_WF.linear().col(2);
      const Pose X_WF = ContactFrame(model, scratch, f, normal_W);
      origin[foot] = X_WF.translation();
      points[foot].clear();
      for (const Vector2& p_F : support_F[index]) points[foot].push_back(X_WF * Vector3(p_F.x(), p_F.y(), 0.0));
      solution.contact_W[foot].push_back(origin[foot]);
      double load = loads[foot].At(time_s);
      if (load <= 0.0) continue;
      if (problem.load) load = std::max(kLeastLoad, problem.load(f, time_s));
      if (foot >= model.legs.size()) load *= kRestLoad;
      const double friction = options.friction_use * FrictionOf(*problem.terrain, foothold.patch);
      for (const Vector3& p_W : points[foot]) {
        contacts.push_back({p_W, normal_W, friction, static_cast<double>(points[foot].size()) / load});
        foot_of.push_back(f);
      }
    }
    const GroundPlane plane = SupportPlaneAt(*problem.schedule, time_s, points);
    const PointWrench needed{scratch.p_WB[0], tau.head<3>(), tau.segment<3>(3)};
    Split(contacts, needed, splitter, split);
    const PointWrench lacking{needed.p_W, split.residual_force_W, split.residual_moment_W};
    const PointWrench given{needed.p_W, needed.force_W - lacking.force_W, needed.moment_W - lacking.moment_W};
    const Vector2 below = CentreOfMass(model, scratch).head<2>();
    solution.zmp_W.push_back(ZmpOf(model, needed, plane, below));
    solution.pressure_W.push_back(ZmpOf(model, given, plane, below));
    solution.residual_W.push_back(lacking);
    std::vector<ContactWrench> wrenches(static_cast<std::size_t>(num_feet));
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      const auto f = static_cast<std::size_t>(foot_of[c]);
      wrenches[f].force_W += split.force_W[c];
      wrenches[f].moment_W += (contacts[c].p_W - origin[f]).cross(split.force_W[c]);
      AddPointForce(model, scratch, model.feet[f].body, contacts[c].p_W, -split.force_W[c], tau);
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
