// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cli/paths.h"
#include "cli/program.h"
#include "workflows/walk/walk_report.h"

namespace gaitwright::cli {

/// The output files of a verb. A file with an empty name is not written; names are relative to `folder` if it is given.
struct Outputs {
  std::string folder, plan = "plan.json", log = "log.json", second_log = "log-mujoco.json", report = "report.html",
                      plot_folder;

  void AddTo(Verb verb);
  /// Adds the files in `folder` (named as those of --out-dir) and the folder of plots.
  void AddPathsTo(Paths& paths) const;
  /// Path of a file name in `folder`.
  std::string PathOf(const std::string& name) const;
};

/// The files that were written: kind ("plan", "log", "report") and path.
using Files = std::vector<std::pair<std::string, std::string>>;

/// Writes plan, log, report and plots. If one of them fails, none is written.
Result<Files> WriteOutputs(const Judged& judged, const Outputs& outputs);

/// Prints the JSON object of `walk` and `play` with --json, otherwise the report as text.
/// @param more  keys and JSON texts that come before all others; its "notes" are joined with those of the report.
void PrintJudged(const Judged& judged, const Files& files, const Common& common,
                 const std::vector<std::pair<std::string, std::string>>& more = {});

}  // namespace gaitwright::cli
