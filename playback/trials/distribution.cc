// SPDX-License-Identifier: BSD-3-Clause
#include "playback/trials/distribution.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinematics/base/hash.h"
#include "kinematics/base/random.h"
#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

constexpr double kLeastOfBell = 0.01;
constexpr std::uint64_t kSeeds = 1ULL << 31;

/// Share of the standard normal distribution below z.
double BellBelow(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

/// An item of a list, by a random number in [0, 1).
template <class List>
const auto& Pick(const List& list, double share) {
  const auto place = static_cast<std::size_t>(share * static_cast<double>(list.size()));
  return list[std::min(place, list.size() - 1)];
}

}  // namespace

Distribution Distribution::Fixed(double value) { return {Kind::kFixed, value, value}; }

Distribution Distribution::Uniform(double lowest, double highest) {
  if (!(lowest <= highest))
    throw InvalidArgument(
        fmt::format("a uniform distribution from {} to {} has its bounds in the wrong order", lowest, highest));
  return {Kind::kUniform, lowest, highest};
}

Distribution Distribution::Normal(double mean, double std, double lowest, double highest) {
  if (!(std > 0.0)) throw InvalidArgument(fmt::format("a normal distribution has std {}; it must be above 0", std));
  if (!(lowest < highest)) {
    throw InvalidArgument(fmt::format(
        "a normal distribution is limited to {} to {}; the second must be above the first", lowest, highest));
  }
  const double share = BellBelow((highest - mean) / std) - BellBelow((lowest - mean) / std);
  if (!(share >= kLeastOfBell)) {
    throw InvalidArgument(fmt::format(
        "a normal distribution with mean {} and std {} has too little probability from {} to {}: {:.3g}; {} is needed",
        mean, std, lowest, highest, share, kLeastOfBell));
  }
  return {Kind::kNormal, lowest, highest, mean, std};
}

Distribution Distribution::OneOf(const std::vector<double>& numbers) {
  if (numbers.empty()) throw InvalidArgument("a choice has no values; one or more are needed");
  const auto [low, high] = std::minmax_element(numbers.begin(), numbers.end());
  return {Kind::kNumbers, *low, *high, 0.0, 0.0, numbers};
}

Distribution Distribution::OneOf(const std::vector<std::string>& words) {
  if (words.empty()) throw InvalidArgument("a choice has no values; one or more are needed");
  return {Kind::kWords, 0.0, 0.0, 0.0, 0.0, {}, words};
}

bool Distribution::varies() const {
  if (kind == Kind::kWords) return std::any_of(words.begin(), words.end(), [&](auto& w) { return w != words.front(); });
  return lowest < highest;
}

NamedRandom::NamedRandom(std::uint64_t seed, std::string_view name)
    : counter_(MixBits(MixBits(seed + 1) ^ Fnv1a(name))) {}

std::uint64_t NamedRandom::Next() { return MixBits(counter_ += kSplitMixStep); }

double NamedRandom::Uniform() { return static_cast<double>(Next() >> 11) * 0x1p-53; }

double NamedRandom::Normal() {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - Uniform()));
  return radius * std::cos(2.0 * std::numbers::pi * Uniform());
}

int NamedRandom::Whole() { return static_cast<int>(Next() >> 33); }

double Draw(const Distribution& d, NamedRandom& random) {
  switch (d.kind) {
    case Distribution::Kind::kFixed:
      return d.lowest;
    case Distribution::Kind::kUniform:
      return d.lowest + random.Uniform() * (d.highest - d.lowest);
    case Distribution::Kind::kNormal:
      for (;;) {
        const double value = d.mean + d.std * random.Normal();
        if (value >= d.lowest && value <= d.highest) return value;
      }
    case Distribution::Kind::kNumbers:
      return Pick(d.numbers, random.Uniform());
    case Distribution::Kind::kWords:
      break;
  }
  throw InvalidArgument("a number is needed, but the distribution is a choice of words");
}

const std::string& DrawWord(const Distribution& d, NamedRandom& random) {
  if (d.kind != Distribution::Kind::kWords)
    throw InvalidArgument("a word is needed, but the distribution is a choice of numbers");
  return Pick(d.words, random.Uniform());
}

std::uint64_t SeedOfTrial(std::uint64_t run_seed, int i) {
  constexpr std::uint64_t kOddStride = 0x4F1BBCDDULL;  // odd, so that it reaches all of them
  return (MixBits(run_seed + kSplitMixStep) + kOddStride * static_cast<std::uint64_t>(i)) % kSeeds;
}

}  // namespace gaitwright
