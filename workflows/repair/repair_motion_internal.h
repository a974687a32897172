// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "optimisation/pipeline/finish_motion_internal.h"
#include "planning/audit/broken_time_internal.h"
#include "workflows/exchange/import_motion.h"
#include "workflows/repair/clean_motion_internal.h"
#include "workflows/repair/left_out_internal.h"
#include "workflows/repair/motion_distance_internal.h"
#include "workflows/repair/other_contacts_internal.h"
#include "workflows/repair/part_links_internal.h"
#include "workflows/repair/repair_options_internal.h"
#include "workflows/repair/rest_at_ends_internal.h"
#include "workflows/repair/slowed_motion_internal.h"

namespace gaitwright {

/// Request for RepairMotion. Of the import's options, those of reading apply.
struct RepairRequest {
  ImportRequest source;
  std::optional<MotionTable> table = {};         ///< the motion, instead of the file of `source`
  std::optional<Terrain> ground = {};            ///< the ground; `source.terrain` is then only its name
  std::string weights_file = {};                 ///< file of ReadFollowWeights; "": the usual weights
  std::optional<std::string> weights_text = {};  ///< the weights; `weights_file` is then only their name
  RepairOptions repair;
  TrajectoryOptions trajectory = {.knot_step_s = 0.01, .max_solves = 4, .max_iterations = 100};
  std::function<void(const FollowProgress&)> progress = {};
  SolveRecord* record = nullptr;  ///< keeps the solves of a long motion; may be null
  bool keeps_plan = false;        ///< ExamineMotion keeps MotionFindings::plan

  OptionFields Fields();
};

/// What a repair found and did, without the optimisation of the whole body.
struct MotionFindings {
  MotionFormat format = MotionFormat::kCsv;
  int rows = 0;
  double duration_s = 0.0;
  std::vector<std::string> unused;  ///< columns or arrays of the file that are not used
  ImportNotes notes;
  double smoothing_hz = 0.0;  ///< 0: not smoothed
  FoundContacts contacts;
  std::vector<OtherContact> other_contacts;  ///< by start
  CleanMotion clean;                         ///< without its motion in results of RepairMotion
  RestedMotion rested;
  std::optional<AuditReport> before;            ///< of the file's motion with the contacts found
  std::vector<BrokenTime> broken;               ///< of `before`
  std::string not_audited;                      ///< why `before` is missing
  std::shared_ptr<const MotionPlan> plan = {};  ///< the file's motion, see RepairRequest; null if it is not a plan
  bool kept = false;                            ///< the file's motion is sound, and is the result
  std::vector<SlowedPart> slowed;               ///< by start
  std::vector<LeftOutPart> left_out;            ///< by start
  std::vector<LeftOutPart> lost;                ///< would have to be left out too, but are more than is allowed
  std::vector<PartedLinks> parted;              ///< the deepest overlap first
};

/// A motion that the robot can do, near the file's.
struct RepairedMotion {
  MotionPlan plan;
  AuditReport after;
  std::vector<BrokenTime> broken;  ///< of `after`
  MotionFindings findings;
  MotionDistance distance;                          ///< from the file's motion
  std::shared_ptr<const EvenMotion> original = {};  ///< positions of the file's motion at the times of the plan
  FollowReport finished;
  bool proved = false;  ///< the last call of the proof was for this plan
};

/// How a plan did in physics.
struct PlayProof {
  bool stands = true;
  std::optional<double> fell_s = {};  ///< when it fell
};
using PlanProof = std::function<PlayProof(const MotionPlan&)>;

/// Reads a motion as ImportMotion does and finds what is wrong with it.
Result<MotionFindings> ExamineMotion(const RobotModel& model, const RepairRequest& request);

/// Makes a plan of the nearest motion that the robot can do: contacts are made clean (CleanContacts), then motion and
/// contact forces of the whole body are optimised together near the clean motion. Failure kBadInput for files that are
/// wrong or probably misinterpreted; kInfeasible if no such motion is found, with the constraint and the time.
/// A motion that passes the audit as it is, and stands in the proof, is kept. With `repair.stretch`, parts that have no
/// solution, fail their audit, are far from the file's motion or fall in the proof are slowed, step by step. With
/// `repair.leave_out`, parts that cannot be done at any speed that is allowed are left out (LeaveOut).
/// @param proof  plays a plan that passes the audit in physics; if empty, the audit alone decides.
Result<RepairedMotion> RepairMotion(const RobotModel& model, const RepairRequest& request, const PlanProof& proof = {});

}  // namespace gaitwright
