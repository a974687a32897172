// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/search/sound_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "optimisation/search/gait_cycles.h"

namespace gaitwright {
namespace {

using Kind = SearchSituation::Kind;

/// A sound candidate and its evaluation.
using Sound = std::optional<std::pair<Candidate, Evaluation>>;

/// Whether joints or motors refuse a walk: optimising the whole body can avoid that.
bool IsOfJoints(const Failure& refusal) {
  if (!refusal.violation) return refusal.code == FailureCode::kLimits;  // of a plan that was not audited
  const Law law = refusal.violation->law;
  return law == Law::kJointPosition || law == Law::kJointVelocity || law == Law::kJointTorque ||
         law == Law::kTorqueSpeed;
}

/// Evaluates as another evaluator does, and notes whether joints or motors refused any candidate.
class JointWatch : public Evaluator {
 public:
  explicit JointWatch(Evaluator& evaluator) : evaluator_(evaluator) {}

  Evaluation Evaluate(const Candidate& candidate, Effort effort) override {
    Evaluation evaluation = evaluator_.Evaluate(candidate, effort);
    refused_ = refused_ || (evaluation.refusal && IsOfJoints(*evaluation.refusal));
    return evaluation;
  }
  bool Flies(const Candidate& candidate) override { return evaluator_.Flies(candidate); }
  bool refused() const { return refused_; }

 private:
  Evaluator& evaluator_;
  bool refused_ = false;
};

/// The only loop over a table: returns the first row whose whole walk is sound and leaves `least` room.
Sound FirstSound(std::span<const Variation> variations, const Candidate& base, Effort early_check, Evaluator& evaluator,
                 Room least = Room::kNone) {
  for (const Variation& v : variations) {
    const Candidate candidate{v.pace_share * base.pace, base.cycle + v.cycle, v.flight * base.flight,
                              v.other_footholds,        v.finishes,           v.heel_off_rad};
    if (early_check != Effort::kWhole && !evaluator.Evaluate(candidate, early_check).sound()) continue;
    Evaluation whole = evaluator.Evaluate(candidate, Effort::kWhole);
    if (whole.sound() && whole.room >= least) return std::pair(candidate, std::move(whole));
    if (whole.at_every_pace) return {};
  }
  return {};
}

/// Finds the largest speed on level ground, without flight, from the starts of walks.
class LargestStart {
 public:
  LargestStart(const PaceRange& paces, double flight, Evaluator& evaluator)
      : paces_(paces), flight_(flight), evaluator_(evaluator) {}

  /// Climbs from the middle one of the shorter cycles and from the fitted one to neighbouring cycles while the speed
  /// increases. Speed 0 if no cycle has a possible one.
  Candidate Find() {
    constexpr int kMiddle = GaitCycles::kShortest / 2;
    Climb(kMiddle, GaitCycles::kShortest, 1);
    if (best_.cycle == kMiddle) Climb(kMiddle - 1, 1, -1);
    Climb(0, kMiddle - 1, 1);
    Climb(-1, GaitCycles::kLongest, -1);
    if (best_.pace > 0.0) Raise(best_.cycle, 1);
    return best_;
  }

 private:
  void Climb(int from, int to, int step) {
    constexpr int kCoarse = 4;  // tolerance of a cycle's largest speed during the climb, in numbers of two digits
    for (int cycle = from; cycle != to + step; cycle += step) {
      if (!Raise(cycle, kCoarse) && best_.pace > 0.0) return;
    }
  }

  /// Raises the largest speed so far to the largest of a cycle; true if that is larger.
  bool Raise(int cycle, int grain) {
    const auto possible = [&](double pace) {
      return evaluator_.Evaluate({pace, cycle, flight_}, Effort::kStart).sound();
    };
    const double pace =
        best_.pace > 0.0 ? LargestPaceAbove(paces_, best_.pace, grain, possible) : LargestPace(paces_, possible);
    if (pace <= best_.pace) return false;
    best_ = {pace, cycle, flight_};
    return true;
  }

