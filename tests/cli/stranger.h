// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace gaitwright::cli {

using Json = nlohmann::ordered_json;

/// The built program.
std::string ProgramPath();

/// What a run of the program left.
struct Ran {
  int status = -1;  ///< exit status; 128 and more when a signal ended it
  std::string out, err;

  /// Standard output as one JSON object. @throws Json::parse_error when it is anything else.
  Json json() const { return Json::parse(out); }
};

/// Runs the built program as a stranger would, in an empty folder of its own.
class Stranger : public testing::Test {
 protected:
  Stranger();
  ~Stranger() override;

  Ran Run(const std::vector<std::string>& arguments) const;
  /// The same, sent `signal` as soon as `now` says so. Its status is 128 and the signal's number where that ended it.
  Ran RunUntil(const std::vector<std::string>& arguments, int signal, const std::function<bool()>& now) const;
  /// Any program, by its words; sent the signal where there is one.
  Ran RunWords(std::vector<std::string> words, int signal = 0, const std::function<bool()>& now = {}) const;

  std::filesystem::path In(const std::string& name) const { return folder_ / name; }
  /// Names of what lies in the folder, sorted.
  std::vector<std::string> Found() const;
  std::string Read(const std::string& name) const;
  void Write(const std::string& name, const std::string& text) const;

  /// A plan of a short walk in `name`, as the program writes it.
  Json MakePlan(const std::string& name) const;

 private:
  std::filesystem::path folder_, talk_;  ///< where it runs; where its output is caught
};

/// Status 1 or 2 with one line on standard error that says each of `parts`, and nothing on standard output.
void ExpectRefused(const Ran& ran, int status, const std::vector<std::string>& parts);

}  // namespace gaitwright::cli
