// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "tests/fuzz/reader.h"

namespace gaitwright::fuzz {

/// The readers of motions from other programs: tables, joint trajectories, footsteps, and reports to compare.
std::vector<Reader> ExchangeReaders();

}  // namespace gaitwright::fuzz
