// SPDX-License-Identifier: BSD-3-Clause
#include "playback/control/stance_feedback.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>

#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/model/body_tree.h"
#include "kinematics/spatial/rotation.h"
#include "kinematics/stability/holdable_support.h"
#include "kinematics/stability/zero_moment_point.h"
#include "playback/control/momentum_feedback.h"

namespace gaitwright {
namespace {

constexpr std::size_t kForce = 3;  // components of a force, and number of joints needed to push with all of them

}  // namespace

StanceFeedback::StanceFeedback(const RobotModel& model, const StabilisedOptions& options)
    : model_(model), options_(options), leg_of_(LegsOfDofs(model)), moved_weight_(model.nv()) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  inertia_B_ = LockedInertia(model, scratch).diagonal();
  for (const Leg& leg : model.legs) {
    std::set<int> dofs;
    for (const int joint : leg.joints) dofs.insert(model.joints[static_cast<std::size_t>(joint)].dof);
    if (dofs.size() < kForce) planar_ = true;
  }
}

void StanceFeedback::Update(const Situation& now, const Footing& footing, VectorX& tau,
                            const MomentumFeedback* predictive) {
  constexpr double kLeastPlanned = 0.1;  // of the weight: below it the plan is in the air
  // Share of the weight; some planned loads are smaller than the changes due to the motion of the legs.
  constexpr double kLeastShare = 0.03;
  contacts_.clear();
  contact_foot_.clear();
  usable_.clear();
  lifted_m_s2_ = 0.0;
  dcm_error_W_ = DivergentComponent(now.measured.p_WC, now.measured.v_WC, now.omega_rad_s) -
                 DivergentComponent(now.planned.p_WC, now.planned.v_WC, now.omega_rad_s);
  if (planar_) return;
  const PointWrench planned = PlannedWrench(now);
  if (now.bearing != 0 && planned.force_W.z() > kLeastPlanned * model_.weight_n()) {
    GatherContacts(now, planned.force_W.z());
    planned_zmp_W_ = ZeroMomentPoint(now.planned.p_WC, planned.force_W, planned.moment_W, now.support).head<2>();
    FindUsable(now, footing);
    const bool predicts = predictive != nullptr && predictive->active();
    const PointWrench wanted = predicts ? predictive->Wanted(now) : WantedWrench(now, footing, planned);
    lifted_m_s2_ = (wanted.force_W.z() - planned.force_W.z()) / model_.total_mass_kg;
    Split(now, wanted, predicts ? kLeastShare : 0.0);
  }
  AddTorques(now, tau);
  BearLegs(now, tau);
}

/// Wrench about the measured centre of mass. The attitude has priority: the moment is given, and the force puts the ZMP
/// at its wanted place.
PointWrench StanceFeedback::WantedWrench(const Situation& now, const Footing& footing,
                                         const PointWrench& planned) const {
  constexpr double kLeast = 0.3, kMost = 2.0;  // bounds of the normal force as shares of the weight
  // Shares of the planned normal force; the wider bounds apply.
  constexpr double kLeastPlanned = 0.5, kMostPlanned = 1.5;
  constexpr double kLow = 0.3;  // of the planned height: lower is a fall
  const double weight = model_.weight_n(), kz = options_.height_rad_s;
  const Vector3& p_WC = now.measured.p_WC;
  const Vector3 moment = WantedMoment(now, planned.moment_W);
  const double rise = now.planned.p_WC.z() + footing.mean_offset_W.z() - p_WC.z();
  const double rate = now.planned.v_WC.z() - now.measured.v_WC.z();
  const double lift = planned.force_W.z() + model_.total_mass_kg * kz * (kz * rise + 2.0 * rate);
  const double load = planned.force_W.z();
  const double normal =
      std::clamp(lift, std::min(kLeast * weight, kLeastPlanned * load), std::max(kMost * weight, kMostPlanned * load));
  const Vector2 zmp = ZmpFor(dcm_error_W_), arm = p_WC.head<2>() - zmp;
  double ground = 0.0;  // height under the ZMP: mean of the contacts, along the plan's plane
  for (const ContactPoint& point : contacts_)
    ground +=
        (point.p_W.z() + now.support.slope.dot(zmp - point.p_W.head<2>())) / static_cast<double>(contacts_.size());
  const double height = std::max(p_WC.z() - ground, kLow * (now.planned.p_WC.z() - now.ground_m));
  return {p_WC, {(arm.x() * normal - moment.y()) / height, (arm.y() * normal + moment.x()) / height, normal}, moment};
}

