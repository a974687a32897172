// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "tests/fuzz/reader.h"

namespace gaitwright::fuzz {

/// The readers of instructions and task plans.
std::vector<Reader> WordsReaders();

}  // namespace gaitwright::fuzz
