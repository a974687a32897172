// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/base/result.h"
#include "playback/trials/disturbances.h"
#include "workflows/sandbox/child_process.h"

namespace gaitwright {

/// A number, or from where to where it is drawn, uniformly, for each run.
struct NumberRange {
  double low = 0.0, high = 0.0;

  bool operator==(const NumberRange&) const = default;
};

/// Ranges by name, in the order of the file.
using NamedRanges = std::vector<std::pair<std::string, NumberRange>>;

/// What a part of a rubric is about, and so what is handed in for it.
enum class PartKind { kFunction, kAnswers, kPlan, kMotion, kParameters, kPlanner, kController };

/// Their names in a rubric, in the order of the enumeration.
const std::vector<std::string>& PartKindNames();

/// Whether submissions of that kind are Python that is run.
bool RunsCode(PartKind kind);
/// Whether motions are played for it.
bool PlaysMotions(PartKind kind);

/// What is measured and what it is worth: all points at `full_at` or better, none at `none_at` or worse, in proportion
/// between them. Without `none_at` it is all or nothing.
struct Check {
  std::string measure;
  double points = 0.0;
  double full_at = 1.0;
  std::optional<double> none_at;
  bool higher_is_better = true;

  /// The points of a value.
  double PointsOf(double value) const;
};

/// Functions and answers: what they are held against.
struct QuestionSetup {
  std::string reference;  ///< one of QuestionNames()
  int cases = 20;
  double tolerance = 1e-6;            ///< of the error that the reference defines
  int size = 6;                       ///< how many points or steps there are, where the reference has a number of them
  std::string robot;                  ///< where it needs one
  NamedRanges inputs;                 ///< other ranges than the usual
  std::optional<std::uint64_t> seed;  ///< of inputs that are always the same
};

/// Motions: on what they are walked, and how they are played.
struct MotionSetup {
  std::string robot, gait;
  std::string terrain = "flat";
  NamedRanges terrain_parameters;
  NamedRanges command;  ///< by CommandKeys()
  int runs = 1;
  NamedRanges play_numbers;
  std::vector<std::pair<std::string, std::string>> play_words;
  std::string controller = "stabilised";
  int trials = 0;
  std::optional<Disturbances> disturbances;  ///< nothing for the standard ones
  double swing_s = 0.5, pause_s = 0.1;       ///< of a planner's steps
  std::vector<std::string> options;          ///< keys that a file of parameters may set; those that end in * begin so
  double longest_motion_s = 60.0;
};

/// Whether a list such as MotionSetup::options has a key.
bool MayBeSet(const std::string& key, const std::vector<std::string>& allowed);

/// What the command of a part may say.
const std::vector<std::string>& CommandKeys();

/// A part of a rubric.
/// Always true: the points of its checks add up to its own, and it has what its kind needs.
struct RubricPart {
  std::string name, title;
  PartKind kind = PartKind::kFunction;
  std::string file;      ///< a plain name in the student's folder
  std::string function;  ///< that is called, where code is run
  bool package = false;  ///< whether the code may import gaitwright
  double points = 0.0;
  ChildLimits limits;
  double judge_s = 600.0;  ///< processor time that judging a submission may take, its code apart
  std::vector<Check> checks;
  QuestionSetup question;
  MotionSetup motion;
};

/// What an assignment is marked by.
struct Rubric {
  std::string title;
  std::vector<RubricPart> parts;

  double points() const;
};

/// Reads a rubric, see docs/grading.md. Refused with the line: what is no YAML, unknown keys (the nearest is named),
/// values that are out of range, names that there are not, checks whose points do not add up to their part's.
/// @param source names the text in messages.
Result<Rubric> ReadRubric(const std::string& text, const std::string& source);

/// The same from a file.
Result<Rubric> LoadRubric(const std::string& path);

}  // namespace gaitwright
