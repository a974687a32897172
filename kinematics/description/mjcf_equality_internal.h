// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "kinematics/description/mjcf_actuators_internal.h"

namespace gaitwright {

/// What holds for a joint by equalities: it follows another one, or stands still.
struct MjcfCoupling {
  int leader = -1;  ///< index of a joint; position = multiplier * that of the leader + offset
  double multiplier = 1.0, offset = 0.0;
  std::optional<double> locked;  ///< position at which it stands still

  bool moves_alone() const { return leader < 0 && !locked; }
};

/// The couplings by joint. Throws a Failure on what closes a loop (connect, weld), is not linear, or couples a joint
/// twice.
std::vector<MjcfCoupling> ReadMjcfCouplings(MjcfContext& context, const MjcfTree& tree,
                                            const std::vector<MjcfDrive>& drives);

}  // namespace gaitwright
