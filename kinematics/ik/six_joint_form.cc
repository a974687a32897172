// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/ik/six_joint_form.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "kinematics/ik/axis_rotations.h"

namespace gaitwright {
namespace {

/// The point nearest to several lines, and its largest distance to one of them.
struct Crossing {
  Vector3 point = Vector3::Zero();
  double misfit_m = 0.0;
};

Crossing CrossingOf(const std::array<Vector3, 6>& axes, const std::array<Vector3, 6>& points, std::size_t first,
                    std::size_t last) {
  Matrix3 normal = Matrix3::Zero();
  Vector3 rhs = Vector3::Zero();
  for (std::size_t i = first; i <= last; ++i) {
    const Matrix3 across = Matrix3::Identity() - axes[i] * axes[i].transpose();
    normal += across;
    rhs += across * points[i];
  }
  Crossing crossing{normal.fullPivLu().solve(rhs), 0.0};
  for (std::size_t i = first; i <= last; ++i) {
    crossing.misfit_m = std::max(crossing.misfit_m, axes[i].cross(crossing.point - points[i]).norm());
  }
  return crossing;
}

/// = Notation =  the chain from its three-axis end: E_1 E_2 E_3 about H, E_4 the knee, E_5 E_6 about A, = G.
class SixJointForm : public LegClosedForm {
 public:
  /// @param reversed  uses the chain from the foot: G^-1 = E_6^-1 ... E_1^-1.
  SixJointForm(const LegChain& chain, bool reversed) : reversed_(reversed), X_FB_zero_(chain.X_BF_zero.inverse()) {
    std::array<Vector3, 6> points;
    for (std::size_t i = 0; i < 6; ++i) {
      const LegChain::Link& link = chain.links[reversed ? 5 - i : i];
      axes_[i] = reversed ? Vector3(-link.axis_B) : link.axis_B;
      points[i] = link.point_B;
    }
    const double meeting =
        std::min({axes_[0].cross(axes_[1]).norm(), axes_[1].cross(axes_[2]).norm(), axes_[4].cross(axes_[5]).norm()});
    if (meeting < 0.1) return;  // neighbours nearly parallel
    const Crossing hip = CrossingOf(axes_, points, 0, 2), ankle = CrossingOf(axes_, points, 4, 5);
    misfit_ = std::max(hip.misfit_m, ankle.misfit_m) / chain.length_m;
    hip_ = hip.point;
    ankle_ = ankle.point;
    thigh_ = hip_ - points[3];
    shank_ = ankle_ - points[3];
    constexpr double kLeast = 1e-3;  // smallest length of thigh and shank over the leg's length
    fits_ = misfit_ < kMisfit &&
            std::min(axes_[3].cross(thigh_).norm(), axes_[3].cross(shank_).norm()) > kLeast * chain.length_m;
  }
  bool fits() const { return fits_; }
  int knee() const override { return reversed_ ? 2 : 3; }
  double straight_rad() const override { return AngleAbout(axes_[3], shank_, -thigh_, 0.0); }
  double misfit() const override { return misfit_; }

  LegBranches Branches(const Pose& X_BF, const Vector6& any) const override {
    const Pose G = Motion(X_BF);
    const Vector6 keep = reversed_ ? Vector6(any.reverse()) : any;
    LegBranches found;
    found.turn_gap_rad = std::numeric_limits<double>::infinity();
    const Vector3 hip_seen = G.linear().transpose() * (hip_ - G.translation()) - ankle_;
    const Angles knees = AnglesToDistance(axes_[3], shank_, thigh_, hip_seen.norm(), keep[3]);
    for (std::size_t k = 0; k < static_cast<std::size_t>(knees.count); ++k) {
      BendAnkle(G.linear(), hip_seen, knees.rad[k], keep, found);
    }
    if (found.count > 0 || knees.count == 0) found.turn_gap_rad = 0.0;
    if (reversed_) {
      for (std::size_t i = 0; i < found.count; ++i) found.positions[i].reverseInPlace();
    }
    return found;
  }

  ReachGap Gap(const Pose& X_BF) const override {
    const Pose G = Motion(X_BF);
    const double along = axes_[3].dot(thigh_) - axes_[3].dot(shank_);
    const double thigh = axes_[3].cross(thigh_).norm(), shank = axes_[3].cross(shank_).norm();
    const double distance = (G * ankle_ - hip_).norm();
    const double farthest = std::hypot(thigh + shank, along), nearest = std::hypot(thigh - shank, along);
    constexpr double kReached = 1e-12;
    if (distance > farthest + kReached) return {ReachGap::Kind::kTooFar, distance - farthest, 0.0};
    if (distance < nearest - kReached) return {ReachGap::Kind::kTooNear, nearest - distance, 0.0};
    const double turn = Branches(X_BF, Vector6::Zero()).turn_gap_rad;
    return turn > 0.0 ? ReachGap{ReachGap::Kind::kTurned, 0.0, turn} : ReachGap{};
  }

 private:
  Pose Motion(const Pose& X_BF) const {
    const Pose G = X_BF * X_FB_zero_;
    return reversed_ ? G.inverse() : G;
  }

  /// The two angles at A that bring the hip to its position relative to the foot, then the three angles of the hip.
  void BendAnkle(const Matrix3& R, const Vector3& hip_seen, double knee_rad, const Vector6& any,
                 LegBranches& found) const {
    const Vector3 hip_from_shank = Turned(axes_[3], -knee_rad, thigh_) - shank_;
    const TwoTurns ankles = TurnOnto(-axes_[5], -axes_[4], hip_from_shank, hip_seen, Vector2(any[5], any[4]));
    if (ankles.count == 0) {
      found.turn_gap_rad = std::min(found.turn_gap_rad, TurnGap(-axes_[5], -axes_[4], hip_from_shank, hip_seen));
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(ankles.count); ++i) {
      const Matrix3 R_hip = R * Eigen::AngleAxisd(-ankles.first[i], axes_[5]) *
                            Eigen::AngleAxisd(-ankles.second[i], axes_[4]) * Eigen::AngleAxisd(-knee_rad, axes_[3]);
      const ThreeTurns hips = DecomposeRotation({axes_[0], axes_[1], axes_[2]}, R_hip, any.head<3>());
      if (hips.count == 0) {
        found.turn_gap_rad = std::min(found.turn_gap_rad, TurnGap(axes_[0], axes_[1], axes_[2], R_hip * axes_[2]));
      }
      for (std::size_t h = 0; h < static_cast<std::size_t>(hips.count); ++h) {
        found.positions[found.count++] << hips.rad[h], knee_rad, ankles.second[i], ankles.first[i];
      }
    }
  }

  bool reversed_ = false, fits_ = false;
  Pose X_FB_zero_;
  std::array<Vector3, 6> axes_;
  Vector3 hip_ = Vector3::Zero(), ankle_ = Vector3::Zero();
  Vector3 thigh_ = Vector3::Zero(), shank_ = Vector3::Zero();  // from the knee to hip and ankle, at zero
  double misfit_ = 0.0;
};

}  // namespace

std::shared_ptr<const LegClosedForm> FitSixJointForm(const LegChain& chain) {
  if (chain.links.size() != 6 || chain.num_rows != 6 || !chain.IsPlain()) return nullptr;
  for (const bool reversed : {false, true}) {
    auto form = std::make_shared<SixJointForm>(chain, reversed);
    if (form->fits()) return form;
  }
  return nullptr;
}

}  // namespace gaitwright
