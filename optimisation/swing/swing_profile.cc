// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/swing/swing_profile.h"

#include <algorithm>
#include <cmath>

#include "kinematics/spatial/rotation.h"
#include "kinematics/trajectory/bspline.h"
#include "kinematics/trajectory/swing_curve.h"

namespace gaitwright {
namespace {

constexpr double kStep = 0.002, kBeyond = 0.1, kShortest = 1e-3;  // [m]

/// Share of the sideways offset at a fraction of the swing, if all free control points are equal.
double SidewaysShare(int control_points, double u) {
  const QuinticBasis basis = EvaluateQuinticBasis(control_points, u);
  double share = 0.0;
  for (int i = 0; i < 6; ++i) {
    const int point = basis.first + i;
    if (point >= kFixedSwingPoints && point < control_points - kFixedSwingPoints)
      share += basis.value[static_cast<std::size_t>(i)];
  }
  return share;
}

/// Fraction of a straight swing at which it has covered a share of its path.
double FractionAt(double share, double cruise) {
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (SmoothStep(middle, cruise).value < share ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

Vector2 RollAt(const RefineChoice& choice, double share, double cruise) {
  return choice.roll.At(FractionAt(share, cruise)).head<2>();
}

}  // namespace

SwingProfile::SwingProfile(const SwingCurve& swing, const std::vector<Vector3>& underside_F, const GroundHeight& ground,
                           const RefineChoice& choice) {
  const Vector3 travel = swing.X_WF_end.translation() - swing.X_WF_start.translation();
  length_m_ = travel.head<2>().norm();
  if (length_m_ > kShortest) along_W_ = travel.head<2>() / length_m_;
  if (length_m_ <= kShortest && !choice.reach.empty()) along_W_ = Vector2::UnitX();
  Look(swing, underside_F, ground, choice);
  Widen();
  LimitSlope(swing.X_WF_start.translation().z(), swing.X_WF_end.translation().z());
}

/// Fills the table with the ground under the path.
void SwingProfile::Look(const SwingCurve& swing, const std::vector<Vector3>& underside_F, const GroundHeight& ground,
                        const RefineChoice& choice) {
  constexpr double kDeep = 1.0;  // used without ground
  const Vector2 sideways_W = choice.sideways_m * left_W();
  const Vector3 turn = RotationLog(swing.X_WF_end.linear() * swing.X_WF_start.linear().transpose());
  const double floor_m = std::min(swing.X_WF_start.translation().z(), swing.X_WF_end.translation().z()) - kDeep;
  const int count = 1 + static_cast<int>(std::ceil((length_m_ + 2.0 * kBeyond) / kStep));
  for (int i = 0; i < count; ++i) {
    const double s = i * kStep - kBeyond;
    const double share = length_m_ > kShortest ? std::clamp(s / length_m_, 0.0, 1.0) : 0.5;
    const Matrix3 R_WF = RotationExp(share * turn) * swing.X_WF_start.linear();
    const double lateral =
        choice.sideways_m == 0.0 ? 0.0 : SidewaysShare(choice.control_points, FractionAt(share, swing.cruise));
    const Vector2 off_W = lateral * sideways_W + left_W().dot(RollAt(choice, share, swing.cruise)) * left_W();
    const Vector2 p_W = swing.X_WF_start.translation().head<2>() + s * along_W_ + off_W;
    double height = floor_m;
    for (const Vector3& q_F : underside_F) {
      const Vector3 q_W = R_WF * q_F;
      height = std::max(height, ground(p_W + q_W.head<2>()) - q_W.z());
    }
    height_m_.push_back(height);
  }
}

std::pair<double, double> SwingProfile::Highest(double s, double reach) const {
  return std::max({At(s - reach), At(s), At(s + reach)});
}

std::pair<double, double> SwingProfile::At(double s) const {
  const double place = std::clamp((s + kBeyond) / kStep, 0.0, static_cast<double>(height_m_.size()) - 1.001);
  const auto i = static_cast<std::size_t>(place);
  const double slope = (height_m_[i + 1] - height_m_[i]) / kStep;
  return {height_m_[i] + (place - static_cast<double>(i)) * kStep * slope, slope};
}

/// Whether a row is nearest to the start or the end of the path.
bool SwingProfile::IsEnd(std::size_t row) const {
  const double s = static_cast<double>(row) * kStep - kBeyond;
  return std::min(std::abs(s), std::abs(s - length_m_)) < 0.5 * kStep;
}

/// Moves each edge between two rows to the farther row, so that no height in the table is too low.
void SwingProfile::Widen() {
  const std::vector<double> own = height_m_;
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (i > 0 && !IsEnd(i)) height_m_[i] = std::max(height_m_[i], own[i - 1]);
    if (i + 1 < own.size() && !IsEnd(i)) height_m_[i] = std::max(height_m_[i], own[i + 1]);
  }
}

/// Raises the table where its slope is too steep, without changing start and end.
void SwingProfile::LimitSlope(double start_z, double end_z) {
  constexpr double kGentle = 2.0, kSteepest = 40.0;
  double slope = kGentle;
  for (const auto& [at_s, z] : {std::pair{0.0, start_z}, std::pair{length_m_, end_z}}) {
    for (std::size_t i = 0; i < height_m_.size(); ++i) {
      const double away = std::abs(static_cast<double>(i) * kStep - kBeyond - at_s), above = height_m_[i] - z;
      if (away > kStep && above > 0.0) slope = std::max(slope, above / (away - kStep));
    }
  }
  const double drop = std::min(slope, kSteepest) * kStep;
  for (std::size_t i = 1; i < height_m_.size(); ++i) height_m_[i] = std::max(height_m_[i], height_m_[i - 1] - drop);
  for (std::size_t i = height_m_.size() - 1; i-- > 0;) height_m_[i] = std::max(height_m_[i], height_m_[i + 1] - drop);
}

}  // namespace gaitwright
