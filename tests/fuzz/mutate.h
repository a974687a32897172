// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace gaitwright::fuzz {

/// Changes inputs the way that files go wrong, and a bit worse: numbers become extreme or none, words of the format
/// turn up elsewhere, parts are lost, repeated, swapped, nested or taken from another input, bytes change. The same
/// seed gives the same inputs everywhere.
class Mutator {
 public:
  Mutator(std::vector<std::string> words, std::uint64_t seed) : words_(std::move(words)), engine_(seed) {}

  /// One to four changes. @param other  an input that parts may be taken from. @param most  longest result [byte].
  std::string Mutate(std::string input, const std::string& other, std::size_t most);

  /// A whole number from 0 to below `end`, 0 for an end of 0.
  std::size_t Below(std::size_t end) { return end == 0 ? 0 : static_cast<std::size_t>(engine_() % end); }

 private:
  void Change(std::string& input, const std::string& other);
  void ReplaceNumber(std::string& input);
  void ReplaceWord(std::string& input);
  void SwapLines(std::string& input);
  void Nest(std::string& input);
  std::string Piece(const std::string& of);

  std::vector<std::string> words_;
  std::mt19937_64 engine_;
};

}  // namespace gaitwright::fuzz
