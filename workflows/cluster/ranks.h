// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

namespace gaitwright {

/// The processes of one MPI run, by number. A process started without MPI is number 0 of 1.
///
/// Messages are texts between rank 0 and the others. All calls are thread-safe. A waiting rank sleeps between polls,
/// so it uses almost no CPU time, even with more ranks than cores.
class Ranks {
 public:
  /// Joins the run in which the process was started, once per process, and leaves it when the last copy ends. There is
  /// one rank if the environment shows no run or the program was built without MPI.
  /// @throws InvalidArgument if the environment shows several processes but the program was built without MPI: each
  /// would do the whole work and write the same files.
  static Ranks Join();

  int rank() const;
  int count() const;
  bool leads() const { return rank() == 0; }

  /// Sends a text to a rank.
  void Send(int to, const std::string& text) const;
  /// Waits for the next text of a rank.
  std::string Receive(int from) const;

  /// Ends all processes of the run at once, after an unrecoverable error.
  [[noreturn]] void Abort(int status) const;

 private:
  struct Run;
  explicit Ranks(std::shared_ptr<Run> run);
  std::shared_ptr<Run> run_;
};

/// Whether the program was built with MPI.
bool BuiltWithMpi();

}  // namespace gaitwright
