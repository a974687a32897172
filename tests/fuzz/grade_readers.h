// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "tests/fuzz/reader.h"

namespace gaitwright::fuzz {

/// The readers of what a class hands in, and of what it is marked by.
std::vector<Reader> GradeReaders();

}  // namespace gaitwright::fuzz
