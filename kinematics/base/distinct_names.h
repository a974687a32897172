// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace gaitwright {

/// The names in the same order, without duplicates: a repeated name gets `joint` and the first free number from 2 on,
/// such as "stone 2".
std::vector<std::string> DistinctNames(const std::vector<std::string>& names, const std::string& joint);

}  // namespace gaitwright
