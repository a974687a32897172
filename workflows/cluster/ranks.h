// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

namespace gaitwright {

/// The processes of one MPI run, by number; a process that nobody started under MPI is alone, number 0 of 1.
///
/// Messages are texts, and go between rank 0 and the others. All calls may be made from several threads. Who waits
/// sleeps in between, so that it leaves its core to others: on a machine with fewer cores than ranks waiting costs
/// next to nothing.
class Ranks {
 public:
  /// Joins the run in which the process was started, once in a process; it is left at the end of the last copy.
  /// Alone where the environment tells of no run, or where the program was built without MPI.
  /// @throws InvalidArgument where the environment tells of several processes, and the program was built without MPI:
  /// each would do the whole work and write the same files.
  static Ranks Join();

  int rank() const;
  int count() const;
  bool leads() const { return rank() == 0; }

  /// Sends a text to a rank.
  void Send(int to, const std::string& text) const;
  /// Waits for the next text of a rank.
  std::string Receive(int from) const;

  /// Ends all processes of the run at once, after something that cannot be mended.
  [[noreturn]] void Abort(int status) const;

 private:
  struct Run;
  explicit Ranks(std::shared_ptr<Run> run);
  std::shared_ptr<Run> run_;
};

/// Whether the program was built with MPI.
bool BuiltWithMpi();

}  // namespace gaitwright
