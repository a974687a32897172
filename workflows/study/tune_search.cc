// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/tune_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "optimisation/numerics/cma_es.h"
#include "optimisation/numerics/halton.h"

namespace gaitwright {
namespace {

/// Numbers of jobs in the journal: candidates from 0, then finalists, then pairs of held-out blocks.
constexpr std::size_t kFinalistJobs = 1000000, kProofJobs = 2000000;
/// Held-out trials of one job.
constexpr int kBlock = 10;

/// A candidate and its trials.
struct TuneJob {
  std::size_t number = 0;
  StudyPoint values;
  int first = 0, count = 0;
};

/// Results of held-out trials, in their order.
struct HeldOutTrials {
  std::vector<double> value, score, survival;

  void Add(const std::vector<TrialWorth>& trials, double survival_weight) {
    for (const TrialWorth& trial : trials) {
      value.push_back(ValueOf(trial, survival_weight));
      score.push_back(trial.score);
      survival.push_back(trial.survived ? 1.0 : 0.0);
    }
  }
};

class TuneSearch {
 public:
  TuneSearch(const TuneProblem& problem, const TuneOptions& options, std::uint64_t seed, JobJournal& journal,
             const JobOptions& jobs)
      : problem_(problem), options_(options), seed_(seed), journal_(journal), jobs_(jobs) {
    total_ = static_cast<std::size_t>(options.evaluations + std::min(options.finalists, options.evaluations) + 1 +
                                      2 * ((options.held_out + kBlock - 1) / kBlock));
  }

  Result<TuneResult> Search() {
    Try({problem_.usual}, "usual");
    if (!stopped_) Try(Samples(static_cast<std::size_t>(std::max(Left() / 3, 1))), "sample");
    FollowSurfaces();
    FollowCmaEs();
    if (!stopped_) ChooseFavourite();
    std::optional<Failure> refused;
    if (!stopped_ && result_.favourite != 0) refused = Prove();
    if (stopped_) return Interrupted("SearchTuning");
    if (refused) return *refused;
    if (const auto fitted = Fitted(VectorX(), 0)) result_.surface = *fitted;
    return std::move(result_);
  }

 private:
  int unknowns() const { return static_cast<int>(problem_.axes.size()); }
  int Left() const { return options_.evaluations - static_cast<int>(result_.candidates.size()); }

  StudyPoint ValuesAt(const VectorX& shares) const {
    StudyPoint values;
    for (std::size_t k = 0; k < problem_.axes.size(); ++k)
      values.push_back(ValueAt(problem_.axes[k], shares[static_cast<Eigen::Index>(k)]));
    return values;
  }

  bool IsKnown(const StudyPoint& values, const std::vector<StudyPoint>& beside) const {
    const auto same = [&](const TuneCandidate& candidate) { return candidate.values == values; };
    return std::any_of(result_.candidates.begin(), result_.candidates.end(), same) ||
           std::find(beside.begin(), beside.end(), values) != beside.end();
  }

  /// The next points of the Halton sequence that were not tried yet; fewer if the ranges have no more.
  std::vector<StudyPoint> Samples(std::size_t count, std::vector<StudyPoint> beside = {}) {
    const std::size_t wanted = beside.size() + count;
    for (int tries = 0; beside.size() < wanted && tries < 10000; ++tries) {
      const StudyPoint values = ValuesAt(HaltonPoint(next_sample_++, unknowns(), seed_));
      if (!IsKnown(values, beside)) beside.push_back(values);
    }
    return beside;
  }

  /// Evaluates jobs on all threads, except those in the journal.
  std::vector<CandidateWorth> Judge(const std::vector<TuneJob>& jobs) {
    std::vector<CandidateWorth> worths(jobs.size());
    std::vector<std::size_t> pending;
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      const std::optional<std::string> line = journal_.Find(jobs[i].number);
      const Result<CandidateWorth> read = line ? WorthFromLine(*line) : Result<CandidateWorth>(CandidateWorth{});
      if (!read) throw InvalidArgument(read.failure().message);
      worths[i] = *read;
      if (!line) pending.push_back(i);
    }
    done_ += jobs.size() - pending.size();
    const JobOptions each{jobs_.threads,
                          [&](std::size_t done, std::size_t) {
                            if (jobs_.progress) jobs_.progress(done_ + done, total_);
                          },
                          jobs_.stop};
    stopped_ = stopped_ || !RunJobs(
                               pending,
                               [&](std::size_t i) {
                                 worths[i] = problem_.judge(jobs[i].values, jobs[i].first, jobs[i].count);
                                 journal_.Add(jobs[i].number, WorthToLine(worths[i]));
                               },
                               each);
    done_ += pending.size();
    return worths;
  }

