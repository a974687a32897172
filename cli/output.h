// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cli/paths.h"
#include "cli/program.h"
#include "workflows/walk/walk_report.h"

namespace gaitwright::cli {

/// Where a verb writes. An empty name is not written; names are within `folder` when that is given.
struct Outputs {
  std::string folder, plan = "plan.json", log = "log.json", second_log = "log-mujoco.json", report = "report.html",
                      plot_folder;

  void AddTo(Verb verb);
  /// Adds the files of the folder, as those of --out-dir, and the folder of plots.
  void AddPathsTo(Paths& paths) const;
  /// Where a name of this folder lies.
  std::string PathOf(const std::string& name) const;
};

/// What was written: kind ("plan", "log", "report") and path.
using Files = std::vector<std::pair<std::string, std::string>>;

/// Writes plan, log, report and plots: all of them, or upon a failure none.
Result<Files> WriteOutputs(const Judged& judged, const Outputs& outputs);

/// The object of `walk` and `play` with --json, else the report in words.
/// @param more  keys and JSON texts that stand before all others.
void PrintJudged(const Judged& judged, const Files& files, const Common& common,
                 const std::vector<std::pair<std::string, std::string>>& more = {});

}  // namespace gaitwright::cli
