// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "playback/trials/floquet_multipliers_internal.h"

namespace gaitwright {

/// What happens to small deviations from a steady gait.
enum class OrbitVerdict {
  kUnknown,
  kStable,    ///< they decay
  kNeutral,   ///< some neither grow nor decay, such as of place or heading
  kUnstable,  ///< they grow
};
/// The name in JSON: `unknown`, `stable`, `neutral` or `unstable`.
const char* OrbitVerdictName(OrbitVerdict verdict);

/// Stability of the steady part of a gait, from playbacks with small pushes.
struct OrbitStability {
  std::string missing = {};  ///< why there are no multipliers; else empty
  double cycle_s = 0.0;
  int cycles = 0;            ///< of the plan's steady stretch
  double impulse_n_s = 0.0;  ///< of each push
  int playbacks = 0;
  FloquetMultipliers multipliers;

  /// By the largest magnitude: neutral if it is 1 within 0.05, which is about what the measurement resolves.
  OrbitVerdict verdict() const;
};

/// One sentence.
std::string OrbitText(const OrbitStability& orbit);

}  // namespace gaitwright
