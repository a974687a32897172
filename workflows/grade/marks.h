// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workflows/grade/rubric.h"

namespace gaitwright {

/// What a check came to.
struct CheckMark {
  std::string measure;
  std::optional<double> value;  ///< nothing where there was nothing to measure
  double points = 0.0, of = 0.0;
};

/// A page about a motion that was played.
struct MotionPage {
  std::string title, html;
};

/// What a part of a submission is worth, and why not more.
/// Always true: the points are the sum of those of the checks, in the order of the rubric.
struct PartMark {
  std::string part, title;
  double points = 0.0, of = 0.0;
  std::vector<CheckMark> checks;
  std::vector<std::string> reasons;  ///< sentences for the student; words of the submission are marked as such
  std::vector<MotionPage> pages;
};

/// A part of which nothing counts, for that reason.
PartMark NothingFor(const RubricPart& part, const std::string& reason);

/// A part by the values of its checks, in their order; each check that loses points is a reason.
PartMark MarkOf(const RubricPart& part, const std::vector<std::optional<double>>& values);

/// What a student's submission is worth.
struct StudentMarks {
  std::string student;
  std::vector<PartMark> parts;

  double points() const;
  double of() const;
};

/// Points as they are written: at most two digits after the point.
std::string PointsText(double points);

}  // namespace gaitwright
