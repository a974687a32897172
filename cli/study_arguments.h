// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/options_file.h"
#include "cli/trials_arguments.h"
#include "cli/walk_arguments.h"
#include "workflows/study/run_sweep.h"

namespace gaitwright::cli {

/// Arguments that `sweep` and `tune` share: the walk, its playback, the varied options, trials, threads and --resume.
struct StudyArguments {
  WalkArguments walk;
  PlayArguments play;
  OptionsFile options;
  DisturbanceArguments disturbances;
  std::vector<std::string> over;
  int threads = 0;
  bool resume = false;

  void AddTo(Verb verb, const std::string& over_help);
  void AddWorkTo(Verb verb);
  /// The files that these arguments read.
  Paths PathsToRead() const;
  OptionFields Fields();  ///< options of the walk and its playback
  /// Puts options, --set and flags into the requests. @throws InvalidArgument if --set or a flag sets a varied option,
  /// and for axes that the flags exclude.
  Result<OptionTexts> Finish(const std::vector<StudyAxis>& axes, const Common& common);
  /// Reads the robot and completes the flags of the walk for it. The axes count as given flags: if a speed is varied, a
  /// speed is given.
  Result<RobotModel> FinishFor(const std::vector<StudyAxis>& axes);
};

/// Plays trials of a study: trial i has the same seed as trial i of `trials --seed S`. Keeps a copy of the
/// disturbances.
TrialPlayer PlayerOf(const Disturbances& disturbances, int run_seed);

}  // namespace gaitwright::cli
