// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "planning/tasks/task_plan.h"
#include "workflows/words/item.h"
#include "workflows/words/pieces.h"

namespace gaitwright::words {

/// Whether a name is that of the steps of stairs.
bool IsStep(const std::string& name);

/// What else the places of stairs are called: phrases, and the place of each.
std::vector<std::pair<std::string, PlaceName>> StairsPlaces(const std::vector<PlaceName>& places);

/// What says of stairs more than a phrase could: "上" before a number of steps, "the next step" that is gone to, steps
/// where no place is called so. Also how many pieces say it; 0 for nothing.
std::pair<Item, std::size_t> StairsWordAt(const std::vector<Piece>& pieces, std::size_t at,
                                          const std::vector<Item>& before);

/// "上两级台阶": how many steps, rather than which one, after a verb that goes up or down.
void JoinStairs(std::vector<Item>& items);

}  // namespace gaitwright::words
