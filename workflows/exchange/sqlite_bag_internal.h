// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "workflows/exchange/mcap_file_internal.h"

namespace gaitwright {

/// The first bytes of a database of SQLite.
inline constexpr std::string_view kSqliteMagic("SQLite format 3\0", 16);

/// Passes all messages of a bag that ROS 2 stored in SQLite (.db3) to `take`, in the order of their numbers.
/// @throws InvalidArgument for bytes that are no such database, or that are damaged.
void ReadSqliteBag(const std::string& bytes, const TakeMessage& take);

}  // namespace gaitwright
