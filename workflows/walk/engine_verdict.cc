// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/walk/engine_verdict.h"

#include <fmt/format.h>

#include "playback/score/agreement.h"

namespace gaitwright {
namespace {

EngineVerdict VerdictOfEngine(const ScoredPlayback& played) {
  const StabilityReport& report = played.report;
  const bool fell = report.At("fell").value.value_or(0.0) != 0.0;
  return {EngineOf(played.log), report.pass, fell, report.score, report.cause};
}

}  // namespace

std::vector<EngineVerdict> VerdictsOf(const PlayedWalk& played) {
  if (played.second == nullptr) return {};
  return {VerdictOfEngine(played), VerdictOfEngine(*played.second)};
}

std::string VerdictName(const EngineVerdict& verdict) {
  if (verdict.pass) return "pass";
  return verdict.fell ? "fell" : "fail";
}

std::string VerdictText(const EngineVerdict& verdict) {
  return fmt::format("{}, {:.1f}", VerdictName(verdict), verdict.score);
}

std::string VerdictsText(const std::vector<EngineVerdict>& verdicts) {
  std::string text;
  for (const EngineVerdict& verdict : verdicts)
    text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", EngineTitle(verdict.engine), VerdictText(verdict));
  return text;
}

}  // namespace gaitwright
