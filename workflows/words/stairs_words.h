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

/// Whether a name means steps of stairs.
bool IsStep(const std::string& name);

/// Other names of places on stairs: phrases, and the place of each.
std::vector<std::pair<std::string, PlaceName>> StairsPlaces(const std::vector<PlaceName>& places);

/// Words for stairs that phrases cannot express: "上" before a number of steps, "the next step" as a destination, steps
/// on a ground without places of this name. Also the number of their pieces; 0 if there are none.
std::pair<Item, std::size_t> StairsWordAt(const std::vector<Piece>& pieces, std::size_t at,
                                          const std::vector<Item>& before);

/// "上两级台阶": after a verb that goes up or down, a number of steps and not the number of a step.
void JoinStairs(std::vector<Item>& items);

}  // namespace gaitwright::words
