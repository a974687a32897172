// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/cluster/shared_work.h"

#include <fmt/format.h>

namespace gaitwright {
namespace {

// The first letter of a message says what it is.
constexpr char kReady = 'r', kProblem = 'x', kPiece = 'p', kOutcome = 'o', kDone = 'd', kRefused = 'f';

std::string Message(char kind, const std::string& text) { return std::string(1, kind) + text; }

void LetGo(const Ranks& ranks, char kind) {
  for (int other = 1; other < ranks.count(); ++other) ranks.Send(other, Message(kind, ""));
}

/// Why the readiness of a rank, as it sent it, does not do; empty when it does.
std::string Misgiving(int rank, const std::string& hello, const RankReadiness& own) {
  if (hello.empty() || hello[0] == kProblem)
    return fmt::format("rank {}: {}", rank, hello.substr(hello.empty() ? 0 : 1));
  if (hello.substr(1) == own.work) return "";
  return fmt::format("rank {} has other work before it than rank 0: its plan, disturbances, options or program differ",
                     rank);
}

std::string RunThere(const Ranks& ranks, int rank, int piece) {
  ranks.Send(rank, Message(kPiece, fmt::format("{}", piece)));
  std::string answer = ranks.Receive(rank);
  if (answer.empty() || answer[0] != kOutcome) {
    throw InvalidArgument(fmt::format("rank {}: {}", rank, answer.substr(answer.empty() ? 0 : 1)));
  }
  answer.erase(0, 1);
  return answer;
}

}  // namespace

Result<std::vector<PieceRunner>> RunnersOnOtherRanks(const Ranks& ranks, const RankReadiness& own) {
  std::string misgiving = own.problem;
  std::vector<PieceRunner> runners;
  for (int rank = 1; rank < ranks.count(); ++rank) {
    const std::string theirs = Misgiving(rank, ranks.Receive(rank), own);
    if (misgiving.empty()) misgiving = theirs;
    runners.emplace_back([ranks, rank](int piece) { return RunThere(ranks, rank, piece); });
  }
  if (misgiving.empty()) return runners;
  LetGo(ranks, kRefused);
  return Failure{FailureKind::kBadInput,
                 "rank_not_ready",
                 "SharedWork",
                 misgiving,
                 {"see that every machine has the same program and the same files at the same paths"}};
}

void DismissOtherRanks(const Ranks& ranks) { LetGo(ranks, kDone); }

bool ServeRankZero(const Ranks& ranks, const RankReadiness& own, const PieceRunner& run) {
  ranks.Send(0, own.problem.empty() ? Message(kReady, own.work) : Message(kProblem, own.problem));
  while (true) {
    const std::string order = ranks.Receive(0);
    if (order.empty() || order[0] != kPiece) return !order.empty() && order[0] == kDone;
    std::string answer;
    try {
      answer = Message(kOutcome, run(std::stoi(order.substr(1))));
    } catch (const std::exception& error) {
      answer = Message(kProblem, error.what());
    }
    ranks.Send(0, answer);
  }
}

}  // namespace gaitwright
