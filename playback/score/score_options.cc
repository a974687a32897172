// SPDX-License-Identifier: BSD-3-Clause
#include "playback/score/score_options.h"

#include <algorithm>

namespace gaitwright {

ScoreOptions ScoreOptionsOf(const PlaybackLog& log) {
  ScoreOptions options;
  OptionFields fields = Prefixed("score", options.Fields());
  for (const auto& [key, text] : log.options) {
    const bool known =
        std::any_of(fields.begin(), fields.end(), [&key = key](const OptionField& f) { return f.key == key; });
    if (known) SetOption(fields, key, text);
  }
  return options;
}

}  // namespace gaitwright
