// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace gaitwright::examples {

/// What a strategy of standing can take: the largest pushes of 0.1 s on the base after which it still stands [N], to
/// within a twentieth.
struct Withstood {
  std::string strategy;
  double ahead_n = 0.0, back_n = 0.0, left_n = 0.0;
};

/// Pushes a biped that comes with the program, standing still with each strategy (standing_controllers.h).
/// @throws InvalidArgument with the reason for a robot that cannot be planned to stand.
std::vector<Withstood> CompareStanding(const std::string& robot);

/// The same as bars, as SVG.
std::string StandingPlot(const std::string& robot, const std::vector<Withstood>& all);

}  // namespace gaitwright::examples
