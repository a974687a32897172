// SPDX-License-Identifier: BSD-3-Clause
#include "tests/workflows/words/corpus.h"

#include <yaml-cpp/yaml.h>

#include "planning/plan/built_in_terrain.h"
#include "planning/tasks/task_plan_json.h"
#include "tests/built_paths.h"
#include "workflows/words/places.h"

namespace gaitwright {
namespace {

std::string PathOf(const std::string& file) { return SourceFolder() + "/tests/workflows/words/" + file; }

Task TaskOf(const YAML::Node& node) {
  Task task;
  for (const auto& entry : node) {
    const auto key = entry.first.as<std::string>();
    if (key == "action") {
      task.action = entry.second.as<std::string>();
    } else if (key == "while") {
      for (const YAML::Node& gesture : entry.second) task.during.push_back(TaskOf(gesture));
    } else if (key == "to") {
      PlaceName place{entry.second["name"].as<std::string>(), 0};
      if (entry.second["number"]) place.number = entry.second["number"].as<int>();
      task.parameters[key] = place;
    } else if (FindParameter(key)->kind == ParameterRule::Kind::kNumber) {
      task.parameters[key] = entry.second.as<double>();
    } else if (FindParameter(key)->kind == ParameterRule::Kind::kCount) {
      task.parameters[key] = entry.second.as<int>();
    } else {
      task.parameters[key] = entry.second.as<std::string>();
    }
  }
  return task;
}

std::string TextOf(const YAML::Node& node) { return node ? node.as<std::string>() : ""; }

}  // namespace

std::vector<CorpusEntry> LoadCorpus(const std::string& file) {
  std::vector<CorpusEntry> entries;
  for (const YAML::Node& node : YAML::LoadFile(PathOf(file))) {
    CorpusEntry entry{
        TextOf(node["text"]), TextOf(node["language"]), TextOf(node["robot"]), TextOf(node["ground"]), {}};
    for (const YAML::Node& task : node["tasks"]) entry.tasks.push_back(TaskOf(task));
    entries.push_back(entry);
  }
  return entries;
}

std::vector<RefusalEntry> LoadRefusals(const std::string& file) {
  std::vector<RefusalEntry> entries;
  for (const YAML::Node& node : YAML::LoadFile(PathOf(file))) {
    entries.push_back({TextOf(node["text"]), TextOf(node["robot"]), TextOf(node["reason"]), TextOf(node["part"]),
                       TextOf(node["nearest"]), TextOf(node["ground"])});
  }
  return entries;
}

TaskScope CorpusScope(const std::string& robot, const std::string& ground) {
  TaskScope scope;
  scope.robot = robot;
  scope.left_arm = scope.right_arm = scope.head = scope.two_soles = robot == "nao";
  scope.four_feet = scope.many_feet = robot == "a1";
  scope.turning_feet = scope.leaps = true;
  if (robot == "a1") scope.flips = {"backward", "left", "right"};
  scope.places = {{"red marker", 0}, {"blue marker", 0}, {"door", 0},     {"charging station", 0},
                  {"step", 3},       {"stone", 6},       {"红色标记", 0}, {"蓝色标记", 0},
                  {"门", 0},         {"充电桩", 0},      {"台阶", 3},     {"石头", 6}};
  if (!ground.empty()) scope.places = PlacesOf(MakeTerrain(ground, TerrainScale{}).value());
  return scope;
}

std::vector<Task> WithoutWords(std::vector<Task> tasks) {
  for (Task& task : tasks) {
    task.words.clear();
    task.during = WithoutWords(std::move(task.during));
  }
  return tasks;
}

std::string TasksText(const std::vector<Task>& tasks) {
  TaskPlan plan;
  plan.tasks = WithoutWords(tasks);
  return TaskPlanJson(plan);
}

}  // namespace gaitwright
