// SPDX-License-Identifier: BSD-3-Clause
#include "planning/tasks/task_plan.h"

#include <fmt/format.h>

namespace gaitwright {
namespace {

template <class T>
T ValueOf(const Task& task, const std::string& key, const T& otherwise) {
  const auto found = task.parameters.find(key);
  if (found == task.parameters.end()) return otherwise;
  const T* value = std::get_if<T>(&found->second);
  return value == nullptr ? otherwise : *value;
}

std::string Unit(const std::string& key) {
  if (key.ends_with("_m_s")) return " m/s";
  if (key.ends_with("_m")) return " m";
  if (key.ends_with("_s")) return " s";
  if (key.ends_with("_deg")) return " degrees";
  if (key == "steps") return " steps";
  return key == "times" ? " times" : "";
}

std::string ValueText(const std::string& key, const TaskValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return fmt::format("{:.6g}{}", *number, Unit(key));
  if (const auto* count = std::get_if<int>(&value)) {
    std::string unit = Unit(key);
    if (*count == 1) unit.pop_back();
    return fmt::format("{}{}", *count, unit);
  }
  if (const auto* place = std::get_if<PlaceName>(&value)) {
    if (place->number == 0) return "to " + place->name;
    return place->number < 0 ? "to the last " + place->name : fmt::format("to {} {}", place->name, place->number);
  }
  return (key == "turn" ? "turning " : "") + std::get<std::string>(value);
}

}  // namespace

double Task::Number(const std::string& key, double otherwise) const { return ValueOf(*this, key, otherwise); }
int Task::Count(const std::string& key, int otherwise) const { return ValueOf(*this, key, otherwise); }
std::string Task::Word(const std::string& key, const std::string& otherwise) const {
  return ValueOf(*this, key, otherwise);
}

std::string TaskText(const Task& task) {
  std::string text = task.action;
  for (char& c : text) {
    if (c == '_') c = ' ';
  }
  const char* before = " ";
  for (const char* first : {"direction", "side"}) {
    if (!task.Has(first)) continue;
    text += before + task.Word(first);
    before = ", ";
  }
  for (const auto& [key, value] : task.parameters) {
    if (key == "direction" || key == "side") continue;
    text += ", " + ValueText(key, value);
  }
  for (std::size_t k = 0; k < task.during.size(); ++k) {
    text += k == 0 ? "; meanwhile " : " and ";
    text += TaskText(task.during[k]);
  }
  return text;
}

}  // namespace gaitwright
