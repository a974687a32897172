// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <nlohmann/json.hpp>

#include "workflows/repair/repair_report_internal.h"

namespace gaitwright {
namespace {

constexpr double kMovedLittle = 1e-3, kTiltedLittle = 0.01;  // [m], [rad]: changes that are not listed

using Json = nlohmann::ordered_json;

void AddContactChange(const MotionFindings& findings, std::vector<RepairChange>& changes) {
  const FoundContacts& c = findings.contacts;
  const int count = c.short_stances + c.short_swings + c.false_flights;
  if (count == 0) return;
  changes.push_back({RepairChangeKind::kContacts, "", 0.0, findings.duration_s, static_cast<double>(count), "1",
                     fmt::format("contacts: {} short stances and {} short swings were removed, and {} flights in which "
                                 "the base does not fall",
                                 c.short_stances, c.short_swings, c.false_flights)});
}

/// Times are those of the file.
void AddOtherContacts(const MotionFindings& findings, std::vector<RepairChange>& changes) {
  for (const OtherContact& contact : findings.other_contacts) {
    changes.push_back(
        {RepairChangeKind::kOtherContact, contact.link, contact.start_s, contact.end_s, contact.end_s - contact.start_s,
         "s",
         fmt::format("other contact: link '{}' is on the ground from {:.2f} to {:.2f} s of the file; plans "
                     "carry the robot on its feet alone, so it takes the nearest posture on them",
                     contact.link, contact.start_s, contact.end_s)});
  }
}

void AddTimeChanges(const MotionFindings& findings, std::vector<RepairChange>& changes) {
  const RestedMotion& r = findings.rested;
  const double end_s = r.motion.TimeOf(static_cast<int>(r.file_s.size()) - 1);
  if (r.stood_start_s > 0.0) {
    changes.push_back(
        {RepairChangeKind::kStood, "", 0.0, r.stood_start_s, r.stood_start_s, "s",
         fmt::format("stood: {:.2f} s were added at the start, because the file begins with a foot in the "
                     "air; the robot first stands on all feet and lifts it",
                     r.stood_start_s)});
  }
  if (r.slowed_start_s > 0.0) {
    changes.push_back({RepairChangeKind::kSlowed, "", r.stood_start_s, r.stood_start_s + r.slowed_start_s,
                       0.5 * r.slowed_start_s, "s",
                       fmt::format("slowed: the first {:.2f} s take {:.2f} s, because the file does not begin at rest",
                                   0.5 * r.slowed_start_s, r.slowed_start_s)});
  }
  if (r.slowed_end_s > 0.0) {
    const double until_s = end_s - r.stood_end_s;
    changes.push_back({RepairChangeKind::kSlowed, "", until_s - r.slowed_end_s, until_s, 0.5 * r.slowed_end_s, "s",
                       fmt::format("slowed: the last {:.2f} s take {:.2f} s, because the file does not end at rest",
                                   0.5 * r.slowed_end_s, r.slowed_end_s)});
  }
  if (r.stood_end_s > 0.0) {
    changes.push_back(
        {RepairChangeKind::kStood, "", end_s - r.stood_end_s, end_s, r.stood_end_s, "s",
         fmt::format("stood: {:.2f} s were added at the end, because the file ends with a foot in the air; "
                     "the robot sets it down and stands",
                     r.stood_end_s)});
  }
}

/// Time of the plan at which the robot does what the file has at a time.
double PlanTimeOf(const RestedMotion& rested, double file_s) {
  const auto row = std::lower_bound(rested.file_s.begin(), rested.file_s.end(), file_s) - rested.file_s.begin();
  return rested.motion.TimeOf(static_cast<int>(std::min<std::ptrdiff_t>(row, std::ssize(rested.file_s) - 1)));
}

void AddSlowedParts(const MotionFindings& findings, std::vector<RepairChange>& changes) {
  const auto plan_s = [&](double file_s) { return PlanTimeOf(findings.rested, file_s); };
  for (const SlowedPart& part : findings.slowed) {
    const double start_s = std::max(0.0, part.start_s), end_s = std::min(findings.duration_s, part.end_s);
    const double from_s = plan_s(start_s), to_s = plan_s(end_s);
    changes.push_back(
        {RepairChangeKind::kSlowed, "", from_s, to_s, (to_s - from_s) - (end_s - start_s), "s",
         fmt::format("slowed: {:.2f} to {:.2f} s of the file take {:.2f} times as long, because {} at the file's "
                     "speed",
                     start_s, end_s, part.factor, part.why)});
  }
}

void AddLeftOutParts(const MotionFindings& findings, std::vector<RepairChange>& changes) {
  for (const LeftOutPart& part : findings.left_out) {
    const double moved_m = part.moved.translation().norm();
    std::string text = fmt::format("left out: {:.2f} to {:.2f} s of the file, because {}; the robot stands instead",
                                   part.start_s, part.end_s, part.why);
    if (part.end_s < findings.duration_s && moved_m > kMovedLittle)
      text += ", and what follows is moved, so that it begins where the robot stands";
    changes.push_back({RepairChangeKind::kLeftOut, "", PlanTimeOf(findings.rested, part.start_s),
                       PlanTimeOf(findings.rested, part.end_s), part.end_s - part.start_s, "s", text});
  }
}

void AddPartedLinks(const MotionFindings& findings, std::vector<RepairChange>& changes) {
  for (const PartedLinks& parted : findings.parted) {
    if (parted.depth_m < kMovedLittle) continue;
    changes.push_back({RepairChangeKind::kParted, parted.links, parted.start_s, parted.end_s, parted.depth_m, "m",
                       fmt::format("parted: {} overlap by up to {:.1f} mm between {:.2f} and {:.2f} s in the file",
                                   parted.links, 1e3 * parted.depth_m, parted.start_s, parted.end_s)});
  }
}

void AddHeldJoints(const RobotModel& model, const MotionFindings& findings, std::vector<RepairChange>& changes) {
  for (const HeldJoint& held : findings.clean.held) {
    const std::string& joint = model.dof_names[static_cast<std::size_t>(held.dof)];
    const bool slides = model.LeaderOf(held.dof).is_prismatic();
    changes.push_back(
        {RepairChangeKind::kHeld, joint, 0.0, findings.duration_s, held.moved, slides ? "m" : "rad",
         fmt::format("held: joint '{}' stays where it is, because its dry friction of {:.3g} {} is {} the "
                     "limit of its motor",
                     joint, held.friction, slides ? "N" : "N m", held.friction < held.limit ? "near" : "at or over")});
  }
}

Json AuditOf(const AuditReport& report) { return Json::parse(AuditJson(report)); }

Json ChangeJson(const RepairChange& change) {
  return {{"what", RepairChangeName(change.kind)},
          {"where", change.where},
          {"start_s", change.start_s},
          {"end_s", change.end_s},
          {"by", change.by},
          {"unit", change.unit},
          {"text", change.text}};
}

Json GroupsJson(const std::vector<GroupDistance>& groups) {
  Json json = Json::object();
  for (const GroupDistance& one : groups) {
    json[one.group] = {{"unit", one.unit},
                       {"rms", one.rms},
                       {"largest", one.largest},
                       {"largest_where", one.largest_where},
                       {"largest_at_s", one.largest_s}};
  }
  return json;
}

Json DistanceJson(const MotionDistance& d) {
  return {{"joint_rms_rad", d.joint_rms_rad},         {"joint_mean_rad", d.joint_mean_rad},
          {"joint_largest_rad", d.joint_largest_rad}, {"joint_largest", d.joint_largest},
          {"joint_largest_at_s", d.joint_largest_s},  {"base_rms_m", d.base_rms_m},
          {"base_largest_m", d.base_largest_m},       {"base_largest_at_s", d.base_largest_s},
          {"base_turn_rms_rad", d.base_turn_rms_rad}, {"groups", GroupsJson(d.groups)}};
}

std::string DistanceText(const MotionDistance& d) {
  std::string text = fmt::format(
      "distance from the file: joints {:.4f} rad RMS, at most {:.3f} rad ('{}' at {:.2f} s); base {:.1f} mm RMS, at "
      "most "
      "{:.1f} mm at {:.2f} s; base turned {:.4f} rad RMS\n",
      d.joint_rms_rad, d.joint_largest_rad, d.joint_largest, d.joint_largest_s, 1e3 * d.base_rms_m,
      1e3 * d.base_largest_m, d.base_largest_s, d.base_turn_rms_rad);
  for (const GroupDistance& one : d.groups) {
    if (one.group == "base") continue;
    const auto figure = [&](double value) {
      return one.unit == "rad" ? fmt::format("{:.4f} rad", value) : fmt::format("{:.1f} mm", 1e3 * value);
    };
    text += fmt::format(
        "  {:<15} {} RMS, at most {}{}\n", WordsOfGroup(one.group), figure(one.rms), figure(one.largest),
        one.largest_where.empty() ? "" : fmt::format(" ('{}' at {:.2f} s)", one.largest_where, one.largest_s));
  }
  return text;
}

std::string BeforeText(const MotionFindings& findings) {
  if (!findings.before) return fmt::format("before: cannot be audited: {}\n", findings.not_audited);
  return "before: " + AuditText(*findings.before) + BrokenText(findings.broken);
}

}  // namespace

const char* RepairChangeName(RepairChangeKind kind) {
  switch (kind) {
    case RepairChangeKind::kSmoothed:
      return "smoothed";
    case RepairChangeKind::kLifted:
      return "lifted";
    case RepairChangeKind::kSlowed:
      return "slowed";
    case RepairChangeKind::kLeftOut:
      return "left_out";
    case RepairChangeKind::kStood:
      return "stood";
    case RepairChangeKind::kPinned:
      return "pinned";
    case RepairChangeKind::kParted:
      return "parted";
    case RepairChangeKind::kHeld:
      return "held";
    case RepairChangeKind::kContacts:
      return "contacts";
    case RepairChangeKind::kOtherContact:
      return "other_contact";
  }
  return "";
}

std::vector<RepairChange> ChangesOf(const RobotModel& model, const MotionFindings& findings) {
  std::vector<RepairChange> changes;
  if (findings.smoothing_hz > 0.0) {
    changes.push_back({RepairChangeKind::kSmoothed, "", 0.0, findings.duration_s, findings.smoothing_hz, "Hz",
                       fmt::format("smoothed: positions were smoothed above {:.3g} Hz", findings.smoothing_hz)});
  }
  AddContactChange(findings, changes);
  AddOtherContacts(findings, changes);
  AddTimeChanges(findings, changes);
  AddSlowedParts(findings, changes);
  AddLeftOutParts(findings, changes);
  const double lift_m = findings.clean.lift_m;
  if (std::abs(lift_m) > kMovedLittle) {
    changes.push_back(
        {RepairChangeKind::kLifted, "", 0.0, findings.duration_s, lift_m, "m",
         fmt::format("lifted: the base was moved {} by {:.1f} mm, because the feet {}", lift_m > 0.0 ? "up" : "down",
                     1e3 * std::abs(lift_m), lift_m > 0.0 ? "sink into the ground" : "are above the ground")});
  }
  for (const PinnedStance& stance : findings.clean.stances) {
    if (stance.slid_m < kMovedLittle && stance.tilt_rad < kTiltedLittle) continue;
    const std::string& foot = model.feet[static_cast<std::size_t>(stance.foot)].name;
    changes.push_back(
        {RepairChangeKind::kPinned, foot, stance.start_s, stance.end_s, stance.slid_m, "m",
         fmt::format("pinned: foot '{}' from {:.2f} to {:.2f} s, moved by up to {:.1f} mm{}{}", foot, stance.start_s,
                     stance.end_s, 1e3 * stance.slid_m,
                     stance.parted_m < kMovedLittle
                         ? ""
                         : fmt::format(", of which {:.1f} mm because another foot stood there", 1e3 * stance.parted_m),
                     stance.tilt_rad < kTiltedLittle
                         ? ""
                         : fmt::format(", turned flat by up to {:.2f} rad", stance.tilt_rad))});
  }
  AddPartedLinks(findings, changes);
  AddHeldJoints(model, findings, changes);
  return changes;
}

bool RepairResult::pass() const {
  if (repaired == nullptr) return findings.before && findings.before->pass();
  return repaired->after.pass() && (played == nullptr || played->pass());
}

std::string RepairText(const RepairResult& result) {
  const MotionFindings& findings = result.findings;
  std::string text = fmt::format("{}: {} rows of {}, {:.3f} s\n", result.model.name, findings.rows,
                                 MotionFormatName(findings.format), findings.duration_s);
  for (const DerivedPart& part : findings.notes.derived) text += fmt::format("derived: {}: {}\n", part.what, part.how);
  for (const std::string& column : findings.unused) text += fmt::format("not used: {}\n", column);
  for (const std::string& warning : findings.notes.warnings) text += fmt::format("warning: {}\n", warning);
  text += BeforeText(findings);
  const bool kept = findings.kept;
  for (const RepairChange& change : ChangesOf(result.model, findings)) {
    if (!kept || change.kind == RepairChangeKind::kSmoothed) text += change.text + "\n";
  }
  if (result.repaired == nullptr) return text;
  if (!findings.lost.empty()) text += "not left out: " + LostText(findings.lost, findings.duration_s) + "\n";
  if (kept) text += "the motion was already feasible, and was kept\n";
  text += DistanceText(result.repaired->distance);
  if (!kept) text += result.repaired->finished.summary + "\n";
  text += "after: " + AuditText(result.repaired->after) + BrokenText(result.repaired->broken);
  if (result.played == nullptr) return text;
  const std::vector<EngineVerdict> verdicts = VerdictsOf(*result.played);
  text += verdicts.empty()
              ? fmt::format("played: {}, {:.1f}\n", result.played->pass() ? "pass" : "fail", result.played->score())
              : "played: " + VerdictsText(verdicts) + "\n";
  return text;
}

std::string RepairJson(const RepairResult& result, const std::vector<std::pair<std::string, std::string>>& files) {
  const MotionFindings& findings = result.findings;
  Json changes = Json::array(), derived = Json::array();
  const bool kept = findings.kept;
  for (const RepairChange& change : ChangesOf(result.model, findings)) {
    if (!kept || change.kind == RepairChangeKind::kSmoothed) changes.push_back(ChangeJson(change));
  }
  for (const DerivedPart& part : findings.notes.derived) derived.push_back({{"what", part.what}, {"how", part.how}});
  Json json = {{"robot", result.model.name},
               {"verdict", result.pass() ? "pass" : "fail"},
               {"format", MotionFormatName(findings.format)},
               {"rows", findings.rows},
               {"duration_s", findings.duration_s},
               {"smoothing_hz", findings.smoothing_hz},
               {"derived", derived},
               {"unused_columns", findings.unused},
               {"warnings", findings.notes.warnings},
               {"kept", kept},
               {"before", findings.before ? AuditOf(*findings.before) : Json()},
               {"broken", Json::parse(BrokenJson(findings.broken))},
               {"changes", changes}};
  Json paths = Json::object();
  for (const auto& [kind, path] : files) paths[kind] = path;
  if (result.repaired == nullptr) {
    if (!files.empty()) json["files"] = paths;
    return json.dump(2);
  }
  const FollowReport& finished = result.repaired->finished;
  json["distance"] = DistanceJson(result.repaired->distance);
  json["after"] = AuditOf(result.repaired->after);
  json["broken_after"] = Json::parse(BrokenJson(result.repaired->broken));
  json["optimisation"] = {{"knots", finished.knots},
                          {"windows", finished.windows},
                          {"solves", finished.solves},
                          {"iterations", finished.iterations},
                          {"solve_cpu_s", finished.solve_cpu_s}};
  Json engines = Json::object();
  if (result.played != nullptr) {
    for (const EngineVerdict& verdict : VerdictsOf(*result.played))
      engines[verdict.engine] = {{"verdict", VerdictName(verdict)}, {"score", verdict.score}, {"cause", verdict.cause}};
    json["score"] = result.played->score();
    json["reason"] = result.played->decisive().report.reason;
  }
  json["engines"] = engines;
  json["files"] = paths;
  return json.dump(2);
}

}  // namespace gaitwright
