// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/flags.h"
#include "cli/json_text_internal.h"
#include "cli/paths.h"
#include "cli/program.h"
#include "cli/reference_pages.h"
#include "kinematics/base/file.h"
#include "kinematics/base/nearest_name.h"
#include "workflows/formats/documents.h"

namespace gaitwright::cli {
namespace {

struct ReferenceSettings {
  Common common;
  std::string schema, folder;
};

int PrintSchema(const std::string& name) {
  const std::vector<Document> documents = Documents();
  std::vector<std::string> names;
  for (const Document& document : documents) names.push_back(document.name);
  const auto at = std::find(names.begin(), names.end(), name);
  if (at == names.end())
    throw InvalidArgument(fmt::format("--schema: '{}' does not exist{}", name,
                                      NearestOrAll(name, names, "'gaitwright reference' lists all schemas")));
  fmt::print("{}", documents[static_cast<std::size_t>(at - names.begin())].schema);
  return kPass;
}

void PrintSchemaList(const Common& common) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Document& document : Documents()) {
    list.push_back({{"name", document.name}, {"title", document.title}});
    if (common.json) continue;
    if (common.quiet) {
      fmt::print("{}\n", document.name);
    } else {
      fmt::print("{:<18} {}\n", document.name, document.title);
    }
  }
  if (common.json) PrintJson(nlohmann::ordered_json{{"schemas", list}});
}

int WriteReference(Verb program, const ReferenceSettings& a) {
  const std::filesystem::path folder(a.folder);
  std::vector<OutputFile> files = {{(folder / "reference/verbs.md").string(), VerbsPage(program)},
                                   {(folder / "reference/options.md").string(), OptionsPage(program)}};
  for (const Document& document : Documents())
    files.push_back({(folder / "schemas" / (document.name + ".json")).string(), document.schema});
  const auto written = WriteFilesTogether(files);
  if (!written) return Report(written.failure(), a.common);
  if (a.common.json) {
    PrintJson(nlohmann::ordered_json{{"files", *written}});
  } else if (!a.common.quiet) {
    for (const std::string& path : *written) fmt::print("{}\n", path);
  }
  return kPass;
}

int RunReference(Verb program, const ReferenceSettings& a) {
  if (!a.schema.empty()) return PrintSchema(a.schema);
  if (!a.folder.empty()) return WriteReference(program, a);
  PrintSchemaList(a.common);
  return kPass;
}

}  // namespace

void AddReference(Verb program, int& status) {
  auto a = std::make_shared<ReferenceSettings>();
  const Verb verb = program.AddVerb("reference", "List, print or write the JSON schemas of all files and results");
  const Flag schema = AddText(verb, "--schema", "NAME", a->schema, "Print this schema; default: list all schemas.");
  AddText(verb, "--out-dir", "FOLDER", a->folder,
          "Write all schemas and the pages of verbs and options into this folder; default: none.")
      .Exclude(schema);
  AddCommon(verb, a->common, {"reference", "reference --schema motion-plan"});
  SetWork(verb, a->common, status, [a, program] { return RunReference(program, *a); });
}

}  // namespace gaitwright::cli
