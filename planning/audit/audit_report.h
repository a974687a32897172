// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/base/law.h"

namespace gaitwright {

/// Ending of place names of the check start_posture that are speeds.
inline constexpr char kStartSpeed[] = ", speed";
/// Place name of start_posture for the tilt of the base.
inline constexpr char kStartTilt[] = "base tilt";

/// Margin of a plan to the limit of a check at one place; negative for a violation.
struct AuditMargin {
  Law law = Law::kConsistency;
  double at_s = 0.0;  ///< when it is nearest
  std::string where;  ///< joint, foot or pair of links
  double value = 0.0, limit = 0.0;
  double margin = 0.0;          ///< from the value to the limit; negative beyond it
  std::optional<double> share;  ///< margin over limit, where the limit is a size from zero up
  std::string unit;             ///< of value, limit and margin; "1" for none

  bool operator==(const AuditMargin&) const = default;
};

/// What the audit found; it does not know who made the plan.
struct AuditReport {
  std::vector<Violation> violations;  ///< by law in a fixed order, then worst first
  std::vector<std::string> notes;     ///< limits that are placeholders, and checks that could not be applied
  std::vector<std::string> remarks;   ///< likely causes of failed checks, with remedies
  int samples = 0;
  double rate_hz = 1000.0;
  std::vector<AuditMargin> margins;  ///< by check in the same order, then smallest first; if requested

  bool pass() const { return violations.empty(); }
};

/// The smallest margin of each check: the first of each in a report's list.
std::vector<AuditMargin> TightestOfEachLaw(const std::vector<AuditMargin>& margins);

/// A figure with its unit, four digits; "1" is shown as nothing.
std::string AuditFigure(double value, const std::string& unit);

/// A verdict and a line for each violation; then a line for each remark and margin that the report has.
std::string AuditText(const AuditReport& report);

/// {"verdict", "violations": [{"law", "at_s", "where", "value", "limit", "unit"}], "samples", "notes"}, and "remarks"
/// and "margins" where the report has them; of margins the same keys, with "margin" and "share".
std::string AuditJson(const AuditReport& report);

}  // namespace gaitwright
