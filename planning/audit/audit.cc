// SPDX-License-Identifier: BSD-3-Clause
#include "planning/audit/audit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "planning/audit/auditor.h"
#include "planning/plan/heel_off_internal.h"
#include "planning/plan/sole_support.h"

namespace gaitwright {

Auditor::Auditor(const RobotModel& model, const MotionPlan& plan, const AuditOptions& options)
    : model_(model),
      plan_(plan),
      options_(options),
      scratch_(model),
      collision_(model),
      watch_(model, plan.terrain),
      samples_(1 + static_cast<int>(std::floor(plan.duration_s() * options.rate_hz + 1e-6))),
      joints_(model, options, samples_, findings_) {
  findings_.SetSamples(plan.whole_body.start_s, options.rate_hz, samples_);
  slip_W_.assign(model.feet.size(), Vector3::Zero());
  foothold_.assign(model.feet.size(), -1);
  footing_.resize(model.feet.size());
  X_WF_.assign(model.feet.size(), Pose::Identity());
  points_.resize(model.feet.size());
  limits_to_ground_.foot_m.resize(model.feet.size());
  for (int d = 0; d < model.num_dofs(); ++d) efforts_.push_back(model.dof_effort_limit(d));
  const int feet = static_cast<int>(model.feet.size());
  for (int f = 0; f < feet; ++f) intervals_.push_back(IntervalsOf(plan.schedule, f));
  for (const Foothold& foothold : plan.footsteps.footholds) {
    const bool known = foothold.foot >= 0 && foothold.foot < feet;
    support_F_.push_back(
        known ? SupportOf(model.feet[static_cast<std::size_t>(foothold.foot)], foothold, plan.terrain, 0.0)
              : Polygon{});
  }
  NamePlaces();
}

void Auditor::NamePlaces() {
  places_.columns = findings_.Place(Law::kConsistency, "columns, as a share of their tolerance", "1");
  places_.base_force = findings_.Place(Law::kDynamics, "base force", "N");
  places_.base_moment = findings_.Place(Law::kDynamics, "base moment", "N m");
  places_.fall = findings_.Place(Law::kFlight, "force on the centre of mass", "m g");
  places_.spin = findings_.Place(Law::kFlight, "moment about the centre of mass", "m g l");
  places_.zmp = findings_.Place(Law::kZmpSupport, "zero-moment point", "m");
  places_.reference = findings_.Place(Law::kZmpSupport, "reference of the zero-moment point", "m");
  places_.self = findings_.Place(Law::kSelfCollision, "nearest links", "m");
  places_.body = findings_.Place(Law::kBodyClearance, "nearest link", "m");
  for (int d = 0; d < model_.num_dofs(); ++d) {
    places_.residual.push_back(
        findings_.Place(Law::kDynamics, model_.dof_names[static_cast<std::size_t>(d)], Slides(d) ? "N" : "N m"));
  }
  for (int f = 0; f < static_cast<int>(model_.feet.size()); ++f) {
    places_.reach.push_back(findings_.Place(Law::kReach, FootName(f), "m"));
    places_.friction.push_back(
        findings_.Place(Law::kFrictionCone, FootName(f) + ", tangential over normal force", "1"));
    places_.press.push_back(findings_.Place(Law::kUnilateral, FootName(f) + ", normal force in mid stance", "N"));
    places_.edge.push_back(findings_.Place(Law::kUnilateral, FootName(f) + ", centre of pressure outside", "m"));
    places_.swing.push_back(findings_.Place(Law::kFootClearance, FootName(f) + ", height in mid swing", "m"));
  }
}

bool Auditor::Hanging(double time_s) const {
  const MotionPart* part = PartAt(plan_.parts, time_s);
  return part != nullptr && Hangs(part->gait);
}

/// Whether a time is in the middle half of a foot's contact interval or of a gap between two intervals. At the ends,
/// forces and heights are close to zero in every plan.
bool Auditor::InMiddle(int foot, double time_s, bool of_stance) const {
  const std::vector<ContactInterval>& intervals = intervals_[static_cast<std::size_t>(foot)];
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    if (!of_stance && i + 1 == intervals.size()) break;
    const double start = of_stance ? intervals[i].start_s : intervals[i].end_s;
    const double end = of_stance ? intervals[i].end_s : intervals[i + 1].start_s;
    if (std::abs(time_s - 0.5 * (start + end)) <= 0.25 * (end - start)) return true;
  }
  return false;
}

