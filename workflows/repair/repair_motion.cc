// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "kinematics/base/hash.h"
#include "kinematics/base/version.h"
#include "kinematics/spatial/rotation.h"
#include "planning/plan/carried_plan.h"
#include "planning/plan/sample_plan.h"
#include "planning/terrain/load_terrain.h"
#include "workflows/exchange/frame_motion_internal.h"
#include "workflows/exchange/knot_spline.h"
#include "workflows/exchange/read_motion_internal.h"
#include "workflows/repair/repair_motion_internal.h"

namespace gaitwright {
namespace {

constexpr double kCleanCutoff = 8.0;  // [Hz] of the smoothing after feet have been moved

std::vector<double> ColumnOf(const MotionTable& table, const std::function<double(std::size_t)>& part) {
  std::vector<double> values;
  for (int row = 0; row < table.rows(); ++row) values.push_back(part(static_cast<std::size_t>(row)));
  return values;
}

/// Whether the noise on positions would be most of their second derivatives.
bool IsNoisy(const RobotModel& model, const MotionTable& table) {
  constexpr double kOfBase = 1.0, kOfJoints = 50.0;  // [m/s^2], [rad/s^2]
  if (table.rows() < 9) return false;
  const double step_s = (table.time_s.back() - table.time_s.front()) / (table.rows() - 1);
  const auto rough = [&](const std::vector<double>& values) {
    return std::sqrt(6.0) * NoiseOf(values) / (step_s * step_s);
  };
  for (Eigen::Index i = 0; i < 3 && !table.base_m.empty(); ++i) {
    if (rough(ColumnOf(table, [&](std::size_t row) { return table.base_m[row][i]; })) > kOfBase) return true;
  }
  for (int d = 0; d < model.num_dofs(); ++d) {
    if (rough(ColumnOf(table, [&](std::size_t row) { return table.q[row][d]; })) > kOfJoints) return true;
  }
  return false;
}

/// Cut-off of the smoothing of a file's positions; 0 for none.
double SmoothingOf(const RobotModel& model, const MotionTable& table, const RepairOptions& options) {
  constexpr double kNoisy = 8.0;  // [Hz]
  if (options.smoothing_hz > 0.0) return options.smoothing_hz;
  if (const double coarse = CoarseSmoothingHz(table); coarse > 0.0) return std::min(coarse, kNoisy);
  return IsNoisy(model, table) ? kNoisy : 0.0;
}

/// Positions, velocities and accelerations of smooth curves through rows.
EvenMotion Smooth(const RobotModel& model, const EvenMotion& rows, double cutoff_hz) {
  MotionTable table;
  table.format = "repaired";
  for (int k = 0; k < rows.size(); ++k) {
    const VectorX& q = rows.q[static_cast<std::size_t>(k)];
    table.time_s.push_back(rows.TimeOf(k));
    table.base_m.emplace_back(q.head<3>());
    table.quaternion.emplace_back(q.segment<4>(3));
    table.q.emplace_back(q.tail(model.num_dofs()));
  }
  table.contact = rows.contact;
  ImportOptions options;
  options.grid_step_s = rows.step_s;
  options.smoothing_hz = cutoff_hz;
  std::vector<DerivedPart> derived;
  std::vector<std::string> warnings;
  return Resample(model, table, options, derived, warnings);
}

/// Everything that is known of a motion before its whole body is optimised.
struct Prepared {
  Terrain terrain;
  std::string text;
  EvenMotion original;                 ///< positions, with the times of `rested`
  std::optional<MotionPlan> as_it_is;  ///< the file's motion, if it passes its audit
  MotionFindings findings;
};

void AuditBefore(const RobotModel& model, const RepairRequest& request, EvenMotion motion, Prepared& prepared) {
  try {
    ImportOptions options = request.source.options;
    options.any_height = true;
    ImportNotes ignored;
    motion.contact = prepared.findings.contacts.stance;
    prepared.as_it_is = PlanOfMotion(model, prepared.terrain, std::move(motion), options, {}, ignored);
    Result<AuditReport> audit = Audit(model, *prepared.as_it_is, {});
    if (audit) prepared.findings.before = std::move(*audit);
    if (!audit || !prepared.findings.before->pass()) prepared.as_it_is.reset();
  } catch (const InvalidArgument& error) {
    prepared.findings.not_audited = error.what();
  }
}

/// @throws InvalidArgument for a motion that is probably misinterpreted.
Result<Prepared> Prepare(const RobotModel& model, RepairRequest request) {
  const Result<Terrain> terrain = LoadTerrain(request.source.terrain, ScaleOf(model));
  if (!terrain) return terrain.failure();
  const Result<MotionText> text = ReadMotionText(request.source);
  if (!text) return text.failure();
  if (text->has_footsteps)
    return RefusedMotion(request.source.file, "contains footsteps; 'import' plans a motion for them");
  Result<MotionTable> table = ReadMotionTable(model, *text, request.source);
  if (!table) return table.failure();
  Prepared prepared{*terrain, text->text, {}, {}, {}};
  MotionFindings& findings = prepared.findings;
  findings.format = table->format;
  findings.rows = table->rows();
  findings.smoothing_hz = SmoothingOf(model, *table, request.repair);
  ImportOptions options = request.source.options;
  options.smoothing_hz = findings.smoothing_hz;
  EvenMotion motion = EvenMotionOf(model, *terrain, options, std::move(*table), findings.notes);
  findings.duration_s = motion.TimeOf(motion.size() - 1);
  const std::vector<FootTrack> feet = FeetOf(model, *terrain, motion);
  findings.contacts = FindContacts(model, motion, feet, request.repair);
  if (!motion.contact.empty()) findings.contacts.stance = motion.contact;
  findings.rested = WithRestAtEnds(model, motion, findings.contacts.stance, request.repair);
  AuditBefore(model, request, std::move(motion), prepared);
  EvenMotion rested = Smooth(model, findings.rested.motion, 0.0);
  findings.clean = CleanContacts(model, *terrain, rested, findings.rested.stance, request.repair);
  prepared.original = {rested.step_s, std::move(rested.q), {}, {}, {}, {}, {}};
  return prepared;
}

MotionDistance DistanceOf(const RobotModel& model, const EvenMotion& original, const MotionPlan& plan) {
  MotionDistance distance;
  WholeBodySample sample;
  double joints = 0.0, mean = 0.0, base = 0.0, turns = 0.0;
  for (int k = 0; k < original.size(); ++k) {
    const VectorX& q = original.q[static_cast<std::size_t>(k)];
    const double time_s = original.TimeOf(k);
    SampleWholeBody(plan.whole_body, time_s, sample);
    const VectorX apart = (sample.q - q).tail(model.num_dofs()).cwiseAbs();
    joints += apart.squaredNorm() / model.num_dofs();
    mean += apart.mean();
    Eigen::Index which = 0;
    if (const double largest = apart.maxCoeff(&which); largest > distance.joint_largest_rad) {
      distance.joint_largest_rad = largest;
      distance.joint_largest_s = time_s;
      distance.joint_largest = model.dof_names[static_cast<std::size_t>(which)];
    }
    const double moved = (sample.q - q).head<3>().norm();
    base += moved * moved;
    turns += RotationLog(BaseRotation(sample.q) * BaseRotation(q).transpose()).squaredNorm();
    if (moved > distance.base_largest_m) {
      distance.base_largest_m = moved;
      distance.base_largest_s = time_s;
    }
  }
  const double rows = original.size();
  distance.joint_rms_rad = std::sqrt(joints / rows);
  distance.joint_mean_rad = mean / rows;
  distance.base_rms_m = std::sqrt(base / rows);
  distance.base_turn_rms_rad = std::sqrt(turns / rows);
  return distance;
}

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

Provenance ProvenanceOf(RepairRequest request, const Prepared& prepared) {
  Provenance provenance{Version(), "RepairMotion", {}, 0};
  provenance.options = {{"format", prepared.findings.format}, {"source_hash", HexHash(prepared.text)}};
  const OptionTexts options = TextsOf(request.Fields());
  provenance.options.insert(provenance.options.end(), options.begin(), options.end());
  return provenance;
}

/// Whether a motion needs no repair.
bool IsSound(const Prepared& prepared, const std::function<bool(const MotionPlan&)>& proves) {
  const MotionFindings& findings = prepared.findings;
  const RestedMotion& rested = findings.rested;
  const double added = rested.slowed_start_s + rested.slowed_end_s + rested.stood_start_s + rested.stood_end_s;
  return added == 0.0 && findings.before && findings.before->pass() && (!proves || proves(*prepared.as_it_is));
}

/// The plan near the clean motion.
Result<MotionPlan> Followed(const RobotModel& model, const RepairRequest& request, const Prepared& prepared,
                            FollowReport& report) {
  ImportNotes ignored;
  const MotionPlan reference =
      PlanOfMotion(model, prepared.terrain, Smooth(model, prepared.findings.clean.motion, kCleanCutoff),
                   request.source.options, {}, ignored);
  Result<MotionPlan> followed = FollowMotion(model, reference, request.trajectory, FollowOf(model, request), &report);
  if (followed) return followed;
  Failure failure = followed.failure();
  failure.stage = "RepairMotion";
  return failure;
}

Result<RepairedMotion> Repair(const RobotModel& model, const RepairRequest& request, Prepared prepared,
                              const std::function<bool(const MotionPlan&)>& proves) {
  RepairedMotion repaired;
  repaired.was_sound = IsSound(prepared, proves);
  Result<MotionPlan> plan = repaired.was_sound ? Result<MotionPlan>(*prepared.as_it_is)
                                               : Followed(model, request, prepared, repaired.finished);
  if (!plan) return plan.failure();
  repaired.plan = std::move(*plan);
  SetGoal(repaired.plan);
  repaired.plan.provenance = ProvenanceOf(request, prepared);
  Result<AuditReport> audit = Audit(model, repaired.plan, {});
  if (!audit) return audit.failure();
  repaired.after = std::move(*audit);
  repaired.distance = DistanceOf(model, prepared.original, repaired.plan);
  repaired.findings = std::move(prepared.findings);
  return repaired;
}

void CheckRequest(const RepairRequest& request) {
  RepairRequest checked = request;
  CheckOptions(checked.Fields());
  CheckImportOptions(checked.source.options);
}

}  // namespace

OptionFields RepairRequest::Fields() {
  return Joined(
      {source.options.Fields(), Prefixed("repair", repair.Fields()), Prefixed("trajectory", trajectory.Fields())});
}

Result<MotionFindings> ExamineMotion(const RobotModel& model, const RepairRequest& request) {
  CheckRequest(request);
  try {
    Result<Prepared> prepared = Prepare(model, request);
    if (!prepared) return prepared.failure();
    return std::move(prepared->findings);
  } catch (const InvalidArgument& error) {
    return RefusedMotion(request.source.file, error.what());
  }
}

Result<RepairedMotion> RepairMotion(const RobotModel& model, const RepairRequest& request,
                                    const std::function<bool(const MotionPlan&)>& proves) {
  CheckRequest(request);
  try {
    Result<Prepared> prepared = Prepare(model, request);
    if (!prepared) return prepared.failure();
    return Repair(model, request, std::move(*prepared), proves);
  } catch (const InvalidArgument& error) {
    return RefusedMotion(request.source.file, error.what());
  }
}

}  // namespace gaitwright
