// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

#include "kinematics/base/file.h"
#include "kinematics/base/hash.h"
#include "planning/terrain/load_terrain.h"
#include "workflows/exchange/frame_motion_internal.h"
#include "workflows/exchange/knot_spline.h"
#include "workflows/exchange/read_motion_internal.h"
#include "workflows/repair/prepared_motion_internal.h"

namespace gaitwright {
namespace {

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

void AuditBefore(const RobotModel& model, const RepairRequest& request, PreparedMotion& prepared) {
  try {
    ImportOptions options = request.source.options;
    options.any_height = true;
    ImportNotes ignored;
    prepared.as_it_is = PlanOfMotion(model, prepared.terrain, prepared.of_file, options, {}, ignored);
    Result<AuditReport> audit = AuditOverTime(model, *prepared.as_it_is, {}, prepared.findings.broken);
    if (audit) prepared.findings.before = std::move(*audit);
    if (audit && prepared.findings.before->pass()) return;
    if (request.keeps_plan) prepared.findings.plan = std::make_shared<const MotionPlan>(std::move(*prepared.as_it_is));
    prepared.as_it_is.reset();
  } catch (const InvalidArgument& error) {
    prepared.findings.not_audited = error.what();
  }
}

/// A motion as it was given.
struct SourceMotion {
  MotionTable table;
  std::string hash;
};

/// Hash of the numbers that every motion has.
std::string HashOf(const MotionTable& table) {
  std::string bytes;
  const auto add = [&](const double* from, std::size_t count) {
    bytes.append(reinterpret_cast<const char*>(from), count * sizeof(double));
  };
  add(table.time_s.data(), table.time_s.size());
  for (const VectorX& q : table.q) add(q.data(), static_cast<std::size_t>(q.size()));
  for (const Vector3& p : table.base_m) add(p.data(), 3);
  for (const Eigen::Vector4d& turn : table.quaternion) add(turn.data(), 4);
  return HexHash(bytes);
}

/// The motion of a request. `request` gets the units of its file of column names.
Result<SourceMotion> ReadSource(const RobotModel& model, RepairRequest& request) {
  if (request.table) {
    SourceMotion source{std::move(*request.table), {}};
    source.hash = HashOf(source.table);
    return source;
  }
  const Result<MotionText> text = ReadMotionText(request.source);
  if (!text) return text.failure();
  if (text->form == MotionForm::kFootsteps)
    return RefusedMotion(request.source.file, "contains footsteps; 'import' plans a motion for them");
  Result<MotionTable> table = ReadMotionTable(model, *text, request.source);
  if (!table) return table.failure();
  return SourceMotion{std::move(*table), text->Hash()};
}

std::optional<Failure> ReadWeights(const RobotModel& model, const RepairRequest& request, PreparedMotion& prepared) {
  if (request.weights_file.empty() && !request.weights_text) return std::nullopt;
  const Result<std::string> text = request.weights_text ? *request.weights_text : ReadFile(request.weights_file);
  if (!text) return text.failure();
  Result<FollowWeights> weights = ReadFollowWeights(model, *text, request.weights_file);
  if (!weights) return weights.failure();
  prepared.weights = std::move(*weights);
  prepared.weights_hash = HexHash(*text);
  return std::nullopt;
}

}  // namespace

EvenMotion SmoothRows(const RobotModel& model, const EvenMotion& rows, double cutoff_hz) {
  MotionTable table;
  table.format = MotionFormat::kRepaired;
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

Result<PreparedMotion> ReadAndFind(const RobotModel& model, RepairRequest request) {
  if (!request.ground) {
    Result<Terrain> terrain = LoadTerrain(request.source.terrain, ScaleOf(model));
    if (!terrain) return terrain.failure();
    request.ground = std::move(*terrain);
  }
  Result<SourceMotion> source = ReadSource(model, request);
  if (!source) return source.failure();
  PreparedMotion prepared{*request.ground, std::move(source->hash), {}, {}, {}, {}, {}, {}};
  if (std::optional<Failure> failure = ReadWeights(model, request, prepared)) return *failure;
  MotionFindings& findings = prepared.findings;
  findings.format = source->table.format;
  findings.rows = source->table.rows();
  findings.unused = source->table.unused_columns;
  findings.smoothing_hz = SmoothingOf(model, source->table, request.repair);
  ImportOptions options = request.source.options;
  options.smoothing_hz = findings.smoothing_hz;
  EvenMotion motion = EvenMotionOf(model, prepared.terrain, options, std::move(source->table), findings.notes);
  findings.duration_s = motion.TimeOf(motion.size() - 1);
  const std::vector<FootTrack> feet = FeetOf(model, prepared.terrain, motion);
  findings.contacts = FindContacts(model, motion, feet, request.repair);
  if (!motion.contact.empty()) findings.contacts.stance = motion.contact;
  findings.other_contacts =
      FindOtherContacts(model, prepared.terrain, motion, findings.contacts.height_m, request.repair);
  prepared.of_file = std::move(motion);
  prepared.of_file.contact = findings.contacts.stance;
  AuditBefore(model, request, prepared);
  return prepared;
}

void Arrange(const RobotModel& model, const RepairOptions& options, PreparedMotion& prepared) {
  MotionFindings& findings = prepared.findings;
  const bool changed = !findings.left_out.empty();
  const EvenMotion without =
      changed ? SmoothRows(model, WithoutParts(prepared.of_file, findings.left_out), 0.0) : EvenMotion{};
  const EvenMotion& of_file = changed ? without : prepared.of_file;
  if (findings.slowed.empty()) {
    findings.rested = WithRestAtEnds(model, of_file, of_file.contact, options);
  } else {
    const SlowedMotion slowed = WithSlowParts(of_file, of_file.contact, findings.slowed);
    findings.rested = WithRestAtEnds(model, SmoothRows(model, slowed.motion, 0.0), slowed.stance, options);
    for (double& file_s : findings.rested.file_s) {
      const auto row = static_cast<std::size_t>(std::lround(file_s / of_file.step_s));
      file_s = slowed.file_s[std::min(row, slowed.file_s.size() - 1)];
    }
  }
  EvenMotion rested = SmoothRows(model, findings.rested.motion, 0.0);
  findings.clean = CleanContacts(model, prepared.terrain, rested, findings.rested.stance, options);
  findings.clean.held = HoldStuckJoints(model, findings.clean.motion);
  if (changed) {
    for (std::size_t row = 0; row < rested.q.size(); ++row)
      rested.q[row] = PostureOfFile(prepared.of_file, findings.left_out, findings.rested.file_s[row], rested.q[row]);
  }
  prepared.original =
      std::make_shared<const EvenMotion>(EvenMotion{rested.step_s, std::move(rested.q), {}, {}, {}, {}, {}});
  findings.rested.motion = {findings.rested.motion.step_s, {}, {}, {}, {}, {}, {}};  // a long one is large
}

}  // namespace gaitwright
