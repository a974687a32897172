// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/options.h"

namespace gaitwright {

/// Options from a YAML map of keys to values, `gait.cycle_s: 0.45` a line: the same keys and values as `--set` takes.
/// Strict: a file that is not such a map, unknown keys (with the nearest key), duplicate keys, and values out of range
/// are refused with file and line.
/// @param fields  what may be set; their values are changed by the check.
/// @return keys and values in their order, as the options write them. Failure kBadInput `options_file`.
Result<OptionTexts> LoadOptionsFile(const std::string& path, OptionFields fields);

}  // namespace gaitwright
