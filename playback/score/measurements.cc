// SPDX-License-Identifier: BSD-3-Clause
#include "playback/score/measurements.h"

namespace gaitwright {

void Extreme::See(double seen, double time_s) {
  const bool worse = !value || (kind_ == Kind::kSmallest ? seen < *value : seen > *value);
  if (!worse) return;
  value = seen;
  at_s = time_s;
}

Measurement FromExtremes(const std::string& key, const Extreme& measured, const Extreme& planned,
                         const std::string& missing) {
  return {key, measured.value, planned.value, measured.at_s, measured.value ? "" : missing};
}

}  // namespace gaitwright
