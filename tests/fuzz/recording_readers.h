// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "tests/fuzz/reader.h"

namespace gaitwright::fuzz {

/// The readers of recorded messages and of captured motions.
std::vector<Reader> RecordingReaders();

}  // namespace gaitwright::fuzz
