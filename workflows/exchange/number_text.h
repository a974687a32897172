// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace gaitwright {

/// Appends the shortest decimals that read back as exactly this number; zero without a sign.
void AppendNumber(double value, std::string& text);

/// The same with a point or an exponent that has one, as 2.0 and 1.0e-05, so that each reader of YAML 1.1 and JSON
/// takes it for a number with decimals and not for a whole one or for text.
void AppendDecimal(double value, std::string& text);

}  // namespace gaitwright
