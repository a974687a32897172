// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "optimisation/swing/refine_swing.h"

namespace gaitwright {

/// The smallest height of a swing's contact frame at which its underside touches the ground, by progress along the path
/// [m]. A piecewise linear table: steps of the ground are shifted outward, and steep parts are raised beside the step,
/// as far as start and end of the path allow.
class SwingProfile {
 public:
  SwingProfile(const SwingCurve& swing, const std::vector<Vector3>& underside_F, const GroundHeight& ground,
               const RefineChoice& choice);

  double length_m() const { return length_m_; }
  const Vector2& along_W() const { return along_W_; }
  Vector2 left_W() const { return {-along_W_.y(), along_W_.x()}; }

  /// The largest height within `reach` of a progress [m], and its slope.
  std::pair<double, double> Highest(double s, double reach) const;

 private:
  void Look(const SwingCurve& swing, const std::vector<Vector3>& underside_F, const GroundHeight& ground,
            const RefineChoice& choice);
  std::pair<double, double> At(double s) const;
  bool IsEnd(std::size_t row) const;
  void Widen();
  void LimitSlope(double start_z, double end_z);

  std::vector<double> height_m_;
  double length_m_ = 0.0;
  Vector2 along_W_ = Vector2::Zero();
};

}  // namespace gaitwright
