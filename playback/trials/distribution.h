// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace gaitwright {

/// Distribution of a number or a word over the trials.
struct Distribution {
  enum class Kind {
    kFixed,    ///< always `lowest`
    kUniform,  ///< uniform from `lowest` to `highest`
    kNormal,   ///< with `mean` and `std`, drawn again until it is within `lowest` and `highest`
    kNumbers,  ///< one of `numbers`, all equally likely
    kWords,    ///< one of `words`, all equally likely
  };

  Kind kind = Kind::kFixed;
  double lowest = 0.0, highest = 0.0;  ///< range of the values
  double mean = 0.0, std = 0.0;
  std::vector<double> numbers = {};
  std::vector<std::string> words = {};

  /// Always this value.
  static Distribution Fixed(double value);
  /// Uniform from `lowest` to `highest`.
  static Distribution Uniform(double lowest, double highest);
  /// @throws InvalidArgument if std <= 0 or the probability from lowest to highest is less than 0.01.
  static Distribution Normal(double mean, double std, double lowest, double highest);
  /// @throws InvalidArgument for an empty list.
  static Distribution OneOf(const std::vector<double>& numbers);
  /// @throws InvalidArgument for an empty list.
  static Distribution OneOf(const std::vector<std::string>& words);

  /// Whether it has more than one value.
  bool varies() const;

  bool operator==(const Distribution&) const = default;
};

/// Random numbers that depend only on a seed and a name, so that the values of one quantity do not depend on which
/// other quantities are drawn. A SplitMix stream (kinematics/base/random.h).
class NamedRandom {
 public:
  NamedRandom(std::uint64_t seed, std::string_view name);

  /// Uniform in [0, 1).
  double Uniform();
  /// Mean 0, standard deviation 1. Box and Muller, Annals of Mathematical Statistics 29(2), 1958.
  double Normal();
  /// A whole number from 0 to 2^31 - 1, uniform.
  int Whole();

 private:
  std::uint64_t Next();
  std::uint64_t counter_;
};

/// Draws a number. @throws InvalidArgument for a distribution of words.
double Draw(const Distribution& distribution, NamedRandom& random);

/// Draws a word. @throws InvalidArgument unless it is a distribution of words.
const std::string& DrawWord(const Distribution& distribution, NamedRandom& random);

/// Seed of a run's i-th trial, from 0 to 2^31 - 1; the first 2^31 trials of a run all have different seeds.
std::uint64_t SeedOfTrial(std::uint64_t run_seed, int i);

}  // namespace gaitwright
