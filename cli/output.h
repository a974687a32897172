// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/program.h"
#include "workflows/walk/walk.h"

namespace gaitwright::cli {

/// Where a verb writes. An empty name is not written; names are within `folder` when that is given.
struct Outputs {
  std::string folder, plan = "plan.json", log = "log.json", report = "report.html", plot_folder;

  void AddTo(CLI::App& verb);
  /// Where a name of this folder lies.
  std::string PathOf(const std::string& name) const;
};

/// What was written: kind ("plan", "log", "report") and path.
using Files = std::vector<std::pair<std::string, std::string>>;

/// A plan that was played.
struct Judged {
  const RobotModel& model;
  const MotionPlan& plan;
  const PlayedWalk& played;
  const AuditReport& audit;
  double planning_cpu_s = 0.0;
  bool audit_counts = false;                    ///< the verdict needs the plan's audit too
  std::optional<std::string> mesh_folder = {};  ///< of the robot's URDF, where its visual meshes are found from

  bool pass() const { return played.report.pass && (!audit_counts || audit.pass()); }
};

/// Writes plan, log, report and plots: all of them, or upon a failure none.
Result<Files> WriteOutputs(const Judged& judged, const Outputs& outputs);

/// The object of `walk` and `play` with --json, else the report in words.
/// @param more  keys and JSON texts that stand before all others.
void PrintJudged(const Judged& judged, const Files& files, const Common& common,
                 const std::vector<std::pair<std::string, std::string>>& more = {});

}  // namespace gaitwright::cli