/// Distributes a wrench over the contacts. If several feet stand, each keeps a part of its planned load, so that
/// correcting the base attitude does not lift a foot. If more than two stand, each also keeps up to `least_share` of
/// the weight, until it is about to leave the ground.
void StanceFeedback::Split(const Situation& now, PointWrench wanted, double least_share) {
  constexpr double kKept = 0.1;      // of the load
  constexpr double kMost = 0.3;      // of the wanted normal force
  constexpr double kLeaving = 0.02;  // [s]
  const int feet = std::popcount(now.bearing);
  const double kept = feet > 1 ? kKept : 0.0;
  const double least =
      feet > 2 ? std::clamp(kMost * wanted.force_W.z() / feet, 0.0, least_share * model_.weight_n()) : 0.0;
  kept_W_.clear();
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    const int foot = contact_foot_[c];
    const auto points = static_cast<double>(std::count(contact_foot_.begin(), contact_foot_.end(), foot));
    const double load = std::max(now.sample.wrenches[static_cast<std::size_t>(foot)].force_W.z(), 0.0);
    const double staying = std::clamp((now.swings.At(foot, now.time_s).liftoff_s - now.time_s) / kLeaving, 0.0, 1.0);
    kept_W_.push_back(std::max(kept * load, staying * least) / points * contacts_[c].normal_W);
    wanted.force_W -= kept_W_[c];
    wanted.moment_W -= (contacts_[c].p_W - wanted.p_W).cross(kept_W_[c]);
  }
  splitter_.Solve(contacts_, wanted, split_);
  for (std::size_t c = 0; c < contacts_.size(); ++c) split_.force_W[c] += kept_W_[c];
}

PointWrench StanceFeedback::PlannedWrench(const Situation& now) const {
  PointWrench planned{now.planned.p_WC, Vector3::Zero(), Vector3::Zero()};
  for (std::size_t f = 0; f < now.sample.wrenches.size(); ++f) {
    const ContactWrench& wrench = now.sample.wrenches[f];
    const Vector3 arm = now.planned.X_WF[f].translation() - now.planned.p_WC;
    planned.force_W += wrench.force_W;
    planned.moment_W += wrench.moment_W + arm.cross(wrench.force_W);
  }
  return planned;
}

void StanceFeedback::GatherContacts(const Situation& now, double total_normal_n) {
  constexpr double kLeastShare = 1e-3;
  std::vector<Vector2> corners;
  for (int f = 0; f < static_cast<int>(model_.feet.size()); ++f) {
    if (!Contains(now.bearing, f)) continue;
    const double share =
        std::max(now.sample.wrenches[static_cast<std::size_t>(f)].force_W.z() / total_normal_n, kLeastShare);
    now.PointsAt(f, now.measured, points_);
    const GroundUnder& ground = now.swings.Under(f, now.time_s);
    for (const Vector3& p_W : points_) {
      contacts_.push_back({p_W, ground.normal_W, std::max(options_.friction_use * ground.friction, 0.05),
                           static_cast<double>(points_.size()) / share});
      contact_foot_.push_back(f);
      corners.push_back(p_W.head<2>());
    }
  }
  support_ = ConvexHull(corners);
}

/// The base keeps its planned attitude on any ground: a base that leaned with the soles would rock on bumps.
Vector3 StanceFeedback::WantedMoment(const Situation& now, const Vector3& planned_W) const {
  const Vector3 turn = RotationLog(now.planned.R_WB() * now.measured.R_WB().transpose());
  const Vector3 spin = now.planned.w_WB() - now.measured.w_WB();
  const double k = options_.attitude_rad_s;
  const Matrix3& R_WB = now.planned.R_WB();
  return planned_W + R_WB * inertia_B_.cwiseProduct(R_WB.transpose() * (k * k * turn + 2.0 * k * spin));
}

