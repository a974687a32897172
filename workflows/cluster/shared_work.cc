// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/cluster/shared_work.h"

#include <fmt/format.h>

#include <utility>

namespace gaitwright {
namespace {

// The first letter of a message is its type.
constexpr char kReady = 'r', kProblem = 'x', kPiece = 'p', kOutcome = 'o', kDone = 'd', kRefused = 'f';

std::string Message(char kind, const std::string& text) { return std::string(1, kind) + text; }

/// Why a rank cannot take part, from its readiness message; empty if it can.
std::string ReasonUnready(int rank, const std::string& hello, const RankReadiness& own) {
  if (hello.empty() || hello[0] == kProblem)
    return fmt::format("rank {}: {}", rank, hello.substr(hello.empty() ? 0 : 1));
  if (hello.substr(1) == own.work) return "";
  return fmt::format("rank {} has different work from rank 0: its plan, disturbances, options or program differ", rank);
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

void SharedWork::LetGo(char kind) {
  ended_ = true;
  for (int other = 1; other < ranks_.count(); ++other) ranks_.Send(other, Message(kind, ""));
}

SharedWork::~SharedWork() {
  if (ended_) return;
  if (!ranks_.leads()) {
    Serve({.work = "", .problem = "it ended before the work began"}, {});
    return;
  }
  for (int other = 1; !begun_ && other < ranks_.count(); ++other) ranks_.Receive(other);
  LetGo(begun_ ? kDone : kRefused);
}

Result<std::vector<PieceRunner>> SharedWork::Runners(const RankReadiness& own) {
  begun_ = true;
  std::string difference = own.problem;
  std::vector<PieceRunner> runners;
  for (int rank = 1; rank < ranks_.count(); ++rank) {
    const std::string theirs = ReasonUnready(rank, ranks_.Receive(rank), own);
    if (difference.empty()) difference = theirs;
    runners.emplace_back([ranks = ranks_, rank](int piece) { return RunThere(ranks, rank, piece); });
  }
  if (difference.empty()) return runners;
  LetGo(kRefused);
  return Failure{FailureKind::kBadInput,
                 FailureCode::kRankNotReady,
                 "SharedWork",
                 difference,
                 {"make sure that every machine has the same program and the same files at the same paths"}};
}

bool SharedWork::Serve(const RankReadiness& own, const PieceRunner& run) {
  if (std::exchange(ended_, true)) return false;
  ranks_.Send(0, own.problem.empty() ? Message(kReady, own.work) : Message(kProblem, own.problem));
  while (true) {
    const std::string order = ranks_.Receive(0);
    if (order.empty() || order[0] != kPiece) return !order.empty() && order[0] == kDone;
    std::string answer;
    try {
      answer = Message(kOutcome, run(std::stoi(order.substr(1))));
    } catch (const std::exception& error) {
      answer = Message(kProblem, error.what());
    }
    ranks_.Send(0, answer);
  }
}

}  // namespace gaitwright
