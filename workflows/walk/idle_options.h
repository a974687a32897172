// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workflows/walk/walk.h"

namespace gaitwright {

/// A playback option without effect, given the other options.
struct IdleOption {
  std::string key;
  std::string why;   ///< "without 'ground_slope_deg'", to be read after "has no effect"
  std::string hint;  ///< remedy
};

/// The first of some options that has no effect in a playback.
/// @param keys  options that are given or sampled.
/// @param open  options whose values are open (varied or sampled), which may give other options an effect.
std::optional<IdleOption> FirstIdle(const PlayRequest& request, const std::vector<std::string>& keys,
                                    const std::vector<std::string>& open = {});

}  // namespace gaitwright
