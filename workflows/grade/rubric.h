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

/// A number, or the range from which it is drawn uniformly for each run.
struct NumberRange {
  double low = 0.0, high = 0.0;

  bool operator==(const NumberRange&) const = default;
};

/// Ranges by name, in the order of the file.
using NamedRanges = std::vector<std::pair<std::string, NumberRange>>;

/// Kind of a part of a rubric, which sets the submitted file.
enum class RubricPartKind { kFunction, kAnswers, kPlan, kMotion, kParameters, kPlanner, kController };

/// Their names in a rubric, in the order of the enumeration.
const std::vector<std::string>& PartKindNames();

/// Whether submissions of this kind are Python code to run.
bool RunsCode(RubricPartKind kind);
/// Whether motions are played for this kind.
bool PlaysMotions(RubricPartKind kind);

/// A measure and its points: all points at `full_at` or better, none at `none_at` or worse, linear in between. Without
/// `none_at`, all or nothing.
struct Check {
  std::string measure;
  double points = 0.0;
  double full_at = 1.0;
  std::optional<double> none_at;
  bool higher_is_better = true;

  /// The points of a value.
  double PointsOf(double value) const;
};

/// Functions and answers: their reference.
struct QuestionSetup {
  std::string reference;  ///< one of QuestionNames()
  int cases = 20;
  double tolerance = 1e-6;            ///< largest error, as defined by the reference
  int size = 6;                       ///< number of points or steps, if the reference needs it
  std::string robot;                  ///< robot name, if the reference needs one
  NamedRanges inputs;                 ///< ranges that replace the default ones
  std::optional<std::uint64_t> seed;  ///< seed of inputs that are always the same
};

/// Motions: ground, command and playback.
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
  std::optional<Disturbances> disturbances;  ///< nothing for the standard set
  double swing_s = 0.5, pause_s = 0.1;       ///< times of a planner's steps
  std::vector<std::string> options;          ///< keys that a parameter file may set; a * at the end matches any rest
  double longest_motion_s = 60.0;
};

/// Whether a list such as MotionSetup::options has a key.
bool MayBeSet(const std::string& key, const std::vector<std::string>& allowed);

/// Keys of a part's command.
const std::vector<std::string>& CommandKeys();

/// A part of a rubric. Invariant: the points of its checks add up to its points, and it has everything that its kind
/// needs.
struct RubricPart {
  std::string name, title;
  RubricPartKind kind = RubricPartKind::kFunction;
  std::string file;      ///< a plain name in the student's folder
  std::string function;  ///< function to call, if code runs
  bool package = false;  ///< whether the code may import gaitwright
  double points = 0.0;
  ChildLimits limits;
  double judge_s = 600.0;  ///< CPU time limit of marking a submission, without its code
  std::vector<Check> checks;
  QuestionSetup question;
  MotionSetup motion;
};

/// Marking scheme of an assignment.
struct Rubric {
  std::string title;
  std::vector<RubricPart> parts;

  double points() const;
};

/// Reads a rubric, see docs/grading.md. It refuses, with the line: invalid YAML, unknown keys (with the nearest),
/// values out of range, unknown names, and checks whose points do not add up to those of their part.
/// @param source  name of the text in messages.
Result<Rubric> ReadRubric(const std::string& text, const std::string& source);

/// Reads a rubric from a file.
Result<Rubric> LoadRubric(const std::string& path);

}  // namespace gaitwright
