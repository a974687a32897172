// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "workflows/walk/walk.h"

namespace gaitwright {

/// A played plan with its audit.
struct Judged {
  const RobotModel& model;
  const MotionPlan& plan;
  const PlayedWalk& played;
  const AuditReport& audit;
  double planning_cpu_s = 0.0;
  bool audit_counts = false;                    ///< the verdict also needs the plan's audit
  std::optional<std::string> mesh_folder = {};  ///< folder of the robot's URDF, to find its visual meshes
  std::string orbit_part = {};                  ///< of the report, see OrbitPart

  bool pass() const { return played.pass() && (!audit_counts || audit.pass()); }
  /// Reason for a fail independent of physics; "" if there is none.
  std::string objection() const;
};

/// The report as one HTML page (ReportPage), with the audit's text, changed options and the viewer.
std::string WalkReport(const Judged& judged);

}  // namespace gaitwright
