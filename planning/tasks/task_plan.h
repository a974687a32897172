// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <variant>
#include <vector>

namespace gaitwright {

/// A place by the name that people call it: a marker, or one of several patches of a name.
struct PlaceName {
  std::string name;
  int number = 0;  ///< which of several, from 1; -1 the last; 0 where there is one

  bool operator==(const PlaceName&) const = default;
};

/// A value of a task's parameter: a number in the unit that its key ends in, a count, one of a few words, a place.
using TaskValue = std::variant<double, int, std::string, PlaceName>;

/// Something to do, as kActions of task_rules.h has it.
struct Task {
  std::string action;
  std::map<std::string, TaskValue> parameters;
  std::string words;         ///< of the instruction that it comes from; empty for none
  std::vector<Task> during;  ///< gestures that are made meanwhile; "while" in files

  /// What is said of a parameter, or `otherwise`.
  double Number(const std::string& key, double otherwise) const;
  int Count(const std::string& key, int otherwise) const;
  std::string Word(const std::string& key, const std::string& otherwise = "") const;
  bool Has(const std::string& key) const { return parameters.contains(key); }

  bool operator==(const Task&) const = default;
};

/// What an instruction asks for: one task after the other.
struct TaskPlan {
  static constexpr int kSchema = 1;

  std::string text;      ///< the instruction; empty where there was none
  std::string language;  ///< "en", "zh"; empty where there was none
  std::vector<Task> tasks;

  bool operator==(const TaskPlan&) const = default;
};

/// A task as people read it: "walk forward, 2 m, while waving (right)".
std::string TaskText(const Task& task);

}  // namespace gaitwright
