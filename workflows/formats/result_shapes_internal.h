// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/data_shape.h"

namespace gaitwright {

// Parts that several objects have.
DataShape VerdictShape();     ///< "pass" or "fail"
DataShape TextsShape();       ///< a list of sentences
DataShape SurvivalMembers();  ///< an object of survival with its interval, to take members from
DataShape FilesShape(const std::vector<std::string>& kinds);  ///< paths by kind, as far as written
DataShape AuditShape();                                       ///< what every verb has under `audit`
DataShape MarginShape();                                      ///< a margin of the audit

// What a verb prints with --json.
DataShape WalkResultShape();
DataShape DoResultShape();
DataShape AuditResultShape();
DataShape AgreementShape();
DataShape PreflightShape();
DataShape PlanResultShape();
DataShape TrialsResultShape();
DataShape SweepResultShape();
DataShape TuneResultShape();
DataShape MotionComparisonShape();
DataShape ReportComparisonShape();
DataShape ExportResultShape();
DataShape ImportResultShape();
DataShape GradeResultShape();
DataShape RobotsResultShape();
DataShape GaitsResultShape();
DataShape TerrainsResultShape();
DataShape ViewResultShape();
DataShape RenderResultShape();
DataShape LiveResultShape();
DataShape BenchResultShape();
DataShape OptionListShape();
DataShape ReferenceResultShape();
DataShape ErrorShape();

/// `shape` with further members.
DataShape With(DataShape shape, const std::vector<ShapeMember>& more);

}  // namespace gaitwright
