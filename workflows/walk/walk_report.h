// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "workflows/walk/walk.h"

namespace gaitwright {

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
  /// Why it is a fail whatever physics said; "" for no such reason.
  std::string objection() const;
};

/// Its report as one HTML page (ReportPage), with the audit's words, changed options, and the viewer.
std::string WalkReport(const Judged& judged);

}  // namespace gaitwright
