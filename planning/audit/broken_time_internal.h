// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "planning/audit/audit.h"

namespace gaitwright {

/// Time from the first to after the last of consecutive samples at which a check fails.
struct BrokenSpan {
  double start_s = 0.0, end_s = 0.0;

  bool operator==(const BrokenSpan&) const = default;
};

/// How long a plan fails a check, at any place.
struct BrokenTime {
  Law law = Law::kConsistency;
  double share = 0.0;           ///< of the plan's samples
  std::vector<double> worst_s;  ///< starts of the whole seconds in which it fails longest, at most three, longest first
  std::vector<BrokenSpan> spans = {};  ///< in order

  bool operator==(const BrokenTime&) const = default;
};

/// Audit, with the times for which each check fails, in the order of AllLaws.
Result<AuditReport> AuditOverTime(const RobotModel& model, const MotionPlan& plan, const AuditOptions& options,
                                  std::vector<BrokenTime>& broken);

/// A line for each check: "  joint_torque  fails in 12.3 % of the time, longest from 3 to 4 s".
std::string BrokenText(const std::vector<BrokenTime>& broken);

/// A share of time in per cent: "12.3 %"; never 0 for what happens at all.
std::string ShareText(double share);

/// The worst seconds of a check: "3 to 4 s, 10 to 11 s".
std::string WorstSecondsText(const BrokenTime& broken);

/// A list of {"law", "share", "worst_s"}.
std::string BrokenJson(const std::vector<BrokenTime>& broken);

}  // namespace gaitwright
