// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/terrain_spec.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace gaitwright {

OptionTexts ParseParameters(const std::string& text) {
  OptionTexts texts;
  std::set<std::string> seen;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    const std::string part = text.substr(at, comma - at);
    const std::size_t equals = part.find('=');
    if (equals == std::string::npos || equals == 0)
      throw InvalidArgument(fmt::format("parameter '{}' is not of the form 'key=value'", part));
    const std::string key = part.substr(0, equals);
    if (!seen.insert(key).second)
      throw InvalidArgument(fmt::format("parameter '{}' is given twice; give it once", key));
    texts.emplace_back(key, part.substr(equals + 1));
    at = comma + 1;
  }
  return texts;
}

}  // namespace gaitwright
