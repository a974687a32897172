// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "optimisation/pipeline/plan_motion.h"
#include "planning/audit/audit.h"
#include "workflows/exchange/imported_plan.h"
#include "workflows/exchange/motion_table.h"

namespace gaitwright {

/// Request for ImportMotion.
struct ImportRequest {
  std::string file;                ///< any of the formats that ReadMotionTable reads
  std::string columns_file;        ///< file of column names of a CSV (ReadColumnNames), or ""
  std::string terrain = "flat";    ///< LoadTerrain
  std::optional<PlanarPose> goal;  ///< relative to the base's start; empty: the end of the motion
  ImportOptions options;
  MotionOptions motion;  ///< for footsteps, from which a motion is planned

  OptionFields Fields() { return Joined({options.Fields(), motion.Fields()}); }
};

/// A plan made from an external motion, with notes on how.
struct ImportedMotion {
  MotionPlan plan;  ///< its warnings also list derived data
  AuditReport audit;
  MotionFormat format = MotionFormat::kCsv;
  int rows = 0;  ///< number of rows, points or footsteps of the file
  ImportNotes notes;
  std::vector<std::string> unused_columns;
};

/// Reads a motion of other software and turns it into a plan that can be audited, played and scored; see docs/import.md
/// for the formats: a CSV with named columns (MotionFromCsv), a motion of OCS2 (Ocs2ColumnNames), a joint trajectory of
/// ROS (ReadJointTrajectory), footsteps (ReadFootsteps), for which a motion is planned. Failure kBadInput for files
/// that are wrong or probably misinterpreted; kInfeasible for footsteps without a feasible motion.
Result<ImportedMotion> ImportMotion(const RobotModel& model, const ImportRequest& request);

/// As above on a given ground; the request's terrain is used only as its name.
Result<ImportedMotion> ImportMotionOn(const RobotModel& model, const Terrain& terrain, const ImportRequest& request);

}  // namespace gaitwright
