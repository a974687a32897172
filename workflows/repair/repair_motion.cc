// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "kinematics/base/free_memory_internal.h"
#include "kinematics/base/version.h"
#include "kinematics/spatial/rotation.h"
#include "planning/plan/carried_plan.h"
#include "workflows/exchange/read_motion_internal.h"
#include "workflows/repair/bad_times_internal.h"
#include "workflows/repair/part_links_internal.h"
#include "workflows/repair/prepared_motion_internal.h"
#include "workflows/repair/repair_motion_internal.h"

namespace gaitwright {
namespace {

constexpr double kFartherApart = 1.25;  // times the distance that the whole body keeps
constexpr double kCleanCutoff = 8.0;    // [Hz] of the smoothing after feet have been moved

FollowOptions FollowOf(const RobotModel& model, const RepairRequest& request) {
  FollowOptions follow;
  BodyWeights& w = follow.weights;
  w.base_position = request.repair.base_position;
  w.base_rotation = request.repair.base_rotation;
  w.joint = request.repair.joint;
  w.base_acceleration *= request.repair.acceleration;
  w.joint_acceleration *= request.repair.acceleration;
  w.effort = request.repair.effort;
  follow.friction_use = request.source.options.friction_use;
  follow.sole_margin_m = request.repair.sole_margin * model.leg_length_m();
  follow.effort_use = request.repair.effort_use;
  follow.windows = {request.repair.window_s, std::min(request.repair.overlap_s, 0.5 * request.repair.window_s)};
  follow.progress = request.progress;
  follow.record = request.record;
  return follow;
}

/// The goal of a repaired motion is where it ends.
void SetGoal(MotionPlan& plan) {
  const PlanarPose start = BaseInPlan(plan.whole_body.q.front()), end = BaseInPlan(plan.whole_body.q.back());
  const double c = std::cos(start.yaw_rad), s = std::sin(start.yaw_rad), x = end.x_m - start.x_m,
               y = end.y_m - start.y_m;
  MotionPart& part = plan.parts.front();
  part.goal = plan.goal = end;
  part.command.goal_x_m = c * x + s * y;
  part.command.goal_y_m = c * y - s * x;
  part.command.goal_yaw_rad = WrapAngle(end.yaw_rad - start.yaw_rad);
  part.gait.name = "repaired";
}

Provenance ProvenanceOf(RepairRequest request, const PreparedMotion& prepared) {
  Provenance provenance{Version(), "RepairMotion", {}, 0};
  provenance.options = {{"format", MotionFormatName(prepared.findings.format)}, {"source_hash", prepared.source_hash}};
  if (!prepared.weights_hash.empty()) provenance.options.emplace_back("weights_hash", prepared.weights_hash);
  const OptionTexts options = TextsOf(request.Fields());
  provenance.options.insert(provenance.options.end(), options.begin(), options.end());
  return provenance;
}

/// Whether a motion needs no repair.
bool IsSound(const PreparedMotion& prepared, const PlanProof& proof) {
  const MotionFindings& findings = prepared.findings;
  const RestedMotion& rested = findings.rested;
  const double added = rested.slowed_start_s + rested.slowed_end_s + rested.stood_start_s + rested.stood_end_s;
  return added == 0.0 && prepared.as_it_is && (!proof || proof(*prepared.as_it_is).stands);
}

/// Times of the file's motion for knots.
std::vector<double> FileTimesOf(const RestedMotion& rested, const std::vector<double>& knots_s) {
  std::vector<double> file_s;
  for (const double knot_s : knots_s) {
    const auto row = static_cast<std::size_t>(std::lround(knot_s / rested.motion.step_s));
    file_s.push_back(rested.file_s[std::min(row, rested.file_s.size() - 1)]);
  }
  return file_s;
}

/// The plan near the clean motion, which is dropped unless parts of it may be slowed.
Result<MotionPlan> Followed(const RobotModel& model, const RepairRequest& request, PreparedMotion& prepared,
                            FollowReport& report) {
  ImportNotes ignored;
  const double apart_m = request.trajectory.self_distance_m;  // 0: links may touch
  prepared.findings.parted.clear();
  if (apart_m > 0.0)
    prepared.findings.parted = PartLinks(model, kFartherApart * apart_m, prepared.findings.clean.motion);
  const MotionPlan reference =
      PlanOfMotion(model, prepared.terrain, SmoothRows(model, prepared.findings.clean.motion, kCleanCutoff),
                   request.source.options, {}, ignored);
  if (request.repair.stretch <= 1.0) prepared.findings.clean.motion = {};
  ReleaseFreedMemory();
  FollowOptions follow = FollowOf(model, request);
  if (!prepared.weights.ranges.empty()) {
    follow.prepare = [&](BodyProblem& problem) {
      SetWeights(prepared.weights, FileTimesOf(prepared.findings.rested, problem.time_s), problem);
    };
  }
  Result<MotionPlan> followed = FollowMotion(model, reference, request.trajectory, follow, &report);
  if (followed) return followed;
  Failure failure = followed.failure();
  failure.stage = "RepairMotion";
  failure.suggestions.clear();  // those of the solver are for people who state problems
  if (request.repair.stretch <= 1.0)
    failure.suggestions.emplace_back("repair.stretch", 1.3, Certainty::kUntried, "--stretch 1.3");
  return failure;
}

/// One attempt to repair a motion as it is arranged.
Result<RepairedMotion> Attempt(const RobotModel& model, const RepairRequest& request, PreparedMotion& prepared,
                               FollowReport& report) {
  RepairedMotion repaired;
  Result<MotionPlan> plan =
      prepared.findings.kept ? Result<MotionPlan>(*prepared.as_it_is) : Followed(model, request, prepared, report);
  if (!plan) return plan.failure();
  repaired.finished = report;
  repaired.plan = std::move(*plan);
  SetGoal(repaired.plan);
  repaired.plan.provenance = ProvenanceOf(request, prepared);
  ReleaseFreedMemory();
  Result<AuditReport> audit = AuditOverTime(model, repaired.plan, {}, repaired.broken);
  if (!audit) return audit.failure();
  repaired.after = std::move(*audit);
  repaired.distance = DistanceOf(model, *prepared.original, repaired.plan);
  repaired.original = prepared.original;
  return repaired;
}

/// A copy without the clean motion, which takes as much memory as a plan.
MotionFindings LightCopy(MotionFindings& findings) {
  EvenMotion clean = std::move(findings.clean.motion);
  findings.clean.motion = {};
  MotionFindings copy = findings;
  findings.clean.motion = std::move(clean);
  return copy;
}

/// Drops what no further attempt needs, because it takes much memory.
void DropUnneeded(const RepairOptions& options, PreparedMotion& prepared) {
  if (options.stretch > 1.0) return;
  EvenMotion& of_file = prepared.of_file;
  of_file = options.leave_out > 0.0 ? EvenMotion{of_file.step_s, std::move(of_file.q), {}, {}, {}, of_file.contact, {}}
                                    : EvenMotion{};
}

/// Slows a motion at times that cannot be done, or leaves them out if they are as slow as is allowed.
/// @return false if nothing is left to try.
bool Ease(const RobotModel& model, const RepairOptions& options, const BadTimes& bad, PreparedMotion& prepared) {
  MotionFindings& findings = prepared.findings;
  if (options.stretch > 1.0 && SlowDown(bad.file_s, options.stretch, bad.why, findings.slowed)) return true;
  if (bad.is_far || options.leave_out == 0.0) return false;
  std::vector<LeftOutPart> parts = findings.left_out;
  if (!LeaveOut(model, KindOfGround(prepared.terrain), prepared.of_file, bad.file_s, bad.why, parts)) return false;
  if (DurationOf(parts) > options.leave_out * findings.duration_s) {
    findings.lost = std::move(parts);
    return false;
  }
  findings.left_out = std::move(parts);
  return true;
}

/// Adds to a failure which parts cannot be done.
void ReportLost(const MotionFindings& findings, Failure& failure) {
  if (findings.lost.empty()) return;
  const double share = std::min(1.0, std::ceil(100.0 * DurationOf(findings.lost) / findings.duration_s) / 100.0);
  failure.message += "; " + LostText(findings.lost, findings.duration_s);
  failure.suggestions.emplace_back("repair.leave_out", share, Certainty::kUntried,
                                   fmt::format("--leave-out {:.2f}", share));
}

/// Repairs a motion; parts that cannot be done are slowed or left out, as long as that is allowed.
Result<RepairedMotion> Repair(const RobotModel& model, const RepairRequest& request, PreparedMotion prepared,
                              const PlanProof& proof) {
  constexpr int kMostAttempts = 16;
  Arrange(model, request.repair, prepared);
  MotionFindings& findings = prepared.findings;
  DropUnneeded(request.repair, prepared);
  ReleaseFreedMemory();
  findings.kept = IsSound(prepared, proof);
  std::optional<Result<RepairedMotion>> best;
  for (int attempt = 1;; ++attempt) {
    FollowReport report;
    Result<RepairedMotion> repaired = Attempt(model, request, prepared, report);
    const BadTimes bad = findings.kept ? BadTimes{} : BadTimesOf(request.repair, findings, repaired, report, proof);
    const bool is_sound = repaired && (bad.file_s.empty() || bad.is_far);
    // Nothing is left out in vain.
    if (!best || is_sound || (repaired && findings.left_out.empty())) {
      if (repaired) {
        repaired->findings = LightCopy(findings);
        repaired->proved = bad.played || (findings.kept && proof);
      }
      best = std::move(repaired);
    } else if (*best) {
      (*best)->proved = false;  // the proof was called for another plan since
    }
    if (bad.file_s.empty() || attempt == kMostAttempts || !Ease(model, request.repair, bad, prepared)) break;
    Arrange(model, request.repair, prepared);
  }
  if (*best) {
    (*best)->findings.lost = findings.lost;
    return std::move(*best);
  }
  Failure failure = best->failure();
  ReportLost(findings, failure);
  return failure;
}

void CheckRequest(const RepairRequest& request) {
  RepairRequest checked = request;
  CheckOptions(checked.Fields());
  CheckImportOptions(checked.source.options);
}

}  // namespace

OptionFields RepairRequest::Fields() {
  return Joined({source.options.Fields(), Prefixed("repair", repair.Fields()),
                 Prefixed("trajectory", trajectory.FollowFields())});
}

Result<MotionFindings> ExamineMotion(const RobotModel& model, const RepairRequest& request) {
  CheckRequest(request);
  try {
    Result<PreparedMotion> prepared = ReadAndFind(model, request);
    if (!prepared) return prepared.failure();
    Arrange(model, request.repair, *prepared);
    if (request.keeps_plan && prepared->as_it_is)
      prepared->findings.plan = std::make_shared<const MotionPlan>(std::move(*prepared->as_it_is));
    return std::move(prepared->findings);
  } catch (const InvalidArgument& error) {
    return RefusedMotion(request.source.file, error.what());
  }
}

Result<RepairedMotion> RepairMotion(const RobotModel& model, const RepairRequest& request, const PlanProof& proof) {
  CheckRequest(request);
  try {
    Result<PreparedMotion> prepared = ReadAndFind(model, request);
    if (!prepared) return prepared.failure();
    return Repair(model, request, std::move(*prepared), proof);
  } catch (const InvalidArgument& error) {
    return RefusedMotion(request.source.file, error.what());
  }
}

}  // namespace gaitwright
