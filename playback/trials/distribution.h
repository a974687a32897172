// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace gaitwright {

/// How a figure, or a word, is drawn for each trial.
struct Distribution {
  enum class Kind {
    kFixed,    ///< always `lowest`
    kUniform,  ///< evenly from `lowest` to `highest`
    kNormal,   ///< about `mean` with `std`, drawn anew until it is from `lowest` to `highest`
    kNumbers,  ///< one of `numbers`, each as likely
    kWords,    ///< one of `words`, each as likely
  };

  Kind kind = Kind::kFixed;
  double lowest = 0.0, highest = 0.0;  ///< what can come out
  double mean = 0.0, std = 0.0;
  std::vector<double> numbers = {};
  std::vector<std::string> words = {};

  /// Always that value.
  static Distribution Fixed(double value);
  /// Evenly from `lowest` to `highest`.
  static Distribution Uniform(double lowest, double highest);
  /// @throws InvalidArgument where std <= 0 or less than a hundredth of the bell lies from lowest to highest.
  static Distribution Normal(double mean, double std, double lowest, double highest);
  /// @throws InvalidArgument for an empty list.
  static Distribution OneOf(const std::vector<double>& numbers);
  /// @throws InvalidArgument for an empty list.
  static Distribution OneOf(const std::vector<std::string>& words);

  /// Whether it ever differs.
  bool varies() const;

  bool operator==(const Distribution&) const = default;
};

/// Random numbers that depend on a seed and a name alone, so that what is drawn for one figure does not change with
/// what else is drawn. A stream as of SplitMix (kinematics/base/random.h).
class NamedRandom {
 public:
  NamedRandom(std::uint64_t seed, std::string_view name);

  /// Evenly in [0, 1).
  double Uniform();
  /// Mean 0, standard deviation 1. Box and Muller, Annals of Mathematical Statistics 29(2), 1958.
  double Normal();
  /// A whole number from 0 to 2^31 - 1, evenly.
  int Whole();

 private:
  std::uint64_t Next();
  std::uint64_t counter_;
};

/// A number of that distribution. @throws InvalidArgument for one of words.
double Draw(const Distribution& distribution, NamedRandom& random);

/// A word of that distribution. @throws InvalidArgument unless it is one of words.
const std::string& DrawWord(const Distribution& distribution, NamedRandom& random);

/// The seed of a run's i-th trial, from 0 to 2^31 - 1: no two of the first 2^31 trials of a run have the same.
std::uint64_t SeedOfTrial(std::uint64_t run_seed, int i);

}  // namespace gaitwright
