// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/flags.h"
#include "cli/program.h"
#include "cli/robot_input.h"
#include "workflows/walk/walk.h"
#include "workflows/walk/walk_extent.h"

namespace gaitwright::cli {

/// Flags for the robot and its walk, shared by `walk` and `plan`.
struct WalkArguments {
  RobotFlags robot;
  std::string goal;
  WalkRequest request;
  WalkExtent extent;
  std::vector<KeyedFlag> keyed;  ///< the flags that a study may vary by key

  void AddTo(Verb verb);
  OptionFields Fields();  ///< fields of the request
  /// Puts the flags into the request. @throws InvalidArgument for flags that contradict each other or do not parse.
  void Finish(const RobotModel& model);

 private:
  void AddCommandTo(Verb verb);
};

/// The flags of a playback, shared by `walk` and `play`.
struct PlayArguments {
  PlayRequest request;
  std::string push;
  std::vector<Flag> only_with_push;
  std::optional<Flag> only_with_sensors;
  std::vector<KeyedFlag> keyed;  ///< the flags that a study may vary by key

  void AddTo(Verb verb);
  OptionFields Fields();  ///< fields of the request
  /// Call this before any options are put into the request.
  void SetDefaults(const Common& common);
  /// @param varied  options that a study varies.
  /// @throws InvalidArgument if --push is not three numbers or is missing although its time is given, and for --sensors
  /// if no sensor is read.
  void Finish(const std::vector<std::string>& varied = {});
  /// Call this after Finish. An option of --set with its default value is accepted.
  /// @param drawn  options that the disturbances sample.
  /// @throws InvalidArgument that names the first option of --set or --over that has no effect.
  void CheckActs(const std::vector<std::string>& sets, const std::vector<std::string>& varied = {},
                 const std::vector<std::string>& drawn = {});
};

}  // namespace gaitwright::cli
