// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "tests/fuzz/reader.h"

namespace gaitwright::fuzz {

/// The readers of recorded messages, of captured motions and of plans of contacts.
std::vector<Reader> RecordingReaders();

}  // namespace gaitwright::fuzz
