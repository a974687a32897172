// SPDX-License-Identifier: BSD-3-Clause
// rank_program CASE: what the tests of workflows/cluster start under mpirun. Rank 0 prints what it saw.
#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "workflows/cluster/shared_work.h"

namespace gaitwright {
namespace {

std::string Square(int piece) {
  if (piece == 13) throw InvalidArgument("piece 13 does not go");
  std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return std::string(static_cast<std::size_t>(piece % 3) * 50000, '.') + fmt::format("{}", piece * piece);
}

/// Every runner takes pieces from one queue, each in a thread of its own; prints all outcomes by their number.
void ShareSquares(const std::vector<PieceRunner>& runners, int pieces) {
  std::vector<std::string> outcomes(static_cast<std::size_t>(pieces));
  std::atomic<int> next = 0;
  std::vector<std::thread> threads;
  for (const PieceRunner& run : runners) {
    threads.emplace_back([&] {
      for (int piece = next++; piece < pieces; piece = next++) {
        try {
          outcomes[static_cast<std::size_t>(piece)] = run(piece);
        } catch (const std::exception& error) {
          outcomes[static_cast<std::size_t>(piece)] = error.what();
        }
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::string& outcome : outcomes) fmt::print("{}\n", outcome.substr(outcome.find_first_not_of('.')));
}

/// "squares N": N pieces, the last runner rank 0 itself; "problem": rank 1 cannot take part; "other": rank 1 has other
/// work; "fails": a piece fails on another rank; "early N": rank N ends at once.
int Run(const std::string& what, int pieces) {
  const Ranks ranks = Ranks::Join();
  RankReadiness own{.work = "squares", .problem = ""};
  if (what == "problem" && ranks.rank() == 1) own.problem = "no such file";
  if (what == "other" && ranks.rank() == 1) own.work = "cubes";
  SharedWork work(ranks);
  if (what == "early" && ranks.rank() == pieces) return 0;
  if (!ranks.leads()) {
    work.Serve(own, Square);
    return 0;
  }
  Result<std::vector<PieceRunner>> runners = work.Runners(own);
  if (!runners) {
    fmt::print("{}\n", runners.failure().message);
    return 0;
  }
  fmt::print("{} ranks\n", ranks.count());
  if (what != "fails") runners->emplace_back(Square);
  ShareSquares(*runners, pieces);
  return 0;
}

}  // namespace
}  // namespace gaitwright

int main(int argc, char** argv) { return gaitwright::Run(argc > 1 ? argv[1] : "", argc > 2 ? std::stoi(argv[2]) : 0); }
