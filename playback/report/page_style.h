// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace gaitwright {

/// The style sheet of the report's page, without the style of its plots.
std::string PageStyle();

}  // namespace gaitwright
