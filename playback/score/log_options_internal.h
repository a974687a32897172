// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <string>

#include "playback/log/playback_log.h"

namespace gaitwright {

/// Options that a log was played with. The log must outlive this object.
class LogOptions {
 public:
  explicit LogOptions(const PlaybackLog& log) : log_(log) {}

  /// Value of a numeric option.
  double At(const std::string& key, double otherwise = 0.0) const {
    const std::string text = Text(key);
    return text.empty() ? otherwise : std::strtod(text.c_str(), nullptr);
  }

  /// Text of an option; empty if it does not exist.
  std::string Text(const std::string& key) const {
    for (const auto& [name, text] : log_.options) {
      if (name == key) return text;
    }
    return "";
  }

 private:
  const PlaybackLog& log_;
};

}  // namespace gaitwright
