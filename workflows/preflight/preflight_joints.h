// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "planning/audit/audit_report.h"

namespace gaitwright {

/// What each joint has left of each of its limits, as a table.
struct JointMargins {
  /// What one joint has left.
  struct Row {
    std::string joint;
    std::vector<std::string> cells;  ///< by heading: "12 %", a figure with its unit, or a dash where there is no limit
    std::vector<bool> broken;        ///< by heading
  };
  std::vector<std::string> headings;  ///< of the laws that any joint has a limit of
  std::vector<Row> rows;              ///< by joints' names
};

/// @param margins  of an audit.
JointMargins JointMarginsOf(const std::vector<AuditMargin>& margins);

}  // namespace gaitwright
