// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workflows/grade/rubric.h"

namespace gaitwright {

/// Result of a check.
struct CheckMark {
  std::string measure;
  std::optional<double> value;  ///< nothing without a measurement
  double points = 0.0, of = 0.0;
};

/// A page about a played motion.
struct MotionPage {
  std::string title, html;
};

/// Points of a part of a submission, with the reasons for lost points. Invariant: the points are the sum over the
/// checks, in the order of the rubric.
struct PartMark {
  std::string part, title;
  double points = 0.0, of = 0.0;
  std::vector<CheckMark> checks;
  std::vector<std::string> reasons;  ///< sentences for the student; quotations of the submission are marked
  std::vector<MotionPage> pages;
};

/// A part with zero points, for the given reason.
PartMark NothingFor(const RubricPart& part, const std::string& reason);

/// A part from the values of its checks, in order; each check that loses points is a reason.
PartMark MarkOf(const RubricPart& part, const std::vector<std::optional<double>>& values);

/// Points of a student's submission.
struct StudentMarks {
  std::string student;
  std::vector<PartMark> parts;

  double points() const;
  double of() const;
};

/// Points as text, with at most two decimals.
std::string PointsText(double points);

}  // namespace gaitwright
