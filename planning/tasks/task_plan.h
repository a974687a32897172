// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <variant>
#include <vector>

namespace gaitwright {

/// A named place: a marker, or one of several patches with the same name.
struct PlaceName {
  std::string name;
  int number = 0;  ///< number among several, from 1; -1 is the last; 0 if there is only one

  bool operator==(const PlaceName&) const = default;
};

/// Value of a task's parameter: a number in the unit that its key ends in, a count, a word from a list, or a place.
using TaskValue = std::variant<double, int, std::string, PlaceName>;

/// One task; its action is one of kActions in task_rules.h.
struct Task {
  std::string action;
  std::map<std::string, TaskValue> parameters;
  std::string words;         ///< words of the instruction that it comes from; may be empty
  std::vector<Task> during;  ///< gestures during the task; "while" in files

  /// The number of a parameter, or `otherwise` if it is missing.
  double Number(const std::string& key, double otherwise) const;
  int Count(const std::string& key, int otherwise) const;
  std::string Word(const std::string& key, const std::string& otherwise = "") const;
  bool Has(const std::string& key) const { return parameters.contains(key); }

  bool operator==(const Task&) const = default;
};

/// A sequence of tasks, as read from an instruction.
struct TaskPlan {
  static constexpr int kSchema = 1;

  std::string text;      ///< the instruction; empty if there was none
  std::string language;  ///< "en" or "zh"; empty if there was no instruction
  std::vector<Task> tasks;

  bool operator==(const TaskPlan&) const = default;
};

/// Description of a task for people: "walk forward, 2 m, while waving (right)".
std::string TaskText(const Task& task);

}  // namespace gaitwright
