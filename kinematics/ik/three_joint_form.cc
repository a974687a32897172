// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/ik/three_joint_form.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinematics/ik/axis_rotations.h"

namespace gaitwright {
namespace {

class ThreeJointForm : public LegClosedForm {
 public:
  explicit ThreeJointForm(const LegChain& chain) : foot_(chain.X_BF_zero.translation()) {
    for (std::size_t i = 0; i < 3; ++i) {
      axes_[i] = chain.links[i].axis_B;
      points_[i] = chain.links[i].point_B;
    }
    misfit_ = axes_[1].cross(axes_[2]).norm();
    thigh_ = points_[1] - points_[2];
    shank_ = foot_ - points_[2];
    height_ = axes_[2].dot(foot_);
    const double thigh = axes_[2].cross(thigh_).norm(), shank = axes_[2].cross(shank_).norm();
    longest_ = thigh + shank;
    shortest_ = std::abs(thigh - shank);
    constexpr double kLeast = 1e-3;  // smallest length of thigh and shank over the leg's length
    fits_ =
        misfit_ < kMisfit && axes_[0].cross(axes_[1]).norm() > 0.1 && std::min(thigh, shank) > kLeast * chain.length_m;
  }
  bool fits() const { return fits_; }
  int knee() const override { return 2; }
  double straight_rad() const override { return AngleAbout(axes_[2], shank_, -thigh_, 0.0); }
  double misfit() const override { return misfit_; }

  LegBranches Branches(const Pose& X_BF, const Vector6& any) const override {
    LegBranches found;
    const Vector3 target = X_BF.translation() - points_[0];
    const Angles abductions = AnglesToHeight(-axes_[0], target, axes_[2], height_ - axes_[2].dot(points_[0]), any[0]);
    for (std::size_t i = 0; i < static_cast<std::size_t>(abductions.count); ++i) {
      const Vector3 reach = BackAboutFirst(target, abductions.rad[i]);
      const Angles knees = AnglesToDistance(axes_[2], shank_, thigh_, reach.norm(), any[2]);
      for (std::size_t k = 0; k < static_cast<std::size_t>(knees.count); ++k) {
        const Vector3 bent = Turned(axes_[2], knees.rad[k], shank_) - thigh_;
        Vector6& positions = found.positions[found.count++];
        positions.setZero();
        positions.head<3>() << abductions.rad[i], AngleAbout(axes_[1], bent, reach, any[1]), knees.rad[k];
      }
    }
    return found;
  }

  /// The smallest distance over all planes of the first joint, by a scan and a golden-section search.
  ReachGap Gap(const Pose& X_BF) const override {
    if (Branches(X_BF, Vector6::Zero()).count > 0) return {};
    const Vector3 target = X_BF.translation() - points_[0];
    const auto cost = [&](double angle_rad) { return Missing(target, angle_rad).norm(); };
    constexpr int kScan = 180;
    const double step = 2.0 * std::numbers::pi / kScan;
    double best = 0.0;
    for (int i = 1; i < kScan; ++i) best = cost(i * step) < cost(best) ? i * step : best;
    double low = best - step, high = best + step;
    for (int i = 0; i < 60; ++i) {
      const double part = (high - low) / std::numbers::phi;
      if (cost(high - part) < cost(low + part)) {
        high = low + part;
      } else {
        low = high - part;
      }
    }
    const Vector2 missing = Missing(target, 0.5 * (low + high));
    constexpr double kReached = 1e-12;
    const auto kind = missing[1] > kReached    ? ReachGap::Kind::kTooFar
                      : missing[1] < -kReached ? ReachGap::Kind::kTooNear
                                               : ReachGap::Kind::kTooNearAxis;
    return {kind, missing.norm(), 0.0};
  }

 private:
  /// From the hip to the target, after the inverse rotation of the target about the first axis.
  Vector3 BackAboutFirst(const Vector3& target, double angle_rad) const {
    return Turned(-axes_[0], angle_rad, target) + points_[0] - points_[1];
  }

  /// Error for an angle of the first joint [m]: along the pitch axis, and in the plane. The latter is positive beyond
  /// the longest leg and negative within the shortest leg.
  Vector2 Missing(const Vector3& target, double angle_rad) const {
    const Vector3 reach = BackAboutFirst(target, angle_rad);
    const double along = axes_[2].dot(reach);
    const double across = (reach - along * axes_[2]).norm();
    const double radial = across > longest_ ? across - longest_ : std::min(across - shortest_, 0.0);
    return {along - (height_ - axes_[2].dot(points_[1])), radial};
  }

  std::array<Vector3, 3> axes_, points_;
  Vector3 foot_, thigh_, shank_;  // thigh and shank from the knee
  double height_ = 0.0, longest_ = 0.0, shortest_ = 0.0, misfit_ = 0.0;
  bool fits_ = false;
};

}  // namespace

std::shared_ptr<const LegClosedForm> FitThreeJointForm(const LegChain& chain) {
  if (chain.links.size() != 3 || chain.num_rows != 3 || !chain.IsPlain()) return nullptr;
  auto form = std::make_shared<ThreeJointForm>(chain);
  return form->fits() ? form : nullptr;
}

}  // namespace gaitwright
