// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "workflows/repair/repair_motion_internal.h"
#include "workflows/study/job_journal.h"
#include "workflows/study/study_jobs.h"

namespace gaitwright {

/// Request for the repair of all clips of a folder.
struct FolderRequest {
  RepairRequest repair;  ///< its file is the folder
  std::string out;       ///< folder of the plans
  bool check = false;    ///< only examine
  bool plays = true;     ///< play the plans
};

/// Sorted: the worst first.
enum class ClipVerdict { kRefused, kFail, kPass };
/// The name in JSON, CSV and for the user: `refused`, `fail` or `pass`.
const char* ClipVerdictName(ClipVerdict verdict);

/// What became of a clip. Shares and distances are 0 where they are unknown.
struct ClipOutcome {
  std::string clip;  ///< path within the folder
  ClipVerdict verdict = ClipVerdict::kFail;
  double duration_s = 0.0;
  double broken_share = 0.0;  ///< of the time, for the check that the file's motion fails longest; 1 if none was made
  std::string broken;         ///< that check, or ""
  int violations = 0;         ///< of the file's motion
  double joint_rms_rad = 0.0, joint_largest_rad = 0.0, base_rms_m = 0.0;
  double slowed_s = 0.0;    ///< duration added by slowing
  double left_out_s = 0.0;  ///< duration of parts that were left out
  std::string reason;       ///< why it fails or was refused
  std::string plan;         ///< path of the plan, or ""

  bool operator==(const ClipOutcome&) const = default;
};

/// Paths of the motions in a folder and its folders, relative to it, sorted: files with one of MotionEndings, and
/// folders of bags. @throws InvalidArgument if it has none.
std::vector<std::string> ClipsOf(const std::string& folder);

/// A line that is equal only for equal work: robot, options, and names and contents of all clips.
Result<std::string> FolderIdentity(const RobotModel& model, const FolderRequest& request,
                                   const std::vector<std::string>& clips);

/// Likewise for a single motion, the file of the request.
Result<std::string> MotionIdentity(const RobotModel& model, const FolderRequest& request);

/// Repairs clips on several threads. Each clip that is done goes into the journal; those that are there are not done
/// again, so that a run that was interrupted ends with the same outcomes. @return the worst first: refused, then
/// failed, then passed, and among these by the share of the time that the file fails a check. Failure `interrupted`.
/// @param elsewhere  RepairOneClip for a number, on other machines.
Result<std::vector<ClipOutcome>> RepairClips(
    const RobotModel& model, const FolderRequest& request, const std::vector<std::string>& clips, JobJournal& journal,
    const JobOptions& options, const std::vector<std::function<std::string(std::size_t)>>& elsewhere = {});

/// Repairs one clip. @return its outcome as a line of the journal. @throws CannotKeep if the plan cannot be written.
std::string RepairOneClip(const RobotModel& model, const FolderRequest& request, const std::string& clip);

/// A table for people, as CSV, and as JSON (docs/repair.md).
std::string ClipsText(const std::vector<ClipOutcome>& clips);
std::string ClipsCsv(const std::vector<ClipOutcome>& clips);
std::string ClipsJson(const RobotModel& model, const std::vector<ClipOutcome>& clips, const std::string& table_path);

}  // namespace gaitwright
