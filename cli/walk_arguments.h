// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/program.h"
#include "workflows/walk/walk.h"

namespace gaitwright::cli {

/// The flags that say which robot walks how, shared by `walk` and `plan`.
struct WalkArguments {
  std::string robot = "a1", urdf, goal;
  WalkRequest request;
  std::optional<double> distance_m;
  int steps = 0;

  void AddTo(CLI::App& verb);
  /// Puts the flags into the request. @throws InvalidArgument for flags that contradict each other or do not parse.
  void Finish(const RobotModel& model);
};

/// The flags of a playback, shared by `walk` and `play`.
struct PlayArguments {
  PlayRequest request;
  std::string push;

  void AddTo(CLI::App& verb);
  /// @throws InvalidArgument when --push is not three numbers.
  void Finish();
};

/// Applies every --set key=value to the fields. @throws InvalidArgument on a key that none has (the nearest is named).
void ApplySets(const std::vector<std::string>& sets, OptionFields fields);

/// Comma-separated numbers. @throws InvalidArgument naming the flag.
std::vector<double> ParseNumbers(const std::string& flag, const std::string& text, std::size_t count);

}  // namespace gaitwright::cli
