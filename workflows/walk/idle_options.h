// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workflows/walk/walk.h"

namespace gaitwright {

/// An option of a playback that does nothing as the others are.
struct IdleOption {
  std::string key;
  std::string why;   ///< "without 'ground_slope_deg'", to be read after "has no effect"
  std::string hint;  ///< what to do about it
};

/// The first of some options that does nothing in a playback.
/// @param keys  options that are given, or drawn.
/// @param open  options whose values are not settled: those that are varied or drawn, through which others may act.
std::optional<IdleOption> FirstIdle(const PlayRequest& request, const std::vector<std::string>& keys,
                                    const std::vector<std::string>& open = {});

}  // namespace gaitwright
