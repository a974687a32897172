// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace gaitwright {

/// A law that a plan breaks: where it is worst.
struct Violation {
  std::string law;    ///< dynamics, unilateral, friction_cone, zmp_support, joint_position, ...
  double at_s = 0.0;  ///< when it is worst
  std::string where;  ///< joint, foot or pair of links
  double value = 0.0, limit = 0.0;
  std::string unit;

  bool operator==(const Violation&) const = default;
};

/// What the audit found; it does not know who made the plan.
struct AuditReport {
  std::vector<Violation> violations;  ///< by law in a fixed order, then worst first
  std::vector<std::string> notes;     ///< limits that are placeholders and laws that could not be applied
  int samples = 0;
  double rate_hz = 1000.0;

  bool pass() const { return violations.empty(); }
};

/// The names of all laws, in the order of reports: a law stands before those that its breach breaks too, so that the
/// first named is the cause. Columns that disagree make all else doubtful; then come what the postures alone show, what
/// no forces could mend, forces that the ground cannot give, and last the torques.
const std::vector<std::string>& AuditLaws();

/// A verdict and a line for each violation.
std::string AuditText(const AuditReport& report);

/// {"verdict", "violations": [{"law", "at_s", "where", "value", "limit", "unit"}], "samples", "notes"}.
std::string AuditJson(const AuditReport& report);

}  // namespace gaitwright
