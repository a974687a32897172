// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "kinematics/ik/leg_chain.h"
#include "kinematics/ik/reach_gap.h"
#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// All joint positions of a leg that bring its foot to one pose, modulo full turns and without joint limits.
struct LegBranches {
  static constexpr std::size_t kMost = 8;
  std::array<Vector6, kMost> positions;  ///< by joint, base first; a leg of three joints uses the first three
  std::size_t count = 0;
  double turn_gap_rad = 0.0;  ///< if there is no branch: smallest error of the foot's rotation by hip or ankle
};

/// Inverse kinematics of one family of legs in closed form.
class LegClosedForm {
 public:
  virtual ~LegClosedForm() = default;

  /// @param any  positions to use if the pose leaves a joint free (two aligned axes).
  virtual LegBranches Branches(const Pose& X_BF, const Vector6& any) const = 0;

  /// Distance of a pose without branches from the reach of the leg.
  virtual ReachGap Gap(const Pose& X_BF) const = 0;

  /// The joint that bends the leg, and its position when the leg is straight [rad].
  virtual int knee() const = 0;
  virtual double straight_rad() const = 0;

  /// Deviation of the model from the family's geometry [rad or leg lengths]; at most kMisfit.
  virtual double misfit() const = 0;
  static constexpr double kMisfit = 1e-5;  ///< largest effect of rounded angles in a file
};

}  // namespace gaitwright
