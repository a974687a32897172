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

/// Results of a run of the program.
struct Ran {
  int status = -1;  ///< exit status; 128 plus the signal's number if a signal ended it
  std::string out, err;

  /// Standard output as one JSON object. @throws Json::parse_error for any other text.
  Json json() const { return Json::parse(out); }
};

/// Runs the built program as a new user would, in a new empty folder.
class Stranger : public testing::Test {
 protected:
  Stranger();
  ~Stranger() override;

  Ran Run(const std::vector<std::string>& arguments) const;
  /// Runs the program and sends it `signal` as soon as `now` returns true. The status is 128 plus the signal's number
  /// if the signal ended it.
  Ran RunUntil(const std::vector<std::string>& arguments, int signal, const std::function<bool()>& now) const;
  /// Runs any program with arguments, and sends it the signal if one is given.
  Ran RunWords(std::vector<std::string> words, int signal = 0, const std::function<bool()>& now = {}) const;

  std::filesystem::path In(const std::string& name) const { return folder_ / name; }
  /// Sorted names of the files in the folder.
  std::vector<std::string> Found() const;
  std::string Read(const std::string& name) const;
  void Write(const std::string& name, const std::string& text) const;

  /// Writes a plan of a short walk to `name` with the program.
  Json MakePlan(const std::string& name) const;

 private:
  std::filesystem::path folder_, talk_;  ///< working folder; folder of the captured output
};

/// Expects status 1 or 2, one line on standard error that contains each of `parts`, and nothing on standard output.
void ExpectRefused(const Ran& ran, int status, const std::vector<std::string>& parts);

}  // namespace gaitwright::cli
