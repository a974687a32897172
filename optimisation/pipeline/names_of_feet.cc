// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/names_of_feet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

namespace gaitwright {

Failure WithNamesOfFeet(const RobotModel& model, Failure failure) {
  const std::string before = "foot ", text = std::exchange(failure.message, "");
  std::size_t done = 0;
  for (auto at = text.find(before); at != std::string::npos; at = text.find(before, at + 1)) {
    const std::size_t first = at + before.size();
    const std::size_t last = std::min(text.find_first_not_of("0123456789", first), text.size());
    const std::size_t foot = last == first ? model.feet.size() : std::stoul(text.substr(first, last - first));
    if (foot >= model.feet.size()) continue;
    failure.message += text.substr(done, at - done) + fmt::format("'{}'", model.feet[foot].name);
    done = last;
  }
  failure.message += text.substr(done);
  return failure;
}

}  // namespace gaitwright
