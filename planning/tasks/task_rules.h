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
  double lowest = 0.0, highest = 0.0;  ///< limits of a number or a count
  std::vector<std::string> words;      ///< accepted words
  std::string meaning;
};

/// What a robot must have for an action.
enum class Needs { kNothing, kArm, kTwoSoles, kFourFeet, kManyFeet, kTurningFeet, kLeap, kFlip };

/// An action of the repertoire.
struct ActionRule {
  std::string action;
  std::vector<std::string> required, optional;  ///< keys of parameters
  Needs needs = Needs::kNothing;
  bool is_gesture = false;  ///< true if it can run during another task
  std::string meaning;
  std::string instead;    ///< an action that a robot can do if it cannot do this one
  double most_deg = 0.0;  ///< largest angle, if less than the parameter's limit
};

/// Limits of a number or a count of an action.
struct ParameterRange {
  double lowest = 0.0, highest = 0.0;
};
/// Limits of the parameter, or the action's own limits if it has any.
ParameterRange RangeOf(const ActionRule& action, const ParameterRule& parameter);

const std::vector<ParameterRule>& ParameterRules();
const std::vector<ActionRule>& ActionRules();

/// The rule with this key; null if the key is unknown.
const ParameterRule* FindParameter(const std::string& key);
const ActionRule* FindAction(const std::string& action);

/// Parameters of walking that set the distance. A task has at most one of them.
const std::vector<std::string>& ExtentKeys();

/// Abilities of a robot, and the places of its ground.
struct TaskScope {
  std::string robot;
  bool left_arm = false, right_arm = false, head = false, two_soles = false, four_feet = false;
  bool many_feet = false;          ///< four or more
  bool turning_feet = false;       ///< no joint limit keeps its feet from turning while it walks
  bool leaps = false;              ///< a gait exists in which its feet leap at once
  std::vector<std::string> flips;  ///< directions in which a gait turns its body over
  std::vector<PlaceName> places;   ///< `number` is how many places have that name; 0 for a single one

  /// Whether the robot has what an action needs.
  bool Can(const ActionRule& rule) const;
  /// The actions that the robot can do.
  std::vector<std::string> Actions() const;
};

/// Abilities of a robot; places are left empty.
TaskScope ScopeOf(const RobotModel& model);

/// Reason why a task is invalid for every robot: an unknown action or parameter (the message names the nearest one), a
/// missing parameter, parameters that exclude each other, a value of the wrong kind or out of range; codes `action`,
/// `parameter`, `range`.
std::optional<Failure> ReasonNoTask(const Task& task);

/// Reason why this robot cannot do a valid task here: codes `cannot`, `place`. Call ReasonNoTask first.
std::optional<Failure> ReasonNotDone(const Task& task, const TaskScope& scope);

/// The first task of a plan that is invalid, or that the robot cannot do, with its number and words. Also fails for a
/// plan without tasks, or with more than kMostTasks.
inline constexpr std::size_t kMostTasks = 50;
std::optional<Failure> ReasonNotPlanned(const TaskPlan& plan, const TaskScope& scope);

}  // namespace gaitwright
