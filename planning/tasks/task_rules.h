// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "planning/tasks/task_plan.h"

namespace gaitwright {

/// A parameter that actions may have.
struct ParameterRule {
  enum class Kind { kNumber, kCount, kWord, kPlace };

  std::string key;
  Kind kind = Kind::kNumber;
  double lowest = 0.0, highest = 0.0;  ///< of a number or a count
  std::vector<std::string> words;      ///< of a word: those that there are
  std::string meaning;
};

/// What a robot must have for an action.
enum class Needs { kNothing, kArm, kTwoSoles, kFourFeet, kManyFeet, kTurningFeet };

/// An action of the repertoire.
struct ActionRule {
  std::string action;
  std::vector<std::string> required, optional;  ///< keys of parameters
  Needs needs = Needs::kNothing;
  bool is_gesture = false;  ///< may be made while something else is done
  std::string meaning;
  std::string instead;    ///< an action that a robot may do which cannot do this one
  double most_deg = 0.0;  ///< of its angle, where that is less than the parameter's
};

/// The range of a number or a count to an action.
struct ParameterRange {
  double lowest = 0.0, highest = 0.0;
};
/// That of the parameter, or the action's own.
ParameterRange RangeOf(const ActionRule& action, const ParameterRule& parameter);

const std::vector<ParameterRule>& ParameterRules();
const std::vector<ActionRule>& ActionRules();

/// The rule of a name; null where there is none.
const ParameterRule* FindParameter(const std::string& key);
const ActionRule* FindAction(const std::string& action);

/// Parameters of walking of which a task says at most one.
const std::vector<std::string>& ExtentKeys();

/// What a robot can do and where.
struct TaskScope {
  std::string robot;
  bool left_arm = false, right_arm = false, head = false, two_soles = false, four_feet = false;
  bool many_feet = false;         ///< four or more
  bool turning_feet = false;      ///< nothing keeps its feet from turning as it walks
  std::vector<PlaceName> places;  ///< `number` is how many there are of that name; 0 for a single one

  /// Whether it has what an action needs.
  bool Can(const ActionRule& rule) const;
  /// The actions that it can do.
  std::vector<std::string> Actions() const;
};

/// What that robot can do; places are left out.
TaskScope ScopeOf(const RobotModel& model);

/// Why a task is no task at all, whatever the robot: an action or a parameter that there is not (the nearest is named),
/// one that is missing or too many, a value of another kind or out of its range; codes `action`, `parameter`, `range`.
std::optional<Failure> WhyNoTask(const Task& task);

/// Why this robot cannot do it there: codes `cannot`, `place`. The task is one (WhyNoTask).
std::optional<Failure> WhyNotDone(const Task& task, const TaskScope& scope);

/// The first of a plan's tasks that is none, or that the robot cannot do, with its number and words; none in a plan of
/// no task, or of more than kMostTasks.
inline constexpr std::size_t kMostTasks = 50;
std::optional<Failure> WhyNotPlanned(const TaskPlan& plan, const TaskScope& scope);

}  // namespace gaitwright
