// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/lowest_reach.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinematics/model/find_feet.h"

namespace gaitwright {
namespace {

/// A chain with the positions of its joints.
class ChainAt {
 public:
  ChainAt(const RobotModel& model, const std::vector<int>& chain) {
    for (const int j : chain) joints_.push_back(&model.joints[static_cast<std::size_t>(j)]);
    for (const Joint* joint : joints_) positions_.push_back(std::clamp(0.0, joint->lower, joint->upper));
    axes_.resize(joints_.size());
    origins_.resize(joints_.size());
    Place();
  }

  std::size_t size() const { return joints_.size(); }
  double height() const { return end_.z(); }

  /// Moves one joint to the position at which the end is lowest.
  void Lower(std::size_t i) {
    positions_[i] = joints_[i]->is_prismatic() ? LowestSlide(i) : LowestTurn(i);
    Place();
  }

 private:
  void Place() {
    Pose X = Pose::Identity();
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      const Joint& joint = *joints_[i];
      X = X * joint.X_PJ;
      axes_[i] = X.linear() * joint.axis_J;
      origins_[i] = X.translation();
      if (joint.is_prismatic()) {
        X.translation() += positions_[i] * axes_[i];
      } else {
        X.linear() = X.linear() * Eigen::AngleAxisd(positions_[i], joint.axis_J).toRotationMatrix();
      }
    }
    end_ = X.translation();
  }

  double LowestSlide(std::size_t i) const {
    constexpr double kLevel = 1e-9;
    if (std::abs(axes_[i].z()) < kLevel) return positions_[i];
    const double there = axes_[i].z() > 0.0 ? joints_[i]->lower : joints_[i]->upper;
    return std::isfinite(there) ? there : positions_[i];
  }

  /// If the joint rotates by t, the height of the end is a constant + c cos t + s sin t.
  double LowestTurn(std::size_t i) const {
    const Vector3& axis = axes_[i];
    const Vector3 arm = end_ - origins_[i];
    const double c = arm.z() - axis.dot(arm) * axis.z(), s = axis.cross(arm).z();
    constexpr double kLevel = 1e-12;
    if (std::hypot(c, s) < kLevel) return positions_[i];
    const double from = joints_[i]->lower - positions_[i], to = joints_[i]->upper - positions_[i];
    double best = std::atan2(-s, -c);
    if (best < from) best += 2.0 * std::numbers::pi;
    if (best > to) best -= 2.0 * std::numbers::pi;
    if (best < from || best > to) {
      const auto height = [&](double t) { return c * std::cos(t) + s * std::sin(t); };
      best = height(from) < height(to) ? from : to;
    }
    return positions_[i] + best;
  }

  std::vector<const Joint*> joints_;
  std::vector<double> positions_;
  std::vector<Vector3> axes_, origins_;
  Vector3 end_ = Vector3::Zero();
};

}  // namespace

double LowestReach(const RobotModel& model, const std::vector<int>& chain) {
  constexpr int kMostSweeps = 100;
  constexpr double kGain = 1e-6;  // [m]
  ChainAt at(model, chain);
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    const double before = at.height();
    for (std::size_t i = at.size(); i-- > 0;) at.Lower(i);
    if (at.height() > before - kGain) break;
  }
  return at.height() - FarthestExtent(model, chain.back() + 1);
}

}  // namespace gaitwright
