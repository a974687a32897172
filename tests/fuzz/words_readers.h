// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "tests/fuzz/reader.h"

namespace gaitwright::fuzz {

/// What reads instructions and task plans.
std::vector<Reader> WordsReaders();

}  // namespace gaitwright::fuzz
