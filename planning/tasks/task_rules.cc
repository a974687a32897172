// SPDX-License-Identifier: BSD-3-Clause
#include "planning/tasks/task_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/nearest_name.h"
#include "kinematics/base/options.h"
#include "kinematics/model/upper_body.h"
#include "planning/footsteps/can_walk.h"
#include "planning/gait/leap_gaits_internal.h"

namespace gaitwright {
namespace {

using Kind = ParameterRule::Kind;

constexpr char kCheckStage[] = "CheckTask";

Failure Bad(FailureCode code, const std::string& message, const std::vector<Suggestion>& suggestions = {}) {
  return {FailureKind::kBadInput, code, kCheckStage, message, suggestions};
}

std::vector<std::string> KeysOf(const ActionRule& rule) {
  std::vector<std::string> keys = rule.required;
  keys.insert(keys.end(), rule.optional.begin(), rule.optional.end());
  return keys;
}

template <class Rules>
std::vector<std::string> NamesOf(const Rules& rules) {
  std::vector<std::string> names;
  for (const auto& rule : rules) {
    if constexpr (requires { rule.action; }) {
      names.push_back(rule.action);
    } else {
      names.push_back(rule.key);
    }
  }
  return names;
}

bool Contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::optional<Failure> OutOfRange(const Task& task, const ParameterRule& rule, double value) {
  const ParameterRange range = RangeOf(*FindAction(task.action), rule);
  if (value >= range.lowest && value <= range.highest) return std::nullopt;
  return Bad(FailureCode::kRange, fmt::format("'{}' of '{}' is {:.6g}; accepted: {:.6g} to {:.6g}", rule.key,
                                              task.action, value, range.lowest, range.highest));
}

std::optional<Failure> ReasonNoValue(const Task& task, const ParameterRule& rule, const TaskValue& value) {
  const auto kind = [&](const char* wanted) {
    return Bad(FailureCode::kParameter, fmt::format("'{}' of '{}' must be {}", rule.key, task.action, wanted));
  };
  switch (rule.kind) {
    case Kind::kNumber:
      if (const auto* number = std::get_if<double>(&value)) return OutOfRange(task, rule, *number);
      return kind("a number");
    case Kind::kCount:
      if (const auto* count = std::get_if<int>(&value)) return OutOfRange(task, rule, *count);
      return kind("a whole number");
    case Kind::kWord:
      if (const auto* word = std::get_if<std::string>(&value)) {
        if (Contains(rule.words, *word)) return std::nullopt;
        return Bad(FailureCode::kParameter, fmt::format("'{}' of '{}' is '{}'; accepted: {}", rule.key, task.action,
                                                        *word, QuotedList(rule.words)));
      }
      return kind("a word");
    case Kind::kPlace:
      break;
  }
  const auto* place = std::get_if<PlaceName>(&value);
  if (place == nullptr || place->name.empty()) return kind("a place with a name");
  if (place->number < -1 || place->number > 1000)
    return Bad(FailureCode::kRange, fmt::format("there is no '{1}' number {0}", place->number, place->name));
  return std::nullopt;
}

/// Reason why parameters of a jump contradict each other.
std::optional<Failure> ReasonNoJump(const Task& task) {
  std::vector<std::string> ends;
  for (const char* key : {"distance_m", "to", "level"}) {
    if (task.Has(key)) ends.emplace_back(key);
  }
  if (ends.size() > 1)
    return Bad(FailureCode::kParameter,
               fmt::format("{} each set where to jump; give only one of them", QuotedList(ends)));
  if (task.Has("times") && task.Has("to"))
    return Bad(FailureCode::kParameter, "a jump to a place is done once, so 'times' cannot be used with 'to'");
  if (task.Has("angle_deg") && !task.Has("turn"))
    return Bad(FailureCode::kParameter, "'angle_deg' of 'jump' is for use with 'turn'");
  return std::nullopt;
}

std::optional<Failure> ReasonNoParameters(const Task& task, const ActionRule& rule) {
  const std::vector<std::string> keys = KeysOf(rule);
  for (const auto& [key, value] : task.parameters) {
    if (!Contains(keys, key)) {
      return Bad(FailureCode::kParameter,
                 fmt::format("'{}' has no parameter '{}'{}", task.action, key, NearestOrAll(key, keys)));
    }
    if (auto failure = ReasonNoValue(task, *FindParameter(key), value)) return failure;
  }
  for (const std::string& key : rule.required) {
    if (!task.Has(key))
      return Bad(FailureCode::kParameter, fmt::format("'{}' lacks its parameter '{}'", task.action, key));
  }
  std::vector<std::string> extents;
  for (const std::string& key : ExtentKeys()) {
    if (task.action == "walk" && task.Has(key)) extents.push_back(key);
  }
  if (extents.size() > 1)
    return Bad(FailureCode::kParameter,
               fmt::format("{} each set the distance to walk; give only one of them", QuotedList(extents)));
  if (task.action == "jump") {
    if (auto failure = ReasonNoJump(task)) return failure;
  }
  if (task.Has("pace") && task.Has("speed_m_s"))
    return Bad(FailureCode::kParameter, "'pace' and 'speed_m_s' each set the speed; give only one of them");
  if (task.Has("step_length_m") && task.action == "walk" && !task.Has("steps"))
    return Bad(FailureCode::kParameter, "'step_length_m' is for use with 'steps'");
  return std::nullopt;
}

std::optional<Failure> ReasonNoPlace(const PlaceName& place, const TaskScope& scope) {
  std::vector<std::string> names;
  for (const PlaceName& known : scope.places) {
    names.push_back(known.name);
    if (known.name != place.name) continue;
    const bool one = known.number == 0;
    if ((one && place.number <= 1) ||
        (!one && (place.number == -1 || (place.number >= 1 && place.number <= known.number))))
      return std::nullopt;
    return Bad(FailureCode::kPlace,
               one ? fmt::format("there is only one place '{}'", place.name)
                   : fmt::format("place '{}' needs a number from 1 to {}", place.name, known.number));
  }
  return Bad(FailureCode::kPlace,
             names.empty() ? fmt::format("there is no place '{}': the ground has no named places", place.name)
                           : fmt::format("there is no place '{}'{}", place.name, NearestOrAll(place.name, names)));
}

std::string MissingFor(Needs needs) {
  if (needs == Needs::kArm) return "has no arms";
  if (needs == Needs::kTwoSoles) return "does not have two feet with soles";
  if (needs == Needs::kManyFeet) return "does not have four or more feet";
  if (needs == Needs::kLeap) return "has no gait in which all feet leap at once";
  if (needs == Needs::kFlip) return "has no gait in which its body turns over";
  if (needs == Needs::kTurningFeet) return "has no joints that yaw its soles";
  return "does not have four feet";
}

}  // namespace

const std::vector<std::string>& ExtentKeys() {
  static const std::vector<std::string> keys = {"distance_m", "steps", "duration_s", "to"};
  return keys;
}

const std::vector<ParameterRule>& ParameterRules() {
  static const std::vector<ParameterRule> rules = {
      {"direction", Kind::kWord, 0, 0, {"forward", "backward", "left", "right"}, "Direction, seen from the robot."},
      {"distance_m", Kind::kNumber, 0.01, 50.0, {}, "Distance to walk or jump [m]."},
      {"steps", Kind::kCount, 1, 200, {}, "Number of footfalls."},
      {"step_length_m", Kind::kNumber, 0.01, 1.0, {}, "Forward advance in each footfall [m]."},
      {"duration_s", Kind::kNumber, 0.1, 600.0, {}, "Duration [s]."},
      {"to", Kind::kPlace, 0, 0, {}, "Destination, by name."},
      {"speed_m_s", Kind::kNumber, 0.001, 3.0, {}, "Speed [m/s]."},
      {"pace", Kind::kWord, 0, 0, {"slow", "fast"}, "Speed relative to the robot's default speed."},
      {"gait", Kind::kWord, 0, 0, {"walk", "trot", "pace", "bound"}, "Gait."},
      {"height", Kind::kWord, 0, 0, {"low"}, "Posture of the body."},
      {"angle_deg", Kind::kNumber, 1.0, 720.0, {}, "Angle of the turn or bow, or of the turn during a jump [degree]."},
      {"turn", Kind::kWord, 0, 0, {"left", "right"}, "Side to which the body turns during a jump."},
      {"level",
       Kind::kWord,
       0,
       0,
       {"down"},
       "Level of the landing: the next lower ground in the direction of the jump."},
      {"depth_m", Kind::kNumber, 0.005, 0.5, {}, "Lowering distance [m]."},
      {"times", Kind::kCount, 1, 20, {}, "Number of repetitions."},
      {"side",
       Kind::kWord,
       0,
       0,
       {"left", "right", "both"},
       "Arm to use; for balancing, the foot that stays on the ground."}};
  return rules;
}

const std::vector<ActionRule>& ActionRules() {
  static const std::vector<ActionRule> rules = {
      {"walk",
       {"direction"},
       {"distance_m", "steps", "duration_s", "to", "speed_m_s", "pace", "gait", "height", "step_length_m"},
       Needs::kNothing,
       false,
       "Walks; left and right mean sideways.",
       "stand"},
      {"turn", {"direction"}, {"angle_deg"}, Needs::kTurningFeet, false, "Turns on the spot.", "walk"},
      {"jump",
       {},
       {"direction", "distance_m", "to", "level", "turn", "angle_deg", "times"},
       Needs::kLeap,
       false,
       "Jumps from all feet onto all feet; in place without a direction, a distance, a place or a level.",
       "squat",
       180.0},
      {"flip",
       {"direction"},
       {"times"},
       Needs::kFlip,
       false,
       "Turns its body over in the air: backward is a backflip, left and right are barrel rolls.",
       "squat"},
      {"stand", {}, {"duration_s"}, Needs::kNothing, false, "Stands, or keeps the present posture.", ""},
      {"stand_up", {}, {}, Needs::kNothing, false, "Gets up from sitting, lying or crouching.", ""},
      {"lie_down", {}, {}, Needs::kManyFeet, false, "Lies down on its belly.", "squat"},
      {"sit", {}, {"duration_s"}, Needs::kFourFeet, false, "Sits as a dog does.", "squat"},
      {"squat", {}, {"depth_m", "times", "duration_s"}, Needs::kNothing, false, "Bends its legs and rises again.", ""},
      {"bow", {}, {"angle_deg", "times"}, Needs::kNothing, false, "Tilts its body forward and rises again.", "", 60.0},
      {"nod", {}, {"times"}, Needs::kNothing, true, "Nods with its head, or with its body if it has no head.", ""},
      {"raise_arm", {"side"}, {}, Needs::kArm, true, "Raises an arm and keeps it up.", "nod"},
      {"lower_arm", {"side"}, {}, Needs::kArm, true, "Lowers an arm.", "nod"},
      {"wave", {"side"}, {"times", "duration_s"}, Needs::kArm, true, "Waves.", "nod"},
      {"balance", {"side"}, {"duration_s"}, Needs::kTwoSoles, false, "Stands on one foot for a while.", "stand"},
      {"brace", {}, {}, Needs::kNothing, false, "Crouches quickly, as before a fall.", ""}};
  return rules;
}

const ParameterRule* FindParameter(const std::string& key) {
  for (const ParameterRule& rule : ParameterRules()) {
    if (rule.key == key) return &rule;
  }
  return nullptr;
}

const ActionRule* FindAction(const std::string& action) {
  for (const ActionRule& rule : ActionRules()) {
    if (rule.action == action) return &rule;
  }
  return nullptr;
}

ParameterRange RangeOf(const ActionRule& action, const ParameterRule& parameter) {
  const bool own = parameter.key == "angle_deg" && action.most_deg > 0.0;
  return {parameter.lowest, own ? action.most_deg : parameter.highest};
}

bool TaskScope::Can(const ActionRule& rule) const {
  switch (rule.needs) {
    case Needs::kArm:
      return left_arm || right_arm;
    case Needs::kTwoSoles:
      return two_soles;
    case Needs::kFourFeet:
      return four_feet;
    case Needs::kManyFeet:
      return many_feet;
    case Needs::kTurningFeet:
      return turning_feet;
    case Needs::kLeap:
      return leaps;
    case Needs::kFlip:
      return !flips.empty();
    case Needs::kNothing:
      break;
  }
  return true;
}

std::vector<std::string> TaskScope::Actions() const {
  std::vector<std::string> actions;
  for (const ActionRule& rule : ActionRules()) {
    if (Can(rule)) actions.push_back(rule.action);
  }
  return actions;
}

TaskScope ScopeOf(const RobotModel& model) {
  const UpperBody upper = FindUpperBody(model);
  TaskScope scope;
  scope.robot = model.name;
  scope.left_arm = upper.left_arm.has_value();
  scope.right_arm = upper.right_arm.has_value();
  scope.head = upper.head.has_value();
  scope.two_soles = model.feet.size() == 2 && model.feet[0].has_sole() && model.feet[1].has_sole();
  scope.four_feet = model.legs.size() == 4;
  scope.many_feet = model.legs.size() >= 4;
  scope.turning_feet = !ReasonCannotTurn(model);
  const int feet = static_cast<int>(model.feet.size());
  scope.leaps = !LeapGait(feet).empty();
  for (const char* direction : {"forward", "backward", "left", "right"}) {
    if (!GaitTurningOver(feet, direction).empty()) scope.flips.emplace_back(direction);
  }
  return scope;
}

std::optional<Failure> ReasonNoTask(const Task& task) {
  const ActionRule* rule = FindAction(task.action);
  if (rule == nullptr) {
    return Bad(FailureCode::kAction, fmt::format("there is no action '{}'{}", task.action,
                                                 NearestOrAll(task.action, NamesOf(ActionRules()))));
  }
  if (auto failure = ReasonNoParameters(task, *rule)) return failure;
  if (rule->is_gesture && !task.during.empty())
    return Bad(FailureCode::kParameter, fmt::format("no task can run at the same time as '{}'", task.action));
  for (const Task& gesture : task.during) {
    if (auto failure = ReasonNoTask(gesture)) return failure;
    if (!FindAction(gesture.action)->is_gesture) {
      return Bad(
          FailureCode::kParameter,
          fmt::format("'{}' cannot run at the same time as '{}'; accepted gestures: raise_arm, lower_arm, wave, nod",
                      gesture.action, task.action));
    }
  }
  return std::nullopt;
}

std::optional<Failure> ReasonNotDone(const Task& task, const TaskScope& scope) {
  const ActionRule& rule = *FindAction(task.action);
  const auto cannot = [&](const std::string& why) {
    std::vector<Suggestion> suggestions = {fmt::format("it can {}", fmt::join(scope.Actions(), ", "))};
    if (!rule.instead.empty())
      suggestions.insert(suggestions.begin(), fmt::format("the closest action that it can do is {}", rule.instead));
    return Bad(FailureCode::kCannot, fmt::format("robot '{}' cannot '{}': it {}", scope.robot, task.action, why),
               suggestions);
  };
  if (!scope.Can(rule)) return cannot(MissingFor(rule.needs));
  if (rule.needs == Needs::kArm) {
    const std::string side = task.Word("side");
    if (side != "right" && !scope.left_arm) return cannot("has no left arm");
    if (side != "left" && !scope.right_arm) return cannot("has no right arm");
  }
  if (const std::string direction = task.Word("direction");
      task.action == "flip" && !direction.empty() && !Contains(scope.flips, direction)) {
    return cannot(fmt::format("has no gait in which its body turns over {}; it has gaits for {}", direction,
                              QuotedList(scope.flips)));
  }
  if (const auto to = task.parameters.find("to"); to != task.parameters.end()) {
    if (auto failure = ReasonNoPlace(std::get<PlaceName>(to->second), scope)) return failure;
  }
  for (const Task& gesture : task.during) {
    if (auto failure = ReasonNotDone(gesture, scope)) return failure;
    if (gesture.action == "nod" && !scope.head)
      return cannot("nods with its body, because it has no head; this is not possible during another task");
  }
  return std::nullopt;
}

std::optional<Failure> ReasonNotPlanned(const TaskPlan& plan, const TaskScope& scope) {
  if (plan.tasks.empty()) return Bad(FailureCode::kEmpty, "the plan contains no task");
  if (plan.tasks.size() > kMostTasks)
    return Bad(FailureCode::kRange,
               fmt::format("there are {} tasks; at most {} are accepted", plan.tasks.size(), kMostTasks));
  for (std::size_t k = 0; k < plan.tasks.size(); ++k) {
    const Task& task = plan.tasks[k];
    std::optional<Failure> failure = ReasonNoTask(task);
    if (!failure) failure = ReasonNotDone(task, scope);
    if (!failure) continue;
    const std::string words = task.words.empty() ? "" : fmt::format(", '{}'", task.words);
    failure->message = fmt::format("task {}{}: {}", k + 1, words, failure->message);
    return failure;
  }
  return std::nullopt;
}

}  // namespace gaitwright
