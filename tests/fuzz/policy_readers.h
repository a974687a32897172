// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/fuzz/reader.h"

namespace gaitwright::fuzz {

/// Readers of a learned policy: its network, its contract, its commands.
Reader NetworkReader();
Reader ContractReader();
Reader CommandsReader();

}  // namespace gaitwright::fuzz
