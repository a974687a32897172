// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/base/nearest_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>

#include "kinematics/base/options.h"

namespace gaitwright {
namespace {

constexpr std::size_t kCompared = 100;  // compared characters; the time is quadratic in this number

/// Number of inserted, deleted or changed letters, and of swaps of neighbouring letters.
std::size_t EditDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before.swap(last);
    last.swap(row);
  }
  return last[b.size()];
}

std::size_t DistanceOf(const std::string& word, const std::string& name) {
  return EditDistance(word.substr(0, kCompared), name.substr(0, kCompared));
}

/// Whether a name, or its part after a dot, begins with the word.
bool Begins(const std::string& name, const std::string& word) {
  return !word.empty() && (name.starts_with(word) || name.find("." + word) != std::string::npos);
}

std::vector<std::string> BeginningWith(const std::string& word, const std::vector<std::string>& candidates) {
  std::vector<std::string> names;
  std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(names),
               [&](const std::string& name) { return Begins(name, word); });
  return names;
}

}  // namespace

std::string NearestName(const std::string& word, const std::vector<std::string>& candidates) {
  const std::vector<std::string> beginning = BeginningWith(word, candidates);
  const std::string* nearest = nullptr;
  std::size_t least = 0;
  for (const std::string& candidate : beginning.empty() ? candidates : beginning) {
    const std::size_t distance = DistanceOf(word, candidate);
    if (beginning.empty() && 2 * distance > std::min(word.size(), kCompared)) continue;
    if (nearest == nullptr || distance < least) {
      nearest = &candidate;
      least = distance;
    }
  }
  return nearest == nullptr ? std::string{} : *nearest;
}

std::string NearestHint(const std::string& word, const std::vector<std::string>& candidates) {
  constexpr std::size_t kMostNamed = 4, kSlip = 1;  // [1], letters
  const std::vector<std::string> beginning = BeginningWith(word, candidates);
  const std::string nearest = NearestName(word, candidates);
  if (nearest.empty()) return "";
  const bool several = beginning.size() > 1 && beginning.size() <= kMostNamed;
  if (several && DistanceOf(word, nearest) > kSlip) return "; the nearest are " + QuotedList(beginning);
  return fmt::format("; the nearest is '{}'", nearest);
}

std::string NearestOrAll(const std::string& word, const std::vector<std::string>& candidates,
                         const std::string& listed_by) {
  constexpr std::size_t kMostListed = 16;
  std::string hint = NearestHint(word, candidates);
  if (!hint.empty() || candidates.empty()) return hint;
  if (candidates.size() > kMostListed) return listed_by.empty() ? "" : "; " + listed_by;
  return "; accepted: " + QuotedList(candidates);
}

}  // namespace gaitwright