/// Finds the region in which the ZMP may be moved.
void StanceFeedback::FindUsable(const Situation& now, const Footing& footing) {
  const Vector2 home = NearestPoint(support_, planned_zmp_W_ + footing.mean_offset_W.head<2>());
  usable_ = support_;
  if (std::popcount(now.bearing) == 1) {
    usable_ = HoldableSupport(model_, now.measured.scratch, std::countr_zero(now.bearing), support_,
                              {now.measured.p_WC, model_.weight_n()}, options_.torque_use);
    usable_.push_back(home);
    usable_ = ConvexHull(usable_);
  }
  for (Vector2& corner : usable_) corner = home + options_.support_use * (corner - home);
}

Vector2 StanceFeedback::ZmpFor(const Vector2& dcm_error_W) const {
  return NearestPoint(usable_, planned_zmp_W_ + options_.dcm_gain * dcm_error_W);
}

StanceFeedback::Drift StanceFeedback::PredictedDrift(const Situation& now, double lookahead_s) const {
  constexpr int kSteps = 10;
  Drift drift{dcm_error_W_, (now.measured.p_WC - now.planned.p_WC).head<2>()};
  if (usable_.empty()) return drift;
  // With the ZMP moved by s for a time h:  xi' = s + (xi - s) e^{w h},  and the centre of mass follows the DCM.
  const double growth = std::exp(now.omega_rad_s * lookahead_s / kSteps);
  for (int i = 0; i < kSteps; ++i) {
    const Vector2 shift = ZmpFor(drift.dcm_W) - planned_zmp_W_, half = 0.5 * (drift.dcm_W - shift);
    drift.com_W = shift + half * growth + (drift.com_W - shift - half) / growth;
    drift.dcm_W = shift + 2.0 * half * growth;
  }
  return drift;
}

/// tau -= J^T f - J_planned^T f_planned
void StanceFeedback::AddTorques(const Situation& now, VectorX& tau) const {
  VectorX all = VectorX::Zero(model_.nv());
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    const Foot& foot = model_.feet[static_cast<std::size_t>(contact_foot_[c])];
    AddPointForce(model_, now.measured.scratch, foot.body, contacts_[c].p_W, -split_.force_W[c], all);
  }
  for (std::size_t f = 0; f < model_.feet.size(); ++f) {
    Vector6 wrench;
    wrench << now.sample.wrenches[f].force_W, now.sample.wrenches[f].moment_W;
    AddPointWrench(model_, now.planned.scratch, model_.feet[f].body, now.planned.X_WF[f].translation(), wrench, all);
  }
  tau += all.tail(model_.num_dofs());
}

/// A leg that is not at its planned place needs other weight torques, tau = g(q) - g(q_planned). Below an upright body,
/// the wrong weight torque brings the leg back and steadies the robot, so it is not corrected. It is corrected where it
/// pushes a leg farther away, as for heavy legs that sprawl near the ground.
void StanceFeedback::BearLegs(const Situation& now, VectorX& tau) {
  constexpr double kLeast = 1e-12;  // [rad^2]
  const Eigen::Index n = model_.num_dofs();
  moved_weight_.setZero();
  AddHeldWeight(model_, now.measured.scratch, 1.0, moved_weight_);
  AddHeldWeight(model_, now.planned.scratch, -1.0, moved_weight_);
  for (int leg = 0; leg < static_cast<int>(model_.legs.size()); ++leg) {
    double work = 0.0, square = 0.0;
    for (Eigen::Index dof = 0; dof < n; ++dof) {
      if (leg_of_[static_cast<std::size_t>(dof)] != leg) continue;
      const double off = now.measured.q[7 + dof] - now.planned.q[7 + dof];
      work += moved_weight_[6 + dof] * off;
      square += off * off;
    }
    if (work >= 0.0 || square < kLeast) continue;
    for (Eigen::Index dof = 0; dof < n; ++dof) {
      if (leg_of_[static_cast<std::size_t>(dof)] == leg)
        tau[dof] += work / square * (now.measured.q[7 + dof] - now.planned.q[7 + dof]);
    }
  }
}

}  // namespace gaitwright
