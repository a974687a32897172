// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/base/result.h"
#include "planning/tasks/task_rules.h"

namespace gaitwright {

/// A language model behind an endpoint that speaks as OpenAI's chat completions do.
struct LanguageModel {
  std::string url;    ///< the base, such as "http://localhost:8000/v1"; "/chat/completions" is added where it lacks
  std::string model;  ///< its name there
  std::string key;    ///< sent as a bearer token; "" sends none
  double longest_s = 60.0;
};

/// The key for language models from the environment: GAITWRIGHT_API_KEY, else OPENAI_API_KEY, else "".
std::string ApiKeyFromEnvironment();

/// Turns an instruction into tasks.
class Interpreter {
 public:
  virtual ~Interpreter() = default;

  /// What messages call it, such as "grammar".
  virtual std::string name() const = 0;

  /// @param scope  what the robot can do and which places there are.
  /// @param notes  gets why an answer that was received is not taken.
  /// @return a plan that is valid for the robot (WhyNotPlanned), or why there is none. Failure `interpreter_url`: the
  ///         interpreter itself is given wrongly.
  virtual Result<TaskPlan> Interpret(const std::string& instruction, const TaskScope& scope,
                                     std::vector<std::string>& notes) const = 0;
};

/// The built-in grammar of English and Chinese (understand.h).
class Grammar : public Interpreter {
 public:
  std::string name() const override { return "grammar"; }
  Result<TaskPlan> Interpret(const std::string& instruction, const TaskScope& scope,
                             std::vector<std::string>& notes) const override;
};

/// A language model. An answer that is not valid for the robot is refused, and the model is asked once more with the
/// error.
class ModelInterpreter : public Interpreter {
 public:
  explicit ModelInterpreter(LanguageModel model) : model_(std::move(model)) {}

  std::string name() const override { return "language model"; }
  Result<TaskPlan> Interpret(const std::string& instruction, const TaskScope& scope,
                             std::vector<std::string>& notes) const override;

 private:
  LanguageModel model_;
};

/// What an instruction was taken to mean, and by what.
struct Interpretation {
  TaskPlan plan;
  std::string by;                  ///< name of the interpreter, "grammar" or "language model"
  std::vector<std::string> notes;  ///< why answers of the interpreters asked before were not taken
};

/// What a language model is told before an instruction: what this robot can do, where, and the schema of the answer.
std::string InterpreterPrompt(const TaskScope& scope);

/// The task plan in a language model's answer, as JSON alone or fenced. Failures as of TaskPlanFromJson and
/// WhyNotPlanned: nothing that is not valid for this robot is let pass.
Result<TaskPlan> PlanInAnswer(const std::string& answer, const std::string& instruction, const TaskScope& scope);

/// An instruction as a task plan, by the first of the interpreters that understands it. Failure: that of the last, with
/// the notes as suggestions, or `interpreter_url` of any.
/// @throws InvalidArgument without an interpreter.
Result<Interpretation> InterpretBy(const std::vector<const Interpreter*>& interpreters, const std::string& instruction,
                                   const TaskScope& scope);

/// By the language model where one is given, then by the built-in grammar. Failure: the grammar's refusal.
Result<Interpretation> Interpret(const std::string& instruction, const TaskScope& scope,
                                 const std::optional<LanguageModel>& model);

}  // namespace gaitwright
