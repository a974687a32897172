// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "planning/audit/audit_report.h"

namespace gaitwright {

/// Table of the remaining margin of each joint to each of its limits.
struct JointMargins {
  /// Margins of one joint.
  struct Row {
    std::string joint;
    std::vector<std::string> cells;  ///< by heading: "12 %", a value with its unit, or a dash if there is no limit
    std::vector<bool> broken;        ///< by heading
  };
  std::vector<std::string> headings;  ///< checks for which at least one joint has a limit
  std::vector<Row> rows;              ///< by joint name
};

/// @param margins  margins from an audit.
JointMargins JointMarginsOf(const std::vector<AuditMargin>& margins);

}  // namespace gaitwright
