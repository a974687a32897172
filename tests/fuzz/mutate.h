// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace gaitwright::fuzz {

/// Changes inputs as files are damaged in practice, and more: numbers become extreme or invalid, words of the format
/// appear elsewhere, parts are lost, repeated, swapped, nested or taken from another input, bytes change. The same seed
/// gives the same inputs everywhere.
class Mutator {
 public:
  Mutator(std::vector<std::string> words, std::uint64_t seed) : words_(std::move(words)), engine_(seed) {}

  /// One to four changes. @param other  an input from which parts may be taken. @param most  maximum size of the result
  /// [byte].
  std::string Mutate(std::string input, const std::string& other, std::size_t most);

  /// A whole number from 0 to `end` - 1; 0 if `end` is 0.
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
