// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "kinematics/ik/leg_chain.h"
#include "kinematics/ik/reach_gap.h"
#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// All joint positions of a leg that bring its foot to one pose, limits apart; modulo full turns.
struct LegBranches {
  static constexpr std::size_t kMost = 8;
  std::array<Vector6, kMost> positions;  ///< by joint, base first; a leg of three joints uses the first three
  std::size_t count = 0;
  double turn_gap_rad = 0.0;  ///< when none: by how much hip or ankle miss the foot's rotation, at the least
};

/// Inverse kinematics of one family of legs in closed form.
class LegClosedForm {
 public:
  virtual ~LegClosedForm() = default;

  /// @param any  positions to keep where the pose leaves a joint free (two axes in line).
  virtual LegBranches Branches(const Pose& X_BF, const Vector6& any) const = 0;

  /// How far a pose without branches is from having one.
  virtual ReachGap Gap(const Pose& X_BF) const = 0;

  /// The joint that bends the leg, and its position when the leg is straight [rad].
  virtual int knee() const = 0;
  virtual double straight_rad() const = 0;

  /// By how much the model departs from the family's geometry [rad or leg lengths]; at most kMisfit.
  virtual double misfit() const = 0;
  static constexpr double kMisfit = 1e-5;  ///< what rounded angles in a file amount to
};

}  // namespace gaitwright
