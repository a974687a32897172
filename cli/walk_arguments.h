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

/// The flags that say which robot walks how, shared by `walk` and `plan`.
struct WalkArguments {
  RobotFlags robot;
  std::string goal;
  WalkRequest request;
  WalkExtent extent;
  std::vector<KeyedFlag> keyed;  ///< those of its flags that a study may vary by key

  void AddTo(Verb verb);
  OptionFields Fields();  ///< of the request
  /// Puts the flags into the request. @throws InvalidArgument for flags that contradict each other or do not parse.
  void Finish(const RobotModel& model);

 private:
  void AddCommandTo(Verb verb);
};

/// The flags of a playback, shared by `walk` and `play`.
struct PlayArguments {
  PlayRequest request;
  std::string usual_engine = "bullet";  ///< of the verb, where neither --engine nor play.engine is given
  std::optional<Flag> engine;
  std::string push;
  std::vector<Flag> only_with_push;
  std::optional<Flag> only_with_sensors;
  std::vector<KeyedFlag> keyed;  ///< those of its flags that a study may vary by key

  void AddTo(Verb verb);
  OptionFields Fields();  ///< of the request
  /// Before any options are put into the request.
  void SetDefaults(const Common& common);
  /// @param varied  options that are given one value after another.
  /// @throws InvalidArgument when --push is not three numbers, or is missing where its time is given, and for --sensors
  /// where none is read.
  void Finish(const std::vector<std::string>& varied = {});
  /// After Finish. Of --set what gives no more than the usual value is let pass.
  /// @param drawn  options that disturbances draw.
  /// @throws InvalidArgument naming the first option of --set or --over that has no effect.
  void CheckActs(const std::vector<std::string>& sets, const std::vector<std::string>& varied = {},
                 const std::vector<std::string>& drawn = {});
};

}  // namespace gaitwright::cli
