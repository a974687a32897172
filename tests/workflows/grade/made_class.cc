// SPDX-License-Identifier: BSD-3-Clause
#include "tests/workflows/grade/made_class.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace gaitwright {

namespace fs = std::filesystem;

MadeClass::MadeClass() {
  std::string name = (fs::temp_directory_path() / "class-XXXXXX").string();
  folder_ = mkdtemp(name.data());
  fs::permissions(folder_, fs::perms(0711));  // so that user nobody can enter the folders below
}

MadeClass::~MadeClass() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

void MadeClass::HandIn(const std::string& student, const std::string& file, const std::string& text) const {
  fs::create_directories(folder_ / student);
  std::ofstream(folder_ / student / file, std::ios::binary) << text;
}

RubricPart PartOf(const std::string& part_yaml) {
  const Result<Rubric> rubric = ReadRubric("title: t\nparts:\n- " + part_yaml, "rubric");
  if (!rubric) throw std::logic_error(rubric.failure().message);
  return rubric->parts.front();
}

PartMark MadeClass::Mark(const std::string& part_yaml, const std::string& student, std::uint64_t seed) const {
  MarkingSetup setup;
  setup.seed = seed;
  const RubricPart part = PartOf(part_yaml);
  if (RunsCode(part.kind)) setup.python = LookOver("").value();
  return MarkPart(part, StudentOf(student), setup);
}

PartMark MadeClass::MarkCode(const std::string& part_yaml, const std::string& code, std::uint64_t seed) const {
  HandIn("ada", "work.py", code);
  return Mark(part_yaml, "ada", seed);
}

bool CanRunCode(bool package) {
  if (!ReasonNotConfined().empty()) return false;
  const Result<PythonProgram> python = LookOver("");
  const bool serves = python.ok() && python->has_numpy && !(package && python->package.empty());
#ifdef GAITWRIGHT_TESTS_HAVE_PYTHON
  EXPECT_TRUE(serves) << "this build has Python, but none of use is found";
#endif
  return serves && UnreadableForNobody(*python).empty();
}

std::set<std::string> ChildProcesses() {
  std::set<std::string> children;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    std::ifstream stream(entry.path() / "stat");
    std::stringstream text;
    text << stream.rdbuf();
    const std::string stat = text.str();  // number (name) state parent ...; a name may have spaces and parentheses
    const std::size_t end = stat.rfind(')');
    if (end == std::string::npos) continue;
    std::istringstream rest(stat.substr(end + 1));
    std::string state;
    pid_t parent = 0;
    if (rest >> state >> parent && parent == getpid()) children.insert(stat.substr(0, end + 1));
  }
  return children;
}

int ProcessesWith(const std::string& word) {
  int found = 0;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    std::ifstream stream(entry.path() / "environ");
    std::stringstream text;
    text << stream.rdbuf();
    if (text.str().find(word) != std::string::npos) ++found;
  }
  return found;
}

void ExpectNothing(const PartMark& mark, const std::vector<std::string>& words) {
  EXPECT_EQ(mark.points, 0.0);
  std::string reasons;
  for (const std::string& reason : mark.reasons) reasons += reason + "\n";
  for (const std::string& word : words)
    EXPECT_NE(reasons.find(word), std::string::npos) << word << " is not in: " << reasons;
}

}  // namespace gaitwright
