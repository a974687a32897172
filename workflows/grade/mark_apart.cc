// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/grade/mark_apart.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <nlohmann/json.hpp>

#include "workflows/render/temporary_folder_internal.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

constexpr mode_t kFolderMayPass = 0711;  // a submission's code may run as user nobody and must reach its folder

Json JsonOf(const PartMark& mark) {
  Json checks = Json::array(), pages = Json::array();
  for (const CheckMark& check : mark.checks)
    checks.push_back({check.measure, check.value ? Json(*check.value) : Json(), check.points, check.of});
  for (const MotionPage& page : mark.pages) pages.push_back({page.title, page.html});
  return {{"points", mark.points}, {"checks", checks}, {"reasons", mark.reasons}, {"pages", pages}};
}

PartMark MarkFrom(const Json& json, const RubricPart& part) {
  PartMark mark{part.name, part.title, json.at("points"), part.points, {}, json.at("reasons"), {}};
  for (const Json& check : json.at("checks")) {
    const auto value = check.at(1).is_null() ? std::nullopt : std::optional<double>(check.at(1).get<double>());
    mark.checks.push_back({check.at(0), value, check.at(2), check.at(3)});
  }
  for (const Json& page : json.at("pages")) mark.pages.push_back({page.at(0), page.at(1)});
  return mark;
}

void WriteAll(int to, const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const ssize_t n = write(to, text.data() + at, text.size() - at);
    if (n < 0 && errno != EINTR) return;
    if (n > 0) at += static_cast<std::size_t>(n);
  }
}

std::string ReadAll(int from) {
  std::string text;
  std::array<char, 65536> piece{};
  while (true) {
    const ssize_t n = read(from, piece.data(), piece.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return text;
    text.append(piece.data(), static_cast<std::size_t>(n));
  }
}

/// Marks in the forked copy; does not return.
[[noreturn]] void MarkAndEnd(const RubricPart& part, const std::function<PartMark()>& mark, const std::string& folder,
                             int to) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (!folder.empty()) setenv("TMPDIR", folder.c_str(), 1);
  // Only the soft limit, because the process of a submission may have a higher one.
  rlimit time{}, core{};
  getrlimit(RLIMIT_CPU, &time);
  getrlimit(RLIMIT_CORE, &core);
  time.rlim_cur = std::min(time.rlim_max, static_cast<rlim_t>(std::ceil(part.judge_s)));
  core.rlim_cur = 0;
  setrlimit(RLIMIT_CPU, &time);
  setrlimit(RLIMIT_CORE, &core);
  std::string text;
  try {
    text = JsonOf(mark()).dump(-1, ' ', false, Json::error_handler_t::replace);
  } catch (const std::exception&) {
    // Nothing is written; the waiting process reports it.
  }
  WriteAll(to, text);
  std::_Exit(0);
}

std::string ReasonRefused(int status, const RubricPart& part) {
  const bool late = WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL);
  if (late) return fmt::format("marking took more than {:g} s", part.judge_s);
  return WIFSIGNALED(status) ? "the marking process crashed" : "the marking process ran out of memory";
}

}  // namespace

PartMark MarkApart(const RubricPart& part, const std::function<PartMark()>& mark) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) return mark();
  const TemporaryFolder folder;  // for all files of the copy, so that they are removed even if it crashes
  if (folder.there()) chmod(folder.path().c_str(), kFolderMayPass);
  const pid_t copy = fork();
  if (copy == 0) MarkAndEnd(part, mark, folder.path(), ends[1]);
  close(ends[1]);
  const std::string text = copy < 0 ? "" : ReadAll(ends[0]);
  close(ends[0]);
  if (copy < 0) return mark();
  int status = 0;
  while (waitpid(copy, &status, 0) < 0 && errno == EINTR) {
  }
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_object()) return MarkFrom(json, part);
  return NothingFor(part, "the submission could not be marked: " + ReasonRefused(status, part));
}

}  // namespace gaitwright
