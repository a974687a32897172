// SPDX-License-Identifier: BSD-3-Clause
#include "planning/tasks/task_plan_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "planning/plan/json_part_internal.h"
#include "planning/tasks/task_rules.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;
using Kind = ParameterRule::Kind;

Json ValueJson(const TaskValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return *number;
  if (const auto* count = std::get_if<int>(&value)) return *count;
  if (const auto* word = std::get_if<std::string>(&value)) return *word;
  const auto& place = std::get<PlaceName>(value);
  Json json = {{"name", place.name}};
  if (place.number != 0) json["number"] = place.number;
  return json;
}

Json TaskJson(const Task& task) {
  Json json = {{"action", task.action}};
  for (const ParameterRule& rule : ParameterRules()) {
    if (task.Has(rule.key)) json[rule.key] = ValueJson(task.parameters.at(rule.key));
  }
  if (!task.words.empty()) json["words"] = task.words;
  if (task.during.empty()) return json;
  json["while"] = Json::array();
  for (const Task& gesture : task.during) json["while"].push_back(TaskJson(gesture));
  return json;
}

TaskValue ReadValue(const JsonPart& part, const ParameterRule& rule) {
  constexpr int kLargestCount = 1000000;
  switch (rule.kind) {
    case Kind::kNumber:
      return part.Number();
    case Kind::kCount:
      return part.Whole(-kLargestCount, kLargestCount);
    case Kind::kWord:
      return part.Text();
    case Kind::kPlace:
      break;
  }
  part.Object({"name"}, {"number"});
  PlaceName place{part.At("name").Text()};
  if (part.Has("number")) place.number = part.At("number").Whole(-1, kLargestCount);
  return place;
}

Task ReadTask(const JsonPart& part) {
  std::vector<std::string> optional = {"words", "while"};
  for (const ParameterRule& rule : ParameterRules()) optional.push_back(rule.key);
  part.Object({"action"}, optional);
  Task task;
  task.action = part.At("action").Text();
  for (const ParameterRule& rule : ParameterRules()) {
    if (part.Has(rule.key)) task.parameters[rule.key] = ReadValue(part.At(rule.key), rule);
  }
  if (part.Has("words")) task.words = part.At("words").Text();
  if (part.Has("while")) {
    for (const JsonPart& gesture : part.At("while").List()) task.during.push_back(ReadTask(gesture));
  }
  if (const auto failure = ReasonNoTask(task)) part.Refuse(fmt::format("is not a task: {}", failure->message));
  return task;
}

Json ParameterSchema(const ActionRule& action, const ParameterRule& rule) {
  const ParameterRange range = RangeOf(action, rule);
  switch (rule.kind) {
    case Kind::kNumber:
      return {{"type", "number"}, {"minimum", range.lowest}, {"maximum", range.highest}, {"description", rule.meaning}};
    case Kind::kCount:
      return {{"type", "integer"},
              {"minimum", static_cast<int>(range.lowest)},
              {"maximum", static_cast<int>(range.highest)},
              {"description", rule.meaning}};
    case Kind::kWord:
      return {{"enum", rule.words}, {"description", rule.meaning}};
    case Kind::kPlace:
      break;
  }
  return {{"type", "object"},
          {"properties",
           {{"name", {{"type", "string"}, {"minLength", 1}}},
            {"number",
             {{"type", "integer"},
              {"minimum", -1},
              {"description", "Number of the place, if there are several; -1 is the last."}}}}},
          {"required", {"name"}},
          {"additionalProperties", false},
          {"description", rule.meaning}};
}

Json ActionSchema(const ActionRule& rule) {
  Json properties = {{"action", {{"const", rule.action}}}};
  Json required = {"action"};
  for (const auto* keys : {&rule.required, &rule.optional}) {
    for (const std::string& key : *keys) properties[key] = ParameterSchema(rule, *FindParameter(key));
  }
  for (const std::string& key : rule.required) required.push_back(key);
  properties["words"] = {{"type", "string"}, {"description", "Words of the instruction from which the task was read."}};
  if (!rule.is_gesture) properties["while"] = {{"type", "array"}, {"items", {{"$ref", "#/$defs/gesture"}}}};
  return {{"type", "object"},
          {"description", rule.meaning},
          {"properties", properties},
          {"required", required},
          {"additionalProperties", false}};
}

}  // namespace

std::string TaskPlanJson(const TaskPlan& plan) {
  Json json = {{"schema", TaskPlan::kSchema}};
  if (!plan.text.empty()) json["text"] = plan.text;
  if (!plan.language.empty()) json["language"] = plan.language;
  json["tasks"] = Json::array();
  for (const Task& task : plan.tasks) json["tasks"].push_back(TaskJson(task));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<TaskPlan> TaskPlanFromJson(const std::string& text) {
  const auto bad = [](const std::string& message) {
    return Failure{FailureKind::kBadInput, FailureCode::kTaskPlan, "TaskPlanFromJson", message, {}};
  };
  Json json;
  try {
    json = ParseJsonOnce(text);
  } catch (const Json::exception&) {
    return bad(ReasonNoJson(text));
  } catch (const InvalidArgument& error) {
    return bad(error.what());
  }
  try {
    const JsonPart whole(json);
    whole.Object({"schema", "tasks"}, {"text", "language"});
    if (whole.At("schema").Whole(0, 1000000) != TaskPlan::kSchema)
      whole.At("schema").Refuse(fmt::format("is not known; this program reads {}", TaskPlan::kSchema));
    TaskPlan plan;
    if (whole.Has("text")) plan.text = whole.At("text").Text();
    if (whole.Has("language")) plan.language = whole.At("language").Text();
    for (const JsonPart& task : whole.At("tasks").List()) plan.tasks.push_back(ReadTask(task));
    return plan;
  } catch (const InvalidArgument& error) {
    return bad(error.what());
  }
}

std::string TaskPlanSchema(const std::vector<std::string>& actions) {
  Json tasks = Json::array(), gestures = Json::array();
  for (const ActionRule& rule : ActionRules()) {
    if (!actions.empty() && std::find(actions.begin(), actions.end(), rule.action) == actions.end()) continue;
    tasks.push_back(ActionSchema(rule));
    if (rule.is_gesture) gestures.push_back(ActionSchema(rule));
  }
  const Json schema = {
      {"$schema", "https://json-schema.org/draft/2020-12/schema"},
      {"title", "Sequence of tasks for a robot"},
      {"type", "object"},
      {"properties",
       {{"schema", {{"const", TaskPlan::kSchema}}},
        {"text", {{"type", "string"}}},
        {"language", {{"type", "string"}}},
        {"tasks", {{"type", "array"}, {"minItems", 1}, {"maxItems", kMostTasks}, {"items", {{"oneOf", tasks}}}}}}},
      {"required", {"schema", "tasks"}},
      {"additionalProperties", false},
      {"$defs", {{"gesture", {{"oneOf", gestures}}}}}};
  return schema.dump(2) + "\n";
}

}  // namespace gaitwright
