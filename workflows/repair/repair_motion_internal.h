// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "optimisation/pipeline/finish_motion_internal.h"
#include "planning/audit/audit.h"
#include "workflows/exchange/import_motion.h"
#include "workflows/repair/clean_motion_internal.h"
#include "workflows/repair/repair_options_internal.h"
#include "workflows/repair/rest_at_ends_internal.h"

namespace gaitwright {

/// Request for RepairMotion. Of the import's options, those of reading apply.
struct RepairRequest {
  ImportRequest source;
  RepairOptions repair;
  TrajectoryOptions trajectory = {.knot_step_s = 0.01, .max_solves = 4, .max_iterations = 100};
  std::function<void(const FollowProgress&)> progress = {};

  OptionFields Fields();
};

/// How far a repaired motion is from the file's.
struct MotionDistance {
  double joint_rms_rad = 0.0, joint_mean_rad = 0.0;  ///< over all joints and times
  double joint_largest_rad = 0.0, joint_largest_s = 0.0;
  std::string joint_largest;  ///< which
  double base_rms_m = 0.0, base_largest_m = 0.0, base_largest_s = 0.0;
  double base_turn_rms_rad = 0.0;
};

/// What a repair found and did, without the optimisation of the whole body.
struct MotionFindings {
  std::string format;
  int rows = 0;
  double duration_s = 0.0;
  ImportNotes notes;
  double smoothing_hz = 0.0;  ///< 0: not smoothed
  FoundContacts contacts;
  CleanMotion clean;
  RestedMotion rested;
  std::optional<AuditReport> before;  ///< of the file's motion with the contacts found
  std::string not_audited;            ///< why `before` is missing
};

/// A motion that the robot can do, near the file's.
struct RepairedMotion {
  MotionPlan plan;
  AuditReport after;
  MotionFindings findings;
  MotionDistance distance;  ///< from the file's motion
  FollowReport finished;
  bool was_sound = false;  ///< the file's motion passed, and was kept
};

/// Reads a motion as ImportMotion does and finds what is wrong with it.
Result<MotionFindings> ExamineMotion(const RobotModel& model, const RepairRequest& request);

/// Makes a plan of the nearest motion that the robot can do: contacts are made clean (CleanContacts), then motion and
/// contact forces of the whole body are optimised together near the clean motion. Failure kBadInput for files that are
/// wrong or probably misinterpreted; kInfeasible if no such motion is found, with the constraint and the time.
/// A motion that passes the audit as it is, and for which `proves` returns true, is kept.
/// @param proves  whether a plan that passes the audit stays up in physics; if empty, the audit alone decides.
Result<RepairedMotion> RepairMotion(const RobotModel& model, const RepairRequest& request,
                                    const std::function<bool(const MotionPlan&)>& proves = {});

}  // namespace gaitwright