  const PaceRange& paces_;
  const double flight_;
  Evaluator& evaluator_;
  Candidate best_;
};

/// The largest speed on level ground whose whole walk is sound: the largest one for the start or, if the whole walk is
/// refused, some lower ones.
Sound LargestOnLevelGround(const PaceRange& paces, double flight, Evaluator& evaluator) {
  constexpr int kNearTries = 2, kFarTries = 5;  // by a step of two digits each, and by a factor
  constexpr double kFarShare = 0.75;            // five times: down to a quarter of the speed
  const Candidate start = LargestStart(paces, flight, evaluator).Find();
  double pace = start.pace;
  for (int i = 0; i < kNearTries + kFarTries && pace > 0.0; ++i) {
    const std::array<Variation, 2> cycles = {{{1.0, start.cycle}, {1.0, 0}}};
    if (Sound sound = FirstSound(cycles, {pace, 0, flight}, Effort::kStart, evaluator)) return sound;
    pace = NextLower(i < kNearTries ? pace : kFarShare * pace);
  }
  return {};
}

/// A slower speed for a gait with flight; 0 if none is found. It is three quarters of a speed without objections in a
/// look (a look finds less than the audit of a plan), or a speed with a sound start if the gait has no flight at that
/// speed. Each trial is slower by the factor that follows from the violated limits of the last one.
double LargestLeaping(const SearchProblem& problem, Evaluator& evaluator) {
  constexpr int kPaces = 10, kLooks = 3;  // largest number of each, because a look takes seconds
  constexpr double kLowerShare = 0.75;    // of a speed whose look finds nothing; an audit finds more
  const Evaluation asked = evaluator.Evaluate({problem.paces.asked}, Effort::kFirstLook);
  double pace = problem.paces.asked, ease = asked.sound() ? Evaluation{}.ease : asked.ease;
  for (int i = 0, looks = 0; i < kPaces && looks < kLooks; ++i) {
    pace = NextLower(ease * pace);
    const bool flies = evaluator.Flies({pace});
    const Evaluation slower = evaluator.Evaluate({pace}, flies ? Effort::kStartLook : Effort::kStart);
    if (slower.sound()) return flies ? NextLower(kLowerShare * pace) : pace;
    if (slower.at_every_pace) return 0.0;
    ease = flies ? slower.ease : Evaluation{}.ease;
    looks += flies && slower.solved ? 1 : 0;
  }
  return 0.0;
}

bool KeepsRoom(const Evaluation& evaluation) { return evaluation.sound() && evaluation.room >= Room::kAsSolved; }

/// A larger speed than those of the passes, below the requested one, at which a start with the whole body optimised is
/// sound and leaves room for a controller; 0 if none is found. With few trials of the whole body, because each takes
/// seconds: upward from a speed at which the passes suffice, because the requested one may be far out of reach; first
/// with flat soles.
double LargestFinished(const SearchProblem& problem, Evaluator& evaluator) {
  constexpr int kTrials = 3, kTrialsOfHeels = 1;  // each takes seconds
  constexpr double kGrowth = 1.6;                 // a start that is too far from a known solution often finds none
  const auto suffice = [&](double pace) {
    return evaluator.Evaluate({pace, GaitCycles::kShortest / 2}, Effort::kStart).sound();
  };
  double low = SomePace(problem.paces, suffice);
  double best = 0.0;
  for (const Variation& v : FinishedVariationsFor(problem.situation)) {
    if (v.cycle != 0 || low == 0.0) continue;
    double high = problem.paces.asked;
    for (int trial = 0; trial < (v.heel_off_rad > 0.0 ? kTrialsOfHeels : kTrials);) {
      const double middle = TowardsZero(std::min(kGrowth * low, std::sqrt(low * high)), 2);
      if (middle <= low) break;
      if (suffice(middle)) {
        low = middle;
        continue;
      }
      // Without this the walk would be refused before the whole body is tried, see FindSound.
      const Evaluation passes = evaluator.Evaluate({middle}, Effort::kStart);
      const bool is_tried = passes.sound() || IsOfJoints(*passes.refusal);
      const Candidate finished{middle, 0, v.flight, false, true, v.heel_off_rad};
      const bool is_sound = is_tried && KeepsRoom(evaluator.Evaluate(finished, Effort::kStart));
      (is_sound ? low : high) = middle;
      if (is_sound) best = middle;
      trial += is_tried ? 1 : 0;
    }
  }
  return best;
}

/// A slower walk without flight: on level ground the fastest one, over other ground the first sound one of a few.
Sound SlowerWithoutFlight(const SearchProblem& problem, Kind kind, double flight, Evaluator& evaluator) {
  if (kind == Kind::kLevel) return LargestOnLevelGround(problem.paces, flight, evaluator);
  SearchSituation slower;
  slower.kind = kind;
  slower.may_slow_down = true;
  return FirstSound(VariationsFor(slower), {problem.paces.asked, 0, flight}, EarlyCheckOf(kind), evaluator);
}

/// The largest speed at which the gait has no flight, for a gait whose flight depends on the speed; 0 if there is none.
double LargestOnTheGround(const SearchProblem& problem, Evaluator& evaluator) {
  constexpr int kTries = 10;         // down to three fifths of the speed
  constexpr double kLower = 0.95;    // a step that changes the duty factor noticeably
  constexpr double kNoFlight = 0.0;  // see Candidate
  if (!problem.grounded || problem.situation.may_slow_down) return 0.0;
  const Sound sound = SlowerWithoutFlight(problem, *problem.grounded, kNoFlight, evaluator);
  double pace = sound ? sound->first.pace : 0.0;
  for (int i = 0; i < kTries && pace > 0.0; ++i) {
    if (!evaluator.Flies({pace})) return pace;
    pace = NextLower(kLower * pace);
  }
  return 0.0;
}

/// Soles that stay flat find no footholds: the walk with heels that rise, where soles step forward over uneven ground.
/// @param flat  the result with flat soles.
SearchResult WithHeels(const SearchProblem& problem, Evaluator& evaluator, SearchResult flat) {
  constexpr double kHeelOff = 0.5;  // [rad], with which an ankle reaches a step that is a quarter of the leg lower
  constexpr double kSlow = 0.35;    // of the robot's own speed, at which it is too fast for steps that need this
  const SearchSituation& situation = problem.situation;
  if (situation.kind != Kind::kUneven || !situation.may_raise_heels) return flat;
  const double pace = situation.may_slow_down ? kSlow * problem.paces.asked : problem.paces.asked;
  const Candidate candidate{pace, 0, 1.0, false, true, kHeelOff};
  Evaluation evaluation = evaluator.Evaluate(candidate, Effort::kWhole);
  if (evaluation.sound()) return {candidate, std::move(evaluation), FailureCode::kNoFootholds};
  flat.evaluation = std::move(evaluation);  // it names wider limits
  return flat;
}

}  // namespace

SearchResult FindSound(const SearchProblem& problem, Evaluator& evaluator) {
  const Candidate as_asked{problem.paces.asked};
  JointWatch watch(evaluator);
  SearchResult result{as_asked, watch.Evaluate(as_asked, Effort::kWhole), {}};
  if (problem.any_plan || result.evaluation.sound()) return result;
  if (result.evaluation.no_footholds) return WithHeels(problem, evaluator, std::move(result));
  if (result.evaluation.at_every_pace) return result;
  result.why = result.evaluation.refusal->code;
  SearchSituation situation = problem.situation;
  situation.refused_by_ground = result.evaluation.by_ground;
  const bool is_level = situation.kind == Kind::kLevel;
  const std::span<const Variation> finished = FinishedVariationsFor(situation);
  Sound sound;
  if (is_level && watch.refused()) {
    // At the robot's own speed there is a slower row; at a requested speed another cycle may leave more room.
    const bool slows = situation.may_slow_down;
    const std::size_t rows = slows ? finished.size() : std::min<std::size_t>(1, finished.size());
    sound =
        FirstSound(finished.first(rows), as_asked, Effort::kWhole, evaluator, slows ? Room::kAsSolved : Room::kAmple);
  }
  if (!sound) sound = FirstSound(VariationsFor(situation), as_asked, EarlyCheckOf(situation.kind), watch);
  if (!sound && !situation.may_slow_down && watch.refused())
    sound = FirstSound(finished, as_asked, EarlyCheckOf(situation.kind), evaluator);
  if (!sound && situation.may_slow_down && is_level)
    sound = LargestOnLevelGround(problem.paces, as_asked.flight, evaluator);
  if (sound) std::tie(result.candidate, result.evaluation) = std::move(*sound);
  return result;
}

SlowerPace SlowerThatIsSound(const SearchProblem& problem, Evaluator& evaluator) {
  using Known = SlowerPace::Known;
  const SearchSituation& situation = problem.situation;
  if (problem.in_place) return {};
  if (situation.kind == Kind::kFlying) {
    const double leaping = LargestLeaping(problem, evaluator);
    return {leaping > 0.0 ? leaping : LargestOnTheGround(problem, evaluator), Known::kMay};
  }
  if (situation.may_slow_down) return {};
  const bool is_level = situation.kind == Kind::kLevel;
  if (const double finished = is_level ? LargestFinished(problem, evaluator) : 0.0; finished > 0.0)
    return {finished, Known::kMay};
  JointWatch watch(evaluator);
  const Sound sound = SlowerWithoutFlight(problem, situation.kind, Candidate{}.flight, watch);
  const bool is_largest = is_level && !(sound && watch.refused());
  return {sound ? sound->first.pace : 0.0, is_largest ? Known::kLargest : Known::kFeasible};
}

}  // namespace gaitwright
