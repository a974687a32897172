// SPDX-License-Identifier: BSD-3-Clause
#include <bit>
#include <cstdint>
#include <cstring>
#include <stdexcept>

#include "kinematics/base/base64_internal.h"
#include "workflows/repair/kept_solves_internal.h"

namespace gaitwright {
namespace {

static_assert(std::endian::native == std::endian::little, "a journal belongs to one kind of machine");

/// Numbers before those of x.
struct Head {
  std::int64_t size = 0, multipliers = 0, iterations = 0;
  double violations = 0.0;
};

}  // namespace

std::string LineOfSolve(const SolvedWindow& solved) {
  const Head head{solved.x.size(), solved.multipliers.size(), solved.iterations, solved.violations};
  std::string bytes(reinterpret_cast<const char*>(&head), sizeof(head));
  for (const VectorX* numbers : {&solved.x, &solved.multipliers}) {
    bytes.append(reinterpret_cast<const char*>(numbers->data()),
                 static_cast<std::size_t>(numbers->size()) * sizeof(double));
  }
  return Base64(bytes);
}

SolvedWindow SolveOfLine(const std::string& line) {
  const std::string bytes = FromBase64(line);
  const std::size_t numbers = bytes.size() < sizeof(Head) ? 0 : (bytes.size() - sizeof(Head)) / sizeof(double);
  Head head;
  if (bytes.size() >= sizeof(head)) std::memcpy(&head, bytes.data(), sizeof(head));
  if (bytes.size() != sizeof(head) + numbers * sizeof(double) || head.size < 0 || head.multipliers < 0 ||
      static_cast<std::uint64_t>(head.size) > numbers ||
      static_cast<std::uint64_t>(head.multipliers) != numbers - static_cast<std::uint64_t>(head.size))
    throw std::runtime_error("a line of the journal is not the solution of a window");
  SolvedWindow solved{VectorX(head.size), VectorX(head.multipliers), static_cast<int>(head.iterations),
                      head.violations};
  const char* at = bytes.data() + sizeof(head);
  std::memcpy(solved.x.data(), at, static_cast<std::size_t>(head.size) * sizeof(double));
  std::memcpy(solved.multipliers.data(), at + static_cast<std::size_t>(head.size) * sizeof(double),
              static_cast<std::size_t>(head.multipliers) * sizeof(double));
  return solved;
}

std::optional<SolvedWindow> KeptSolves::Find(std::size_t solve) {
  const std::optional<std::string> line = journal_.Find(solve);
  if (!line) return std::nullopt;
  return SolveOfLine(*line);
}

void KeptSolves::Keep(std::size_t solve, const SolvedWindow& solved) {
  const std::string line = LineOfSolve(solved);
  if (line.size() <= JobJournal::kLongestResult) journal_.Add(solve, line);
}

}  // namespace gaitwright
