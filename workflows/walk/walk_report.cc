// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/walk/walk_report.h"

#include <sstream>
#include <tuple>
#include <vector>

#include "playback/report/report_page.h"
#include "playback/viewer/viewer_page.h"

namespace gaitwright {
namespace {

std::vector<std::string> Lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace

std::string Judged::objection() const {
  return audit_counts && !audit.pass() ? "the plan fails its audit: " + LawName(audit.violations.front().law) : "";
}

std::string WalkReport(const Judged& judged) {
  const auto& [model, plan, played] = std::tie(judged.model, judged.plan, judged.played);
  ReportWords words{Lines(AuditText(judged.audit)), ChangedOptions(plan, played.log), judged.objection(),
                    judged.orbit_part};
  words.viewer = ViewerPart(
      {{TitleOf(model, plan), model, plan, &played.log, &played.report, words.objection, judged.mesh_folder}});
  if (const SecondPlayback* second = played.second.get())
    words.second.emplace(SecondVerdict{second->log, second->report, second->agreement});
  return ReportPage(model, plan, played.log, played.report, words);
}

}  // namespace gaitwright
