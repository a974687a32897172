// SPDX-License-Identifier: BSD-3-Clause
// Instructions with their meanings, from tests/workflows/words/*.yaml.
#pragma once

#include <string>
#include <vector>

#include "planning/tasks/task_rules.h"

namespace gaitwright {

/// An instruction that must be understood.
struct CorpusEntry {
  std::string text, language, robot, ground;
  std::vector<Task> tasks;
};

/// An instruction that must be refused.
struct RefusalEntry {
  std::string text, robot, reason, part, nearest, ground;
};

std::vector<CorpusEntry> LoadCorpus(const std::string& file);
std::vector<RefusalEntry> LoadRefusals(const std::string& file);

/// The abilities of the robot of an entry, with the places of the corpus.
/// @param ground  a built-in ground, whose places are used instead.
TaskScope CorpusScope(const std::string& robot, const std::string& ground = "");

/// Tasks without the words that they come from.
std::vector<Task> WithoutWords(std::vector<Task> tasks);

/// Tasks as text, for comparison and messages.
std::string TasksText(const std::vector<Task>& tasks);

}  // namespace gaitwright
