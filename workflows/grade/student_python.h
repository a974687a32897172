// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "kinematics/base/file.h"
#include "kinematics/base/result.h"
#include "workflows/sandbox/child_process.h"

namespace gaitwright {

/// A Python that submissions are run with.
struct PythonProgram {
  std::string path, version;
  std::vector<std::string> readable;  ///< files and folders of its own and of its packages
  std::string package;                ///< folder that the package gaitwright is found in; "" for none
  bool has_numpy = false;
};

/// Looks a Python over by running it, since it is trusted: `program` by its path or its name on PATH; "" for
/// /usr/bin/python3, or the python3 on PATH. The package gaitwright is the one beside the running program (in a build
/// tree, or under the same prefix), else the one that this Python has itself.
/// Failure `python`: there is none, it cannot be run, or is older than 3.9.
Result<PythonProgram> LookOver(const std::string& program);

/// What code needs that the user cannot read as whom it runs where the program was started by root, of the package
/// gaitwright and the robots: its path; "" where all can be read, or there is no such change of user.
std::string UnreadableForNobody(const PythonProgram& python);

/// A submission's file in Python, with others that it may import, and what of it is to be called.
struct StudentCode {
  std::vector<OutputFile> files;  ///< names and texts; the first is the one that is asked
  std::string function;
  bool package = false;  ///< whether it may import gaitwright
};

/// A submission in Python, in a process of its own that is confined (ChildProcess) to a folder that goes with it. What
/// it answers is text that nothing is believed of.
class StudentPython {
 public:
  /// Starts it and imports the file. Failure as of ChildProcess, or `submission` with the words of an exception.
  static Result<StudentPython> Start(const PythonProgram& python, const StudentCode& code, const ChildLimits& limits,
                                     bool confined);

  StudentPython(StudentPython&&) noexcept;
  StudentPython& operator=(StudentPython&&) = delete;
  ~StudentPython();

  /// Sends a request, a JSON text in a line, and gives the text of the answer, no longer than that [byte]: an object
  /// with the key `answer`. Failure `submission`: an exception, in a line; `child_answer`: no such object; or as of
  /// ChildProcess.
  Result<std::string> Ask(const std::string& request, std::size_t longest);

  /// Writes a file that it can read. @return its path. Failure as of WriteFileAtomically.
  Result<std::string> Lend(const std::string& name, const std::string& text) const;

 private:
  struct Parts;
  explicit StudentPython(std::unique_ptr<Parts> parts);

  std::unique_ptr<Parts> parts_;
};

/// Whether a failure of StudentPython ended it, so that whatever is asked next fails too.
bool EndedIt(const Failure& failure);

/// Words of a submission as a page may show them: in one line, short, without addresses of memory, which differ from
/// run to run, and without what is no plain text.
std::string ShownWords(const std::string& words);

}  // namespace gaitwright
