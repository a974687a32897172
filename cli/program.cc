// SPDX-License-Identifier: BSD-3-Clause
#include "cli/program.h"

#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

namespace gaitwright::cli {

void AddCommon(CLI::App& verb, Common& common) {
  verb.add_flag("--json", common.json, "Print one JSON object on standard output and nothing else there");
  verb.add_flag("--quiet", common.quiet, "Print only the verdict");
  verb.add_option("--seed", common.seed, "Seed of whatever is random")->capture_default_str();
  verb.add_option("--set", common.sets, "Set any option, as key=value; may be repeated")->take_all();
}

int Report(const Failure& failure, const Common& common) {
  std::string text = failure.message;
  for (const std::string& hint : failure.hints) text += fmt::format("\n  try: {}", hint);
  fmt::print(stderr, "gaitwright: {}\n", text);
  if (common.json) {
    const nlohmann::ordered_json error = {
        {"error",
         {{"code", failure.code}, {"stage", failure.stage}, {"message", failure.message}, {"hints", failure.hints}}}};
    fmt::print("{}\n", error.dump(2));
  }
  return failure.kind == FailureKind::kInfeasible ? kNoPlan : kWrongInput;
}

int Guarded(const Common& common, const std::function<int()>& verb) {
  try {
    return verb();
  } catch (const InvalidArgument& error) {
    return Report({FailureKind::kBadInput, "invalid_argument", "program", error.what(), {}}, common);
  }
}

}  // namespace gaitwright::cli
