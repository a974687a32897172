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

/// Python interpreter for submissions.
struct PythonProgram {
  std::string path, version;
  std::vector<std::string> readable;  ///< files and folders of the interpreter and its packages
  std::string package;                ///< folder of the package gaitwright, or ""
  bool has_numpy = false;
};

/// Inspects a Python by running it (it is trusted): `program` is a path or a name on PATH; "" for /usr/bin/python3, or
/// the python3 on PATH. The package gaitwright is the one beside the running program (in a build tree, or under the
/// same prefix), otherwise the one of this Python. Failure `python`: it does not exist, cannot be run, or is older than
/// 3.9.
Result<PythonProgram> LookOver(const std::string& program);

/// Path of a file of the package gaitwright or of the robots that submissions need but cannot read as user nobody, if
/// the program was started by root; "" if all can be read, or if the user does not change.
std::string UnreadableForNobody(const PythonProgram& python);

/// A submission's Python file, with files that it may import, and the function to call.
struct StudentCode {
  std::vector<OutputFile> files;  ///< names and texts; the first is the submitted file
  std::string function;
  bool package = false;  ///< whether it may import gaitwright
};

/// A Python submission in its own process, confined (ChildProcess) to a temporary folder. Its answers are untrusted
/// text.
class StudentPython {
 public:
  /// Starts it and imports the file. Failure as of ChildProcess, or `submission` with the message of an exception.
  static Result<StudentPython> Start(const PythonProgram& python, const StudentCode& code, const ChildLimits& limits,
                                     bool confined);

  StudentPython(StudentPython&&) noexcept;
  StudentPython& operator=(StudentPython&&) = delete;
  ~StudentPython();

  /// Sends a request, a JSON text in one line. @return the text of the answer, an object with the key `answer`, of at
  /// most `longest` bytes. Failure `submission`: an exception, in one line; `child_answer`: another answer; or as of
  /// ChildProcess.
  Result<std::string> Ask(const std::string& request, std::size_t longest);

  /// Writes a file that the submission can read. @return its path. Failure as of WriteFileAtomically.
  Result<std::string> Lend(const std::string& name, const std::string& text) const;

 private:
  struct Parts;
  explicit StudentPython(std::unique_ptr<Parts> parts);

  std::unique_ptr<Parts> parts_;
};

/// Whether a failure of StudentPython ended the process, so that all further requests fail too.
bool EndedIt(const Failure& failure);

/// Text of a submission for a page: one short line, without memory addresses, which differ between runs, and with plain
/// text only.
std::string ShownWords(const std::string& words);

}  // namespace gaitwright
