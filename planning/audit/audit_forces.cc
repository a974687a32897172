// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "kinematics/stability/polygon.h"
#include "kinematics/stability/wrench_cone.h"
#include "kinematics/stability/zero_moment_point.h"
#include "planning/audit/auditor.h"
#include "planning/audit/tolerances.h"
#include "planning/plan/heel_off_internal.h"

namespace gaitwright {

using namespace tolerance;

void Auditor::CheckDynamics(double time_s) {
  VectorX residual = needed_;
  for (int f = 0; f < static_cast<int>(model_.feet.size()); ++f) {
    const ContactWrench& wrench = sample_.wrenches[static_cast<std::size_t>(f)];
    Vector6 w;
    w << -wrench.force_W, -wrench.moment_W;
    AddPointWrench(model_, scratch_, model_.feet[static_cast<std::size_t>(f)].body,
                   X_WF_[static_cast<std::size_t>(f)].translation(), w, residual);
  }
  residual.tail(model_.num_dofs()) -= sample_.tau;
  const double force_limit = kResidualShare * model_.weight_n();
  const double moment_limit = force_limit * com_height_m_;
  const double force = residual.head<3>().norm(), moment = residual.segment<3>(3).norm();
  forces_hold_ = force <= kCertain * model_.weight_n() && moment <= kCertain * model_.weight_n() * com_height_m_;
  if (!flies_ && !Hanging(time_s)) {  // CheckFlight judges flights
    findings_.Hold(places_.base_force, time_s, force, force_limit, force_limit - force);
    findings_.Hold(places_.base_moment, time_s, moment, moment_limit, moment_limit - moment);
  }
  for (int d = 0; d < model_.num_dofs(); ++d) {
    const double effort = std::abs(residual[6 + d]);
    const double limit =
        std::min(Slides(d) ? force_limit : moment_limit, kEffortShare * efforts_[static_cast<std::size_t>(d)]);
    findings_.Hold(places_.residual[static_cast<std::size_t>(d)], time_s, effort, limit, limit - effort);
  }
}

/// Whether a foot is in swing from one plan step before a time to one step after it. Forces are linear between rows, so
/// a force that jumps at touch-down is non-zero in the last step of the swing.
bool Auditor::SwingsThroughout(int foot, double time_s) const {
  const double step = plan_.whole_body.step_s;
  for (const double t : {time_s - step, time_s, time_s + step}) {
    if (Contains(plan_.schedule.phases[static_cast<std::size_t>(PhaseAt(plan_.schedule, t))].stance, foot))
      return false;
  }
  return true;
}

/// Allowed distance of a centre of pressure from its support. A sole on its edge turns fast while wrenches are linear
/// between rows: the edge is a line, and at a small load a negligible moment moves the centre of pressure far.
double Auditor::PressureSlack(int foot, double normal_n, double time_s) const {
  const int index = footing_[static_cast<std::size_t>(foot)].foothold;
  if (index < 0 || !StandsOnEdge(plan_.footsteps.footholds[static_cast<std::size_t>(index)], time_s))
    return kPressureSlack;
  return std::max(kSupportLine, kCertain * com_height_m_ * model_.weight_n() / normal_n);
}

void Auditor::CheckContactForces(double time_s) {
  const double slack = kRelative * model_.weight_n();
  for (int f = 0; f < static_cast<int>(model_.feet.size()); ++f) {
    const ContactWrench& wrench = sample_.wrenches[static_cast<std::size_t>(f)];
    const Pose& X_WF = X_WF_[static_cast<std::size_t>(f)];
    const Footing& ground = footing_[static_cast<std::size_t>(f)];
    const double normal = wrench.force_W.dot(ground.normal_W);
    const double tangential = (wrench.force_W - normal * ground.normal_W).norm();
    if (!(normal >= -slack)) findings_.Note(Law::kUnilateral, FootName(f), time_s, normal, 0.0, "N");
    const double cone = ground.friction * std::max(normal, 0.0);
    forces_hold_ = forces_hold_ && normal >= -slack && tangential <= cone + slack;
    if (!(tangential <= cone + slack)) findings_.Note(Law::kFrictionCone, FootName(f), time_s, tangential, cone, "N");
    const auto place = static_cast<std::size_t>(f);
    if (normal >= kLeastLoad * model_.weight_n()) {
      const double used = tangential / normal;
      findings_.Near(places_.friction[place], time_s, used, ground.friction, ground.friction - used);
    }
    if (Contains(stance_, f) && InMiddle(f, time_s, true))
      findings_.Near(places_.press[place], time_s, normal, 0.0, normal);
    if (normal > kSwingLoad * model_.weight_n() && SwingsThroughout(f, time_s)) {
      findings_.Note(Law::kConsistency, FootName(f) + " pushes in its swing", time_s, normal, 0.0, "N");
    }
    const Foot& foot = model_.feet[static_cast<std::size_t>(f)];
    if (foot.sole_F.empty() || normal < kLeastLoad * model_.weight_n()) continue;
    const Vector3 moment_F = X_WF.linear().transpose() * wrench.moment_W;
    const double normal_F = X_WF.linear().col(2).dot(wrench.force_W);
    const double outside = -SignedDistance(SupportNow(f, time_s), Vector2(-moment_F.y(), moment_F.x()) / normal_F);
    const double slack_m = PressureSlack(f, normal_F, time_s);
    forces_hold_ = forces_hold_ && outside <= slack_m;
    findings_.Near(places_.edge[place], time_s, outside, slack_m, slack_m - outside);
    if (outside > slack_m)
      findings_.Note(Law::kUnilateral, FootName(f) + " centre of pressure outside", time_s, outside, slack_m, "m");
  }
}

namespace {

/// Largest vertical distance of the points of a stance from a plane [m].
double FarthestFrom(const GroundPlane& plane, const ContactsByFoot& points, FootSet stance) {
  double farthest = 0.0;
  for (std::size_t f = 0; f < points.size(); ++f) {
    if (!Contains(stance, static_cast<int>(f))) continue;
    for (const Vector3& p : points[f]) farthest = std::max(farthest, std::abs(p.z() - plane.HeightAt(p.head<2>())));
  }
  return farthest;
}

}  // namespace

/// Contacts that are not in one plane have no ZMP. In that case the plan's contact forces must give the needed wrench;
/// otherwise the margin in the contact wrench cone shows whether any contact forces can give it.
void Auditor::CheckWrenchCone(double time_s) {
  if (forces_hold_) return;
  std::vector<ContactPoint> contacts;
  for (std::size_t f = 0; f < points_.size(); ++f) {
    if (!Contains(stance_, static_cast<int>(f)) || !(footing_[f].friction > 0.0)) continue;
    for (const Vector3& p : points_[f]) contacts.push_back({p, footing_[f].normal_W, footing_[f].friction, 1.0});
  }
  if (contacts.empty()) return;
  constexpr double kFarthest = 10.0;  // [m] reported if no contact force can give the wrench
  const PointWrench needed{scratch_.p_WB[0], needed_.head<3>(), needed_.segment<3>(3)};
  const double outside = std::min(-WrenchConeMargin(contacts, needed), kFarthest);
  if (!(outside <= kSupportLine))
    findings_.Note(Law::kZmpSupport, "contact wrench cone", time_s, outside, kSupportLine, "m");
}

bool Auditor::PressesOn(const GroundPlane& plane) const {
  const double least = kLeastLoad * model_.weight_n();
  return needed_[2] > least && needed_[2] - plane.slope.dot(needed_.head<2>()) > least;
}

/// Whether the contacts of the stance are in a plane and can only press on it. Feet on both sides of a ridge have
/// contact points in one plane, but can push against each other, so a ZMP outside of their hull is possible.
bool Auditor::AllPressOn(const GroundPlane& plane) const {
  if (FarthestFrom(plane, points_, stance_) > kCoplanar) return false;
  const Vector3 normal_W = Vector3(-plane.slope.x(), -plane.slope.y(), 1.0).normalized();
  for (std::size_t f = 0; f < footing_.size(); ++f) {
    if (!Contains(stance_, static_cast<int>(f))) continue;
    // The side of the friction cone has the same angle to its axis as the plane to its normal.
    const double along = normal_W.dot(footing_[f].normal_W), across = normal_W.cross(footing_[f].normal_W).norm();
    if (along < footing_[f].friction * across) return false;
  }
  return true;
}

void Auditor::CheckZmp(double time_s) {
  std::vector<Vector2> corners;
  for (int f = 0; f < static_cast<int>(model_.feet.size()); ++f) {
    if (!Contains(stance_, f)) continue;
    for (const Vector3& p : points_[static_cast<std::size_t>(f)]) corners.push_back(p.head<2>());
  }
  if (corners.empty() || needed_[2] < kLeastLoad * model_.weight_n()) return;
  if (!PressesOn(plane_) || !AllPressOn(plane_)) return CheckWrenchCone(time_s);
  const Vector2 zmp = ZeroMomentPoint(scratch_.p_WB[0], needed_.head<3>(), needed_.segment<3>(3), plane_).head<2>();
  const Polygon support = ConvexHull(corners);
  const double outside = -SignedDistance(support, zmp);
  const bool has_area = Area(support) > 1e-3 * (support[0] - support[support.size() / 2]).norm();
  // At a change of stance, the sample may belong to either stance.
  // At small vertical force, a negligible moment moves the ZMP far.
  const double slight = kCertain * com_height_m_ * model_.weight_n() / needed_[2];
  const double limit = has_area && !at_switch_ ? 1e-6 : std::max(kSupportLine, slight);
  findings_.Hold(places_.zmp, time_s, outside, limit, limit - outside);
  if (plan_.centroidal.size() != plan_.whole_body.size()) return;
  if (between_stances_) return;  // between rows of different stances, the reference may be of neither
  // With feet at several heights, the reference is in another plane.
  if (FarthestFrom(SupportPlaneAt(plan_.schedule, time_s, points_), points_, stance_) > kCoplanar) return;
  const double reference = -SignedDistance(support, SampleCentroidal(plan_.centroidal, time_s).p_WZ);
  findings_.Hold(places_.reference, time_s, reference, kReferenceSlack, kReferenceSlack - reference);
}

}  // namespace gaitwright
