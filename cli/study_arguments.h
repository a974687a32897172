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

/// What `sweep` and `tune` share: the walk, its playback, what is varied, trials, threads, and going on after a cut.
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
  /// What it reads.
  Paths PathsToRead() const;
  OptionFields Fields();  ///< of the walk and its playback
  /// Puts options, --set and flags into the requests. @throws InvalidArgument when --set or a flag gives what is
  /// varied too, and for axes that the flags leave no room for.
  Result<OptionTexts> Finish(const std::vector<StudyAxis>& axes, const Common& common);
  /// The robot, with the flags of the walk put in for it. The axes count as given: where a speed is varied, one is
  /// given.
  Result<RobotModel> FinishFor(const std::vector<StudyAxis>& axes);
};

/// How trials of a study are played: trial i has the seed that trial i of `trials --seed S` has. The disturbances are
/// kept.
TrialPlayer PlayerOf(const Disturbances& disturbances, int run_seed);

}  // namespace gaitwright::cli
