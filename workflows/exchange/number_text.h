// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace gaitwright {

/// Appends the shortest decimals that read back as exactly this number; zero without a sign.
void AppendNumber(double value, std::string& text);

/// Appends a number as AppendNumber does, always with a decimal point, such as 2.0 and 1.0e-05, so that readers of YAML
/// 1.1 and JSON do not take it for an integer or a text.
void AppendDecimal(double value, std::string& text);

}  // namespace gaitwright
