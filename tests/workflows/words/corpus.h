// SPDX-License-Identifier: BSD-3-Clause
// Instructions with what they mean, as tests/workflows/words/*.yaml has them.
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

/// What the robot of an entry can do, with the places that the corpus knows.
/// @param ground  a built-in one, whose places there are instead.
TaskScope CorpusScope(const std::string& robot, const std::string& ground = "");

/// Tasks without the words that they come from.
std::vector<Task> WithoutWords(std::vector<Task> tasks);

/// Tasks as a text to compare and to read.
std::string TasksText(const std::vector<Task>& tasks);

}  // namespace gaitwright
