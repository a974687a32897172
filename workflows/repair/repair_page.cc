// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#include "playback/report/engines_part.h"
#include "playback/report/page_parts_internal.h"
#include "playback/report/svg_tools.h"
#include "playback/viewer/viewer_page.h"
#include "workflows/repair/repair_page_internal.h"

namespace gaitwright {
namespace {

constexpr std::size_t kMostOpen = 25;          // changes that are shown without a click
constexpr double kMostSceneSamples = 12000.0;  // of the 3D view
constexpr double kLeastSceneRate_hz = 30.0;    // of the 3D view
constexpr double kMovedHardly = 1e-3;          // [m]
constexpr char kNoCells[] = "<td>\u2013</td><td></td>";

bool OnlyChecks(const RepairResult& result, const RepairPageWords& words) {
  return result.repaired == nullptr && words.refused.empty();
}

std::string InUnits(double value, const std::string& unit) {
  return unit == "m" ? fmt::format("{:.1f} mm", 1e3 * value) : fmt::format("{:.4f} {}", value, unit);
}

const BrokenTime* LongestOf(const std::vector<BrokenTime>& broken) {
  const auto longest = std::max_element(broken.begin(), broken.end(),
                                        [](const BrokenTime& a, const BrokenTime& b) { return a.share < b.share; });
  return longest == broken.end() ? nullptr : &*longest;
}

const BrokenTime* BrokenTimeOf(const std::vector<BrokenTime>& broken, Law law) {
  const auto found = std::find_if(broken.begin(), broken.end(), [law](const auto& one) { return one.law == law; });
  return found == broken.end() ? nullptr : &*found;
}

/// The worst violation of a check.
const Violation* WorstViolation(const AuditReport& report, Law law) {
  const auto found = std::find_if(report.violations.begin(), report.violations.end(),
                                  [law](const Violation& v) { return v.law == law; });
  return found == report.violations.end() ? nullptr : &*found;
}

std::string ViolationText(const Violation& v) {
  return fmt::format("{}: {} (limit {:.4g}) at {:.2f} s", v.where, AuditFigure(v.value, v.unit), v.limit, v.at_s);
}

std::string VerdictReason(const RepairResult& result, const RepairPageWords& words) {
  const MotionFindings& findings = result.findings;
  if (!words.refused.empty()) return words.refused;
  if (result.repaired == nullptr) {
    if (!findings.before) return "the motion cannot be audited: " + findings.not_audited;
    const BrokenTime* longest = LongestOf(findings.broken);
    if (longest == nullptr) return "the motion passes its audit";
    return fmt::format("the motion fails {} of {} checks; {} fails longest, in {} of the time", findings.broken.size(),
                       AllLaws().size(), LawName(longest->law), ShareText(longest->share));
  }
  if (!result.repaired->after.pass())
    return "the plan fails its audit: " + LawName(result.repaired->after.violations.front().law);
  if (result.played != nullptr && !result.pass()) return result.played->decisive().report.reason;
  const std::string passes = findings.kept ? "the motion is sound as it is and was kept; it passes its audit"
                                           : "the repaired motion passes its audit";
  const double left_out_s = DurationOf(findings.left_out);
  const std::string without =
      left_out_s > 0.0 ? fmt::format(", without {:.2f} s of the original that were left out", left_out_s) : "";
  if (result.played == nullptr) return passes + without + ", and was not played in physics";
  return passes + (result.played->second == nullptr ? " and the playback" : " and both engines") + without;
}

std::string HeadOf(const RepairResult& result, const RepairPageWords& words) {
  const MotionFindings& f = result.findings;
  const std::string name = std::filesystem::path(words.source).filename().string();
  std::string about = fmt::format("{} rows of {}, {:.2f} s", f.rows, MotionFormatName(f.format), f.duration_s);
  if (f.smoothing_hz > 0.0) about += fmt::format(", smoothed above {:.3g} Hz", f.smoothing_hz);
  if (result.repaired != nullptr) about += fmt::format("; the plan takes {:.2f} s", result.repaired->plan.duration_s());
  VerdictWords head;
  head.pass = words.refused.empty() && result.pass();
  head.verdict = !words.refused.empty() ? "REFUSED" : head.pass ? "PASS" : "FAIL";
  head.title = fmt::format("{}: {} of {}", result.model.name, OnlyChecks(result, words) ? "check" : "repair", name);
  head.about = about;
  if (result.played != nullptr) {
    head.score = fmt::format("{:.1f}", result.played->score());
    head.score_of = "of 100";
  }
  head.reason = VerdictReason(result, words);
  return VerdictPart(head);
}

std::string LongestCard(const char* when, const std::vector<BrokenTime>& broken) {
  const BrokenTime* longest = LongestOf(broken);
  return CardPart(fmt::format("time for which a check fails, {}", when),
                  longest == nullptr ? "0 %" : ShareText(longest->share),
                  longest == nullptr ? "no check fails" : EscapedXml(LawName(longest->law)));
}

/// Height of the standing feet, and how far they slide.
std::string FeetCards(const RepairResult& result) {
  const CleanMotion& clean = result.findings.clean;
  const double height_m = -clean.lift_m;
  const char* where = std::abs(height_m) < kMovedHardly ? "on the ground"
                      : height_m > 0.0                  ? "they float above the ground"
                                                        : "they sink into the ground";
  const double shown_mm = std::abs(height_m) < 5e-5 ? 0.0 : 1e3 * height_m;  // no minus sign before zero
  std::string html = CardPart("height of the standing feet, original", fmt::format("{:.1f} mm", shown_mm), where);
  const auto worst = std::max_element(clean.stances.begin(), clean.stances.end(),
                                      [](const PinnedStance& a, const PinnedStance& b) { return a.slid_m < b.slid_m; });
  if (worst == clean.stances.end()) return html;
  return html + CardPart("largest slide of a standing foot, original", fmt::format("{:.1f} mm", 1e3 * worst->slid_m),
                         EscapedXml(result.model.feet[static_cast<std::size_t>(worst->foot)].name));
}

std::string CardsOf(const RepairResult& result) {
  const MotionFindings& f = result.findings;
  std::string html = "<div class=\"cards\">\n" + FeetCards(result);
  if (f.before) html += LongestCard("original", f.broken);
  if (const RepairedMotion* repaired = result.repaired) {
    const MotionDistance& d = repaired->distance;
    html += LongestCard("repaired", repaired->broken);
    html += CardPart("distance of the joints, RMS", fmt::format("{:.3f} rad", d.joint_rms_rad),
                     EscapedXml(fmt::format("largest {:.3f} rad", d.joint_largest_rad)));
    html += CardPart("distance of the base, RMS", fmt::format("{:.1f} mm", 1e3 * d.base_rms_m),
                     fmt::format("largest {:.1f} mm", 1e3 * d.base_largest_m));
  }
  return html + "</div>\n";
}

/// The rate at which a motion of this length is shown.
double SceneRateOf(double duration_s) {
  return std::clamp(kMostSceneSamples / std::max(duration_s, 1.0), kLeastSceneRate_hz, kSceneRateHz);
}

std::string ViewerOf(const RepairResult& result, const RepairPageWords& words) {
  const MotionPlan* plan = result.repaired != nullptr ? &result.repaired->plan : result.findings.plan.get();
  if (plan == nullptr) return "";
  ShownMotion shown{result.repaired != nullptr ? "repaired motion" : "original motion", result.model, *plan};
  shown.mesh_folder = words.mesh_folder;
  shown.rate_hz = SceneRateOf(plan->duration_s());
  if (result.repaired != nullptr && result.repaired->original) {
    shown.ghost = {"original motion", [original = result.repaired->original](double time_s) {
                     const auto row = static_cast<int>(std::lround(time_s / original->step_s));
                     return row < original->size() ? original->q[static_cast<std::size_t>(row)] : VectorX();
                   }};
  }
  const std::string viewer = ViewerPart({shown});
  return viewer.empty() ? "" : "<h2 class=\"screen\">In motion</h2>\n" + viewer;
}

/// The worst seconds; no line begins with their unit.
std::string SecondsHtml(const BrokenTime& time) {
  std::string html;
  for (const double start_s : time.worst_s)
    html += fmt::format("{}{:.0f} to {:.0f}&#160;s", html.empty() ? "" : ", ", start_s, start_s + 1.0);
  return html;
}

/// Two cells: share of the time with the worst seconds, and the worst violation.
std::string LawCells(const std::vector<BrokenTime>& broken, const AuditReport& report, Law law) {
  const BrokenTime* time = BrokenTimeOf(broken, law);
  if (time == nullptr) return kNoCells;
  const Violation* worst = WorstViolation(report, law);
  return fmt::format("<td>{}<span class=\"meaning\">longest from {}</span></td><td>{}</td>", ShareText(time->share),
                     SecondsHtml(*time), worst == nullptr ? "" : EscapedXml(ViolationText(*worst)));
}

std::string LawTable(const RepairResult& result) {
  const MotionFindings& f = result.findings;
  const RepairedMotion* repaired = result.repaired;
  std::string rows;
  for (const Law law : AllLaws()) {
    if (BrokenTimeOf(f.broken, law) == nullptr &&
        (repaired == nullptr || BrokenTimeOf(repaired->broken, law) == nullptr))
      continue;
    rows += fmt::format("<tr><td><span class=\"key\">{}</span></td>{}{}</tr>\n", LawName(law),
                        f.before ? LawCells(f.broken, *f.before, law) : "",
                        repaired == nullptr ? "" : LawCells(repaired->broken, repaired->after, law));
  }
  if (rows.empty()) return "<p>No check of the audit fails.</p>\n";
  return fmt::format(
      "<div class=\"scroll\"><table id=\"laws\"><thead><tr><th>check</th>{}{}</tr></thead><tbody>\n{}"
      "</tbody></table></div>\n",
      f.before ? "<th>original, time</th><th>original, worst value</th>" : "",
      repaired == nullptr ? "" : "<th>repaired, time</th><th>repaired, worst value</th>", rows);
}

std::string BrokenPart(const RepairResult& result) {
  const MotionFindings& f = result.findings;
  std::string html = result.repaired == nullptr ? "<h2>What is wrong</h2>\n" : "<h2>Before and after</h2>\n";
  if (!f.before) html += fmt::format("<p>The original cannot be audited: {}.</p>\n", EscapedXml(f.not_audited));
  const Plot plot = BrokenPlot(result);
  if (!plot.svg.empty()) html += FigurePart(plot);
  if (f.before || result.repaired != nullptr) html += LawTable(result);
  return html;
}

std::string DistancePart(const RepairedMotion& repaired) {
  std::string html =
      "<h2>Distance from the original</h2>\n<div class=\"scroll\"><table id=\"groups\"><thead><tr><th>part</th><th "
      "class=\"n\">RMS</th><th class=\"n\">largest</th><th class=\"n\">at</th><th>where</th></tr></thead><tbody>\n";
  for (const GroupDistance& group : repaired.distance.groups) {
    html += fmt::format(
        "<tr><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"n\">{:.2f} s</td><td>{}</td></tr>\n",
        WordsOfGroup(group.group), InUnits(group.rms, group.unit), InUnits(group.largest, group.unit), group.largest_s,
        EscapedXml(group.largest_where));
  }
  html += "</tbody></table></div>\n";
  if (!repaired.original) return html;
  return html + FigurePart(DistancePlot(repaired.distance, repaired.original->step_s));
}

std::string ChangesPart(const RepairResult& result) {
  const bool kept = result.findings.kept;
  std::string items;
  std::size_t count = 0;
  for (const RepairChange& change : ChangesOf(result.model, result.findings)) {
    if (kept && change.kind != RepairChangeKind::kSmoothed) continue;
    items += "<li>" + EscapedXml(change.text) + "</li>\n";
    ++count;
  }
  const std::string head =
      result.repaired == nullptr ? "<h2>What a repair would change</h2>\n" : "<h2>What was changed, and why</h2>\n";
  if (count == 0)
    return head + (kept ? "<p>Nothing.</p>\n"
                        : "<p>Contacts and times are those of the file. The whole body was optimised.</p>\n");
  const std::string list = "<ul id=\"changes\">\n" + items + "</ul>\n";
  if (count <= kMostOpen) return head + list;
  return head + fmt::format("<details><summary>{} changes</summary>\n{}</details>\n", count, list);
}

std::string EnginesOf(const PlayedWalk& played) {
  std::optional<SecondVerdict> second;
  if (played.second != nullptr)
    second.emplace(SecondVerdict{played.second->log, played.second->report, played.second->agreement});
  return EngineVerdicts(played.log, played.report, second);
}

std::string SourcePart(const RepairResult& result) {
  const MotionFindings& f = result.findings;
  std::vector<std::string> notes;
  for (const DerivedPart& part : f.notes.derived) notes.push_back(fmt::format("derived: {}: {}", part.what, part.how));
  for (const std::string& column : f.unused) notes.push_back("not used: " + column);
  for (const std::string& warning : f.notes.warnings) notes.push_back("warning: " + warning);
  std::string html = ListPart("Notes on the file", notes);
  if (f.before) {
    std::vector<std::string> all;
    for (const Violation& v : f.before->violations) all.push_back(LawName(v.law) + ", " + ViolationText(v));
    for (const std::string& remark : f.before->remarks) all.push_back("note: " + remark);
    if (!all.empty()) {
      html += fmt::format("<details><summary>All {} violations of the original</summary>\n<ul>\n", all.size());
      for (const std::string& line : all) html += "<li>" + EscapedXml(line) + "</li>\n";
      html += "</ul></details>\n";
    }
  }
  if (result.repaired != nullptr) html += OptionsPart("All options", result.repaired->plan.provenance.options);
  return html;
}

void AddFall(const ScoredPlayback& played, std::vector<std::string>& parts) {
  const std::string engine = EngineTitle(EngineOf(played.log));
  const Metric& fell = played.report.At("fell");
  if (fell.value.value_or(0.0) > 0.0) {
    parts.push_back(fell.at_s
                        ? fmt::format("the robot falls in {} at {:.2f} s: {}", engine, *fell.at_s, played.report.reason)
                        : fmt::format("the robot falls in {}: {}", engine, played.report.reason));
  } else if (!played.report.pass) {
    parts.push_back(fmt::format("in {}, {}", engine, played.report.reason));
  }
}

}  // namespace

std::vector<std::string> UnsavedParts(const RepairResult& result, const std::string& refused) {
  std::vector<std::string> parts;
  if (!refused.empty()) parts.push_back(refused);
  for (const LeftOutPart& part : result.findings.left_out)
    parts.push_back(fmt::format("{:.2f} to {:.2f} s of the original were left out, because {}", part.start_s,
                                part.end_s, part.why));
  if (!result.findings.lost.empty()) parts.push_back(LostText(result.findings.lost, result.findings.duration_s));
  const CleanMotion& clean = result.findings.clean;
  if (clean.unreached_m > kMovedHardly) {
    parts.push_back(
        fmt::format("a foot is up to {:.1f} mm from its place at {:.2f} s, because the leg does not reach it",
                    1e3 * clean.unreached_m, clean.unreached_s));
  }
  if (result.repaired != nullptr) {
    for (const BrokenTime& broken : result.repaired->broken) {
      const Violation* worst = WorstViolation(result.repaired->after, broken.law);
      parts.push_back(fmt::format("{} still fails in {} of the time, longest from {}{}", LawName(broken.law),
                                  ShareText(broken.share), WorstSecondsText(broken),
                                  worst == nullptr ? "" : "; worst: " + ViolationText(*worst)));
    }
  }
  if (result.played != nullptr) {
    AddFall(*result.played, parts);
    if (result.played->second != nullptr) AddFall(*result.played->second, parts);
  }
  return parts;
}

std::string RepairPage(const RepairResult& result, const RepairPageWords& words) {
  std::string html = HeadOf(result, words) + CardsOf(result) + ViewerOf(result, words) + BrokenPart(result);
  if (result.repaired != nullptr) html += DistancePart(*result.repaired);
  html += ChangesPart(result);
  if (!OnlyChecks(result, words)) {
    const std::vector<std::string> unsaved = UnsavedParts(result, words.refused);
    html += unsaved.empty() ? "<h2>Parts that stay infeasible</h2>\n<p>None.</p>\n"
                            : ListPart("Parts that stay infeasible", unsaved);
  }
  if (result.played != nullptr) html += EnginesOf(*result.played);
  html += SourcePart(result);
  const std::string name = std::filesystem::path(words.source).filename().string();
  return WholePage(fmt::format("{}: {}", result.model.name, name), html);
}

}  // namespace gaitwright