void Auditor::FindFooting(double time_s) {
  for (std::size_t f = 0; f < model_.feet.size(); ++f) {
    const Foot& foot = model_.feet[f];
    Footing& footing = footing_[f];
    footing.foothold = FootholdAt(plan_.footsteps, static_cast<int>(f), time_s);
    const auto* foothold =
        footing.foothold < 0 ? nullptr : &plan_.footsteps.footholds[static_cast<std::size_t>(footing.foothold)];
    if (foothold != nullptr && HoldsSurface(foothold->patch)) {
      footing.normal_W = foothold->X_WF.linear().col(2);
      footing.friction = FrictionUnder(plan_.terrain, plan_.footsteps, static_cast<int>(f), time_s);
    } else {
      const Vector3 p_WF = ContactFrame(model_, scratch_, static_cast<int>(f)).translation();
      const GroundPoint ground = GroundAt(plan_.terrain, p_WF.head<2>());
      footing.normal_W = ground.normal_W;
      footing.friction = ground.friction;
    }
    X_WF_[f] = ContactFrame(model_, scratch_, static_cast<int>(f), footing.normal_W);
    points_[f].clear();
    const Polygon support_F = SupportNow(static_cast<int>(f), time_s);
    if (!foot.has_sole() || support_F.empty()) {
      points_[f] = ContactPoints(foot, X_WF_[f]);
    } else {
      for (const Vector2& corner : support_F) points_[f].push_back(X_WF_[f] * Vector3(corner.x(), corner.y(), 0.0));
    }
  }
}

/// The part of a foot that carries its load; the whole sole if no part of it is on its surface.
Polygon Auditor::SupportNow(int foot, double time_s) const {
  const Foot& of_foot = model_.feet[static_cast<std::size_t>(foot)];
  const int index = footing_[static_cast<std::size_t>(foot)].foothold;
  if (index < 0) return of_foot.sole_F;
  const auto i = static_cast<std::size_t>(index);
  const Polygon support_F = SupportAt(of_foot, plan_.footsteps.footholds[i], support_F_[i], time_s);
  return support_F.empty() ? of_foot.sole_F : support_F;
}

bool Auditor::AllFinite() const {
  const bool contacts = std::all_of(sample_.wrenches.begin(), sample_.wrenches.end(), [](const ContactWrench& wrench) {
    return wrench.force_W.allFinite() && wrench.moment_W.allFinite();
  });
  return contacts && sample_.q.allFinite() && sample_.v.allFinite() && sample_.a.allFinite() && sample_.tau.allFinite();
}

AuditReport Auditor::Run() {
  AuditReport report;
  report.rate_hz = options_.rate_hz;
  const double step = 1.0 / options_.rate_hz;
  report.samples = samples_;
  for (int k = 0; k < report.samples; ++k) {
    const double time_s = plan_.whole_body.start_s + k * step;
    SampleWholeBody(plan_.whole_body, time_s, sample_);
    if (!AllFinite()) {
      findings_.Note(Law::kConsistency, "value is not finite", time_s, std::nan(""), 0.0, "1");
      continue;
    }
    const auto phase = [&](double t) {
      return plan_.schedule.phases[static_cast<std::size_t>(PhaseAt(plan_.schedule, t))].stance;
    };
    stance_ = phase(time_s);
    const double row_s = plan_.whole_body.step_s;
    const double before_s = plan_.whole_body.start_s + row_s * std::floor((time_s - plan_.whole_body.start_s) / row_s);
    between_stances_ = phase(before_s - step) != phase(before_s + row_s + step);
    at_switch_ = phase(time_s - 1.5 * step) != stance_ || phase(time_s + 1.5 * step) != stance_;
    InverseDynamics(model_, sample_.q, sample_.v, sample_.a, scratch_, needed_);
    FindFooting(time_s);
    const Vector3 p_WC = CentreOfMass(model_, scratch_);
    plane_ = PlaneThrough(points_, stance_);
    const double ground_m =
        stance_ != 0 ? plane_.HeightAt(p_WC.head<2>()) : GroundAt(plan_.terrain, p_WC.head<2>()).height_m;
    com_height_m_ = p_WC.z() - ground_m;
    flies_ = Flies(time_s);
    CheckDynamics(time_s);
    CheckFlight(time_s);
    CheckContactForces(time_s);
    CheckZmp(time_s);
    joints_.Look(sample_, time_s);
    CheckStanceFeet(time_s);
    CheckFeetHeights(time_s);
    CheckReach(time_s);
    CheckBodies(time_s);
    CheckSolids(time_s);
    if (options_.margins) NearestOfAll(time_s);
  }
  EndFlight();
  joints_.Finish(plan_.whole_body.end_s());
  CheckStart();
  CheckColumns();
  CheckCentroidal();
  CheckPendulum();
  CheckSchedule();
  CheckParts();
  CheckFootholds();
  CheckSwings();
  report.violations = findings_.Sorted();
  report.remarks = remarks_;
  if (options_.margins) report.margins = findings_.Margins();
  NoteUnknown(report);
  return report;
}

