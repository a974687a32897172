// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/data_shape.h"

namespace gaitwright {

// Parts that several objects share.
DataShape VerdictShape();     ///< "pass" or "fail"
DataShape TextsShape();       ///< a list of sentences
DataShape SurvivalMembers();  ///< an object whose members are the survival rate and its interval
DataShape FilesShape(const std::vector<std::string>& kinds);  ///< paths of the written files by kind
DataShape BrokenShape();                                      ///< time for which a check fails
DataShape AuditShape();                                       ///< the member `audit` of every verb
DataShape FinishShape();                                      ///< the member `whole_body` of plan and bench
DataShape MarginShape();                                      ///< a margin of the audit

// Output of a verb with --json.
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
DataShape RepairResultShape();
DataShape RepairedClipsShape();  ///< of a folder
DataShape GradeResultShape();
DataShape RobotsResultShape();
DataShape GaitsResultShape();
DataShape TerrainsResultShape();
DataShape ViewResultShape();
DataShape RenderResultShape();
DataShape LiveResultShape();
DataShape BenchResultShape();
DataShape WholeBodyBenchShape();
DataShape OptionListShape();
DataShape ReferenceResultShape();
DataShape ErrorShape();

/// `shape` with further members.
DataShape With(DataShape shape, const std::vector<ShapeMember>& more);

}  // namespace gaitwright
