// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "tests/fuzz/reader.h"

namespace gaitwright::fuzz {

/// The readers of a class's submissions, and of the rubrics.
std::vector<Reader> GradeReaders();

}  // namespace gaitwright::fuzz