void Auditor::NoteUnknown(AuditReport& report) const {
  for (const Actuator& motor : ActuatorsOf(model_)) {
    if (motor.shared() && !std::isfinite(motor.effort_limit))
      report.notes.push_back(fmt::format("motor '{}': its torque limit is unknown", motor.name));
    if (motor.shared() && !std::isfinite(motor.velocity_limit))
      report.notes.push_back(fmt::format("motor '{}': its speed limit is unknown", motor.name));
  }
  for (const Joint& joint : model_.joints) {
    if (model_.TransmissionOf(joint.dof) != nullptr) continue;
    if (joint.effort_limit_is_placeholder)
      report.notes.push_back(fmt::format("joint '{}': its torque limit is a placeholder", joint.name));
    if (joint.velocity_limit_is_placeholder)
      report.notes.push_back(fmt::format("joint '{}': its speed limit is a placeholder", joint.name));
  }
  for (const MissingMesh& mesh : model_.missing_meshes)
    report.notes.push_back(fmt::format("link '{}': {}; its contacts are not checked", mesh.link, mesh.why));
  for (const MotionPart& part : plan_.parts) {
    if (!Hangs(part.gait)) continue;
    report.notes.push_back(fmt::format(
        "from {:.3g} to {:.3g} s the base is held externally, as on a stand; the holding forces are not checked",
        part.start_s, part.end_s));
  }
}

namespace {

/// Reason why the rows of a plan do not fit a robot, or nothing.
std::optional<std::string> ReasonRowsMisfit(const RobotModel& model, const WholeBodyTrajectory& w) {
  if (w.size() < 2) return "it has fewer than two samples";
  const auto columns = [&](const char* name, const std::vector<VectorX>& list, int size) -> std::optional<std::string> {
    if (list.size() != w.q.size())
      return fmt::format("it has {} rows of {}, but {} of q", list.size(), name, w.q.size());
    for (const VectorX& row : list) {
      if (row.size() != size)
        return fmt::format("its {} has {} numbers, but the robot needs {}", name, row.size(), size);
    }
    return std::nullopt;
  };
  if (auto why = columns("q", w.q, model.nq())) return why;
  if (auto why = columns("v", w.v, model.nv())) return why;
  if (auto why = columns("a", w.a, model.nv())) return why;
  if (auto why = columns("tau", w.tau, model.num_dofs())) return why;
  if (w.wrenches.size() != w.q.size())
    return fmt::format("it has {} rows of contact wrenches, but {} of q", w.wrenches.size(), w.q.size());
  for (const auto& row : w.wrenches) {
    if (row.size() != model.feet.size())
      return fmt::format("it has {} feet, but the robot has {}", row.size(), model.feet.size());
  }
  return std::nullopt;
}

std::optional<std::string> ReasonMisfit(const RobotModel& model, const MotionPlan& plan) {
  constexpr double kLongest = 3600.0;  // [s]
  if (auto why = ReasonRowsMisfit(model, plan.whole_body)) return why;
  const double step = plan.whole_body.step_s;
  if (!(step > 0.0)) return fmt::format("its rows are {} s apart; more than 0 is needed", step);
  if (!(plan.duration_s() <= kLongest))
    return fmt::format("it lasts {:.6g} s; at most {:.0f} s can be audited", plan.duration_s(), kLongest);
  try {
    CheckSchedule(plan.schedule, static_cast<int>(model.feet.size()));
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return std::nullopt;
}

}  // namespace

Result<AuditReport> AuditOverTime(const RobotModel& model, const MotionPlan& plan, const AuditOptions& options,
                                  std::vector<BrokenTime>& broken) {
  if (const auto why = ReasonMisfit(model, plan)) {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kMisfit,
                   "Audit",
                   fmt::format("the plan does not fit robot '{}': {}", model.name, *why),
                   {}};
  }
  Auditor auditor(model, plan, options);
  AuditReport report = auditor.Run();
  broken = auditor.Broken();
  return report;
}

Result<AuditReport> Audit(const RobotModel& model, const MotionPlan& plan, const AuditOptions& options) {
  std::vector<BrokenTime> ignored;
  return AuditOverTime(model, plan, options, ignored);
}

}  // namespace gaitwright
