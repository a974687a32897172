// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/parts_text.h"

#include <fmt/format.h>

namespace gaitwright {

std::string PartsText(const std::vector<MotionPart>& parts) {
  std::string text;
  for (const MotionPart& part : parts)
    text += fmt::format("{}{} from {:.2f} s", text.empty() ? "" : ", ", part.gait.name, part.start_s);
  return parts.size() > 1 ? text : "";
}

}  // namespace gaitwright
