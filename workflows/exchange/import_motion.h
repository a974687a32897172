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

/// What is asked of ImportMotion.
struct ImportRequest {
  std::string file;                ///< CSV (.csv, .tsv, .txt); YAML or JSON (.yaml, .yml, .json)
  std::string columns_file;        ///< ReadColumnNames, of a CSV; or ""
  std::string terrain = "flat";    ///< LoadTerrain
  std::optional<PlanarPose> goal;  ///< from where the base starts; nothing for where the motion ends
  ImportOptions options;
  MotionOptions motion;  ///< for footsteps, from which a motion is planned

  OptionFields Fields() { return Joined({options.Fields(), motion.Fields()}); }
};

/// A plan of somebody else's motion, and what it took to make one.
struct ImportedMotion {
  MotionPlan plan;  ///< its warnings say what was derived too
  AuditReport audit;
  std::string format;  ///< "csv", "ocs2-csv", "joint-trajectory", "footsteps"
  int rows = 0;        ///< of the file: rows, points or footsteps
  ImportNotes notes;
  std::vector<std::string> unused_columns;
};

/// Reads a motion that others made and makes a plan of it that is audited, played and scored like our own; see
/// docs/import.md for the formats: a CSV with named columns (MotionFromCsv), a motion of OCS2 (Ocs2ColumnNames), a
/// joint trajectory of ROS (ReadJointTrajectory), footsteps (ReadFootsteps), which are planned on into a motion.
/// Failure kBadInput for files that are wrong or likely not what they are taken for; kInfeasible for footsteps that no
/// motion serves.
Result<ImportedMotion> ImportMotion(const RobotModel& model, const ImportRequest& request);

/// The same on ground that somebody has made; the request's own names it only.
Result<ImportedMotion> ImportMotionOn(const RobotModel& model, const Terrain& terrain, const ImportRequest& request);

}  // namespace gaitwright
