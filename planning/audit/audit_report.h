// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/base/law.h"

namespace gaitwright {

/// Ending of names of start_posture places that are speeds.
inline constexpr char kStartSpeed[] = ", speed";
/// Place name of start_posture for the tilt of the base.
inline constexpr char kStartTilt[] = "base tilt";

/// Margin of a plan to the limit of a check at one place; negative for a violation.
struct AuditMargin {
  Law law = Law::kConsistency;
  double at_s = 0.0;  ///< time of the smallest margin
  std::string where;  ///< joint, foot or pair of links
  double value = 0.0, limit = 0.0;
  double margin = 0.0;          ///< distance of the value from the limit; negative beyond it
  std::optional<double> share;  ///< margin / limit, if the limit is a size from zero up
  std::string unit;             ///< of value, limit and margin; "1" without unit

  bool operator==(const AuditMargin&) const = default;
};

/// Result of the audit.
struct AuditReport {
  std::vector<Violation> violations;  ///< by check in a fixed order, then worst first
  std::vector<std::string> notes;     ///< limits that are placeholders, and checks that were not possible
  std::vector<std::string> remarks;   ///< likely causes of failed checks, with remedies
  int samples = 0;
  double rate_hz = 1000.0;
  std::vector<AuditMargin> margins;  ///< by check in the same order, then smallest first; only if requested

  bool pass() const { return violations.empty(); }
};

/// The smallest margin of each check, from a report's list.
std::vector<AuditMargin> TightestOfEachLaw(const std::vector<AuditMargin>& margins);

/// A value with its unit, four digits; the unit "1" is not shown.
std::string AuditFigure(double value, const std::string& unit);

/// The verdict, one line for each violation, and one line for each remark and margin of the report.
std::string AuditText(const AuditReport& report);

/// {"verdict", "violations": [{"law", "at_s", "where", "value", "limit", "unit"}], "samples", "notes"}, and "remarks"
/// and "margins" if the report has them. Margins have the same keys, and "margin" and "share".
std::string AuditJson(const AuditReport& report);

}  // namespace gaitwright