  /// Evaluates candidates, as far as the number of evaluations allows, and returns their values.
  std::vector<std::optional<double>> Try(std::vector<StudyPoint> points, const std::string& found_by) {
    points.resize(std::min(points.size(), static_cast<std::size_t>(std::max(Left(), 0))));
    std::vector<TuneJob> jobs;
    for (const StudyPoint& values : points)
      jobs.push_back({result_.candidates.size() + jobs.size(), values, 0, options_.trials});
    const std::vector<CandidateWorth> worths = Judge(jobs);
    std::vector<std::optional<double>> values;
    for (std::size_t i = 0; i < worths.size(); ++i) {
      values.push_back(MeanValue(worths[i], options_.survival_weight));
      result_.candidates.push_back({points[i], found_by, worths[i], values.back()});
    }
    return values;
  }

  std::size_t Best() const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < result_.candidates.size(); ++i) {
      const auto& value = result_.candidates[i].value;
      const auto& so_far = result_.candidates[best].value;
      if (value && (!so_far || *value > *so_far)) best = i;
    }
    return best;
  }

  VectorX BestShares() const {
    return SharesOf(problem_.axes, result_.candidates[Best()].values).cwiseMax(0.0).cwiseMin(1.0);
  }

  /// A surface fitted to the `nearest` candidates around a place, or to all for 0; nothing if they are too few.
  std::optional<FittedSurface> Fitted(const VectorX& place, std::size_t nearest) const {
    std::vector<std::pair<VectorX, double>> known;
    for (const TuneCandidate& candidate : result_.candidates) {
      const VectorX at = SharesOf(problem_.axes, candidate.values);
      const bool within = (at.array() >= -1e-9).all() && (at.array() <= 1.0 + 1e-9).all();
      if (within && candidate.value) known.emplace_back(at, *candidate.value);
    }
    if (nearest > 0 && known.size() > nearest) {
      std::stable_sort(known.begin(), known.end(), [&](const auto& a, const auto& b) {
        return (a.first - place).squaredNorm() < (b.first - place).squaredNorm();
      });
      known.resize(nearest);
    }
    if (known.size() < static_cast<std::size_t>(CoefficientsOfQuadratic(unknowns()) + 1)) return std::nullopt;
    std::vector<VectorX> points;
    std::vector<double> values;
    for (const auto& [at, value] : known) {
      points.push_back(at);
      values.push_back(value);
    }
    return FitQuadratic(points, values);
  }

  void FollowSurfaces() {
    while (!stopped_ && options_.method != "cma-es" && Left() > 0) {
      const std::optional<FittedSurface> whole = Fitted(VectorX(), 0);
      if (!whole && options_.method == "auto") return;
      if (whole && options_.method == "auto" && whole->predicted < options_.smooth_above) return;
      const VectorX best = BestShares();
      std::vector<StudyPoint> points;
      for (const double half : {1.0, 0.25, 0.125, 0.0625}) {
        const auto near = static_cast<std::size_t>(2 * CoefficientsOfQuadratic(unknowns()));
        const std::optional<FittedSurface> fitted = half == 1.0 ? whole : Fitted(best, near);
        if (!fitted) continue;
        const VectorX low = (best.array() - half).max(0.0), high = (best.array() + half).min(1.0);
        const StudyPoint values = ValuesAt(HighestOf(fitted->surface, low, high));
        if (!IsKnown(values, points)) points.push_back(values);
      }
      points = Samples(points.size() < 4 ? 4 - points.size() : 0, points);
      if (points.empty()) return;
      Try(points, "surface");
    }
  }

  void FollowCmaEs() {
    if (stopped_ || Left() <= 0) return;
    CmaEs search(BestShares(), seed_ + 1);
    while (!stopped_ && Left() > 0) {
      std::vector<StudyPoint> points;
      for (const VectorX& shares : search.Ask()) points.push_back(ValuesAt(shares));
      std::vector<std::optional<double>> costs = Try(points, "cma-es");
      if (costs.size() < points.size()) return;
      for (std::optional<double>& cost : costs) cost = cost ? std::optional<double>(-*cost) : std::nullopt;
      search.Tell(costs);
    }
  }

  /// Evaluates the best candidates and the present values on more trials; the best one over all trials is the
  /// favourite.
  void ChooseFavourite() {
    std::vector<std::size_t> ranked(result_.candidates.size());
    std::iota(ranked.begin(), ranked.end(), std::size_t{0});
    const auto value = [&](std::size_t i) { return result_.candidates[i].value.value_or(-1.0); };
    std::stable_sort(ranked.begin(), ranked.end(), [&](auto a, auto b) { return value(a) > value(b); });
    ranked.resize(std::min(ranked.size(), static_cast<std::size_t>(options_.finalists)));
    if (std::find(ranked.begin(), ranked.end(), 0U) == ranked.end()) ranked.push_back(0);
    std::vector<TuneJob> jobs;
    for (const std::size_t i : ranked)
      jobs.push_back({kFinalistJobs + i, result_.candidates[i].values, options_.trials, 2 * options_.trials});
    const std::vector<CandidateWorth> more = Judge(jobs);
    std::vector<std::pair<double, std::size_t>> finals;
    for (std::size_t i = 0; i < ranked.size(); ++i) {
      const std::optional<double> second = MeanValue(more[i], options_.survival_weight);
      const std::optional<double>& first = result_.candidates[ranked[i]].value;
      finals.emplace_back(first && second ? (*first + 2.0 * *second) / 3.0 : -1.0, ranked[i]);
    }
    std::sort(finals.begin(), finals.end(), [](const auto& a, const auto& b) {
      return a.first != b.first ? a.first > b.first : a.second < b.second;
    });
    for (const auto& [mean, candidate] : finals) result_.finalists.push_back(candidate);
    result_.favourite = finals.front().second;
  }

  /// Blocks of held-out trials: of the present values with even numbers, if they have a plan, and of the favourite with
  /// odd numbers.
  std::vector<TuneJob> ProofJobs() const {
    const TuneCandidate &usual = result_.candidates.front(), &favourite = result_.candidates[result_.favourite];
    std::vector<TuneJob> jobs;
    std::size_t number = kProofJobs;
    for (int at = 0; at < options_.held_out; at += kBlock, number += 2) {
      const int first = 3 * options_.trials + at, count = std::min(kBlock, options_.held_out - at);
      if (usual.value) jobs.push_back({number, usual.values, first, count});
      jobs.push_back({number + 1, favourite.values, first, count});
    }
    return jobs;
  }

  /// Runs the held-out test. @return a failure if a trial cannot be played, since the other trials alone prove nothing.
  std::optional<Failure> Prove() {
    const std::vector<TuneJob> jobs = ProofJobs();
    const std::vector<CandidateWorth> worths = Judge(jobs);
    if (stopped_) return std::nullopt;
    HeldOutTrials before, after;
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      const bool of_usual = jobs[i].number % 2 == 0;
      if (worths[i].trials.size() != static_cast<std::size_t>(jobs[i].count)) return NotProved(of_usual, worths[i]);
      (of_usual ? before : after).Add(worths[i].trials, options_.survival_weight);
    }
    const TuneCandidate& usual = result_.candidates.front();
    result_.proof = usual.value ? Compared(before, after) : Alone(after, usual.worth.refusal);
    if (!usual.value || result_.proof->value.better()) result_.chosen = result_.favourite;
    return std::nullopt;
  }

  static Failure NotProved(bool of_usual, const CandidateWorth& worth) {
    return {FailureKind::kBadInput,
            FailureCode::kHeldOut,
            "SearchTuning",
            fmt::format("held-out trials of the {} values could not be played: {}", of_usual ? "present" : "favourite",
                        worth.refusal.empty() ? "some trials have no result" : worth.refusal),
            {}};
  }

  HeldOutProof Compared(const HeldOutTrials& before, const HeldOutTrials& after) const {
    return {options_.held_out, DifferenceOf(before.value, after.value), DifferenceOf(before.score, after.score),
            DifferenceOfShares(before.survival, after.survival), ""};
  }

  HeldOutProof Alone(const HeldOutTrials& after, const std::string& refusal) const {
    const auto mean = [](const std::vector<double>& values) {
      return PairedDifference{.after = std::accumulate(values.begin(), values.end(), 0.0) /
                                       static_cast<double>(values.size())};
    };
    return {options_.held_out, mean(after.value), mean(after.score), mean(after.survival), refusal};
  }

  const TuneProblem& problem_;
  const TuneOptions& options_;
  std::uint64_t seed_, next_sample_ = 0;
  JobJournal& journal_;
  const JobOptions& jobs_;
  TuneResult result_;
  std::size_t done_ = 0, total_ = 0;
  bool stopped_ = false;
};

}  // namespace

VectorX SharesOf(const std::vector<StudyAxis>& axes, const StudyPoint& values) {
  VectorX shares(static_cast<Eigen::Index>(axes.size()));
  for (std::size_t k = 0; k < axes.size(); ++k)
    shares[static_cast<Eigen::Index>(k)] = (NumberOfValue(values[k]) - axes[k].low) / (axes[k].high - axes[k].low);
  return shares;
}

Result<TuneResult> SearchTuning(const TuneProblem& problem, const TuneOptions& options, std::uint64_t seed,
                                JobJournal& journal, const JobOptions& jobs) {
  TuneOptions checked = options;
  CheckOptions(checked.Fields());
  if (problem.axes.empty() || problem.usual.size() != problem.axes.size())
    throw InvalidArgument("SearchTuning: a range and a present value are needed for each of the unknowns");
  for (const StudyAxis& axis : problem.axes) {
    if (!axis.is_range() || !axis.numbers)
      throw InvalidArgument(fmt::format("SearchTuning: axis '{}' is not a range of numbers", axis.key));
  }
  return TuneSearch(problem, options, seed, journal, jobs).Search();
}

}  // namespace gaitwright
