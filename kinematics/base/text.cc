// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/base/text.h"

namespace gaitwright {

std::string Trimmed(const std::string& text) {
  constexpr const char* kBlank = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kBlank);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

}  // namespace gaitwright
