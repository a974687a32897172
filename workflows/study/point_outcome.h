// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "workflows/walk/engine_verdict.h"

namespace gaitwright {

/// Status of a point of a study, from the best to the worst.
enum class PointStatus {
  kPass,         ///< planned, audited and played; every gate passes
  kGateMissed,   ///< played to its end, but a gate of the score fails
  kFell,         ///< fell in physics
  kAuditFailed,  ///< its plan fails its audit
  kRefused,      ///< no plan, or one that cannot be played
};

/// All statuses, in this order.
inline constexpr PointStatus kPointStatuses[] = {PointStatus::kPass, PointStatus::kGateMissed, PointStatus::kFell,
                                                 PointStatus::kAuditFailed, PointStatus::kRefused};

/// "pass", "gate_missed", "fell", "audit_failed", "refused".
std::string StatusName(PointStatus status);

/// Share of trials that survived, with the ends of its 95 % Wilson interval.
struct PointSurvival {
  int trials = 0, survived = 0;
  double share = 0.0, low = 0.0, high = 1.0;
  double score_mean = 0.0;  ///< over the trials

  bool operator==(const PointSurvival&) const = default;
};

/// The share and its interval (see WilsonInterval) for trials > 0, of which `survived` survived.
PointSurvival SurvivalOf(int trials, int survived, double score_mean);

/// One point of a study after planning, audit, playback and, if requested, trials. Invariant: a refused point has no
/// score, no metrics and no survival.
struct PointOutcome {
  std::size_t point = 0;  ///< its number, from 0
  PointStatus status = PointStatus::kRefused;
  std::string code;    ///< code of the refusal, the violated check, the failed gates, or `fell`; empty for a pass
  std::string reason;  ///< one sentence
  std::optional<double> score;
  std::optional<double> fell_at_s;
  std::vector<std::optional<double>> metrics;  ///< in the study's order
  std::optional<PointSurvival> survival;
  std::vector<EngineVerdict> engines = {};  ///< if two engines have played; the values above are of the decisive one

  bool audit_pass() const { return status != PointStatus::kRefused && status != PointStatus::kAuditFailed; }
  bool operator==(const PointOutcome&) const = default;
};

/// The outcome as one line of JSON, which PointFromLine reads back exactly.
std::string PointToLine(const PointOutcome& outcome);

/// Failure kBadInput `journal_line` describes the error in the line.
Result<PointOutcome> PointFromLine(const std::string& line);

/// Whether `a` is better than `b`. In order of importance: the plan passes its audit; higher survival rate; pass;
/// higher score; lower number.
bool IsBetter(const PointOutcome& a, const PointOutcome& b);

}  // namespace gaitwright
