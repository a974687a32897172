// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/options.h"

namespace gaitwright {

/// Reads options from a YAML map of keys to values with lines such as `gait.cycle_s: 0.45`. Keys and values are those
/// of `--set`. A file that is not such a map, unknown keys (with the nearest key), duplicate keys, and values out of
/// range are refused with file and line.
/// @param fields  the options that may be set; the check changes their values.
/// @return keys and values in the order of the file, as text of the options. Failure kBadInput `options_file`.
Result<OptionTexts> LoadOptionsFile(const std::string& path, OptionFields fields);

}  // namespace gaitwright
