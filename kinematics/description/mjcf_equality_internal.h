// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "kinematics/description/mjcf_actuators_internal.h"

namespace gaitwright {

/// Coupling of a joint by equalities: it follows another joint or is locked.
struct MjcfCoupling {
  int leader = -1;  ///< index of a joint; position = multiplier * position of the leader + offset
  double multiplier = 1.0, offset = 0.0;
  std::optional<double> locked;  ///< position at which it is locked

  bool moves_alone() const { return leader < 0 && !locked; }
};

/// The couplings by joint. Throws a Failure for an equality that is not linear, couples a joint twice, or closes a loop
/// that cannot be locked (see LockMjcfLoops). @param masses  by body [kg].
std::vector<MjcfCoupling> ReadMjcfCouplings(MjcfContext& context, const MjcfTree& tree,
                                            const std::vector<MjcfDrive>& drives, const std::vector<double>& masses);

}  // namespace gaitwright
