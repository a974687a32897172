// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/search/plan_within.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "optimisation/pipeline/dynamic_motion.h"
#include "optimisation/search/gait_cycles.h"
#include "optimisation/search/refuse_walk.h"
#include "optimisation/search/slower_pace.h"
#include "optimisation/search/walk_evaluator.h"
#include "planning/footsteps/plan_footsteps.h"

namespace gaitwright {
namespace {

/// Whether a walk stays where it is, so that there is no slower one; steps of a millimetre go nowhere either.
bool IsInPlace(const WalkCommand& c) {
  constexpr double kNoStep = 1e-3;  // [m]
  return c.extent == WalkCommand::Extent::kSteps && c.speed_m_s == 0.0 && c.lateral_speed_m_s == 0.0 &&
         c.yaw_rate_rad_s == 0.0 && std::abs(c.step_length_m) < kNoStep;
}

Adjustment OfCycle(double asked_s, double given_s, FailureCode why) {
  return {"gait.cycle_s", asked_s, given_s, "s", why};
}

bool IsOfBalance(const Failure& failure) { return failure.violation && failure.violation->law == Law::kZmpSupport; }

/// Looks for plans that pass their audit, at a gait's fitted time or another, and for the largest pace that has one.
/// What is possible is found on brief walks, the start of the whole one on a coarse grid; a whole walk is then planned
/// only where its brief one passes.
class Search {
 public:
  Search(const RobotModel& model, const Terrain& terrain, const WalkRequest& request, SearchTrace* trace)
      : model_(model),
        terrain_(terrain),
        request_(request),
        trace_(trace),
        evaluator_(model, terrain, request, trace) {}

  /// The plan of a command: as the gait is fitted, or at another cycle where only that passes; else the first one's
  /// outcome. What the joints cannot do may be helped by quicker steps, what the ground cannot hold by slower ones.
  Result<PlannedWalk> Plan(const WalkCommand& command) const {
    const Result<GaitCycles> cycles = CyclesFor(command);
    if (!cycles) return cycles.failure();
    if (Leaps(cycles->fitted) && !request_.motion.pipeline.allow_limits) {
      const FirstLook look = evaluator_.Look(cycles->fitted, command, true);
      if (look.refusal) {
        ease_ = look.ease;
        Result<PlannedWalk> other = WithOtherFlights(cycles->fitted, command, look.refusal->code);
        return other ? other : *look.refusal;
      }
    }
    Result<PlannedWalk> first = evaluator_.Whole(cycles->fitted, command, false);
    if (request_.motion.pipeline.allow_limits || IsSound(first)) return first;
    if (!first && !IsTooMuch(first.failure())) return first;
    const FailureCode why = ReasonRefused(first);
    if (Leaps(cycles->fitted)) {
      Result<PlannedWalk> other = WithOtherFlights(cycles->fitted, command, why);
      return other ? other : first;
    }
    if (!IsLevelGround(terrain_)) {
      Result<PlannedWalk> eased = IsOwnPace() ? Eased(command, kOwnEases, why) : Eased(command, kEases, why);
      return eased ? eased : first;
    }
    const bool ground = first ? BrokenLimits(first->audit).empty() : IsOfBalance(first.failure());
    Result<PlannedWalk> other = FirstOf(ground ? std::vector<int>{-1, -2, -3, -4, 1, 2, 3, 4, 5, 6}
                                               : std::vector<int>{1, 2, 3, 4, 5, 6, -1, -2, -3, -4},
                                        *cycles, command, why);
    if (other || !IsOwnPace()) return other ? other : first;
    SoundWalk slower = LargestThatIsSound(why);
    if (slower.pace == 0.0) return first;
    slower.planned->motion.plan.adjustments.push_back(OfPace(command, slower.pace, why));
    return std::move(slower.planned);
  }

  /// A slower pace to name. With gaits that leap a few are looked at, over ground that is not level some are tried, and
  /// none where Plan chose the pace already.
  SlowerPace Slower() const {
    using Known = SlowerPace::Known;
    if (IsInPlace(request_.command)) return {};
    if (const Result<GaitCycles> cycles = CyclesFor(request_.command); cycles && Leaps(cycles->fitted)) {
      const double leaping = LargestLeaping();
      return {leaping > 0.0 ? leaping : LargestOnTheGround(), Known::kMay};
    }
    if (IsOwnPace()) return {};
    if (IsLevelGround(terrain_)) return {LargestThatIsSound(FailureCode::kLimits).pace, Known::kLargest};
    const Result<PlannedWalk> slower = Eased(request_.command, kOwnEases, FailureCode::kLimits);
    return {slower ? PaceValue(model_, slower->motion.plan.parts.front().command) : 0.0, Known::kServes};
  }

 private:
  struct SoundWalk {
    double pace = 0.0;  ///< 0 for none
    Result<PlannedWalk> planned = Failure{};
  };

  /// The walk of the request's command at the largest pace that has a plan on level ground, without leaps.
  SoundWalk LargestThatIsSound(FailureCode why) const {
    constexpr int kDigits = 2, kLowered = 5;
    constexpr double kShare = 0.75;
    int serves = 0;
    double largest = LargestBrief(serves);
    for (int i = 0; i < kDigits + kLowered && largest > 0.0; ++i) {
      const WalkCommand slower = AtPace(model_, request_.command, largest);
      const Result<GaitCycles> cycles = CyclesFor(slower);
      if (cycles) {
        if (Result<PlannedWalk> planned = FirstOf({serves, 0}, *cycles, slower, why))
          return {largest, std::move(planned)};
      }
      largest = NextLower(i < kDigits ? largest : kShare * largest);
    }
    return {};
  }

  /// Whether a gait is planned as the motion of a rigid body, which takes much longer.
  bool Leaps(const Gait& gait) const { return IsDynamic(gait, request_.motion.centre_of_mass); }

  /// Leaps onto other ground, down or over something, with a flight that is longer or shorter than the gait's own: what
  /// feet have to clear, and how far the body falls, say how long it should be. Only of counted leaps whose times are
  /// not given.
  Result<PlannedWalk> WithOtherFlights(const Gait& gait, const WalkCommand& command, FailureCode why) const {
    constexpr double kMost = 0.95;  // of the cycle
    const bool given = request_.gait_options.cycle_s > 0.0 || request_.gait_options.duty_factor > 0.0;
    const bool leaps = command.extent == WalkCommand::Extent::kSteps && HasFlight(gait) && !IsLevelGround(terrain_);
    for (const double longer : {0.8, 1.15}) {
      if (given || !leaps) break;
      Gait other = gait;
      for (double& duty : other.duty_factor) duty = std::min(1.0 - longer * (1.0 - duty), kMost);
      if (evaluator_.Look(other, command, true).refusal) continue;
      Result<PlannedWalk> planned = evaluator_.Whole(other, command, true);
      if (!IsSound(planned)) continue;
      planned->motion.plan.adjustments.push_back(
          {"gait.duty_factor", gait.duty_factor.front(), other.duty_factor.front(), "1", why});
      return planned;
    }
    return Failure{
        FailureKind::kInfeasible, FailureCode::kLimits, "PlanWalk", "no plan with another flight time is feasible", {}};
  }

  /// Three quarters of a slower pace that a first look finds nothing against, or a pace whose brief walk passes where
  /// the gait stays on the ground at it; 0 for none. Each is as much slower as the last one's limits say.
  double LargestLeaping() const {
    constexpr int kPaces = 10, kLooks = 3;
    constexpr double kSpare = 0.75;
    double pace = PaceValue(model_, request_.command), ease = ease_;
    for (int i = 0, looks = 0; i < kPaces && looks < kLooks; ++i) {
      pace = NextLower(ease * pace);
      const WalkCommand slower = AtPace(model_, request_.command, pace);
      const Result<GaitCycles> cycles = CyclesFor(slower);
      if (!cycles) return 0.0;
      if (!Leaps(cycles->fitted)) {
        if (Brief(*cycles, 0, slower) > 0.0) return pace;
        ease = kEase;
        continue;
      }
      const FirstLook look = evaluator_.Look(cycles->fitted, slower, false);
      if (!look.refusal) return NextLower(kSpare * pace);
      ease = look.ease;
      looks += look.solved ? 1 : 0;
    }
    return 0.0;
  }

  /// The largest pace at which a gait that flies only when it is fast stays on the ground; 0 for none.
  double LargestOnTheGround() const {
    const Result<Gait> slow = FindGait(model_, request_.gait, 0.0, request_.gait_options);
    if (!slow || Leaps(*slow)) return 0.0;
    WalkRequest grounded = request_;
    grounded.gait_options.duty_factor = *std::max_element(slow->duty_factor.begin(), slow->duty_factor.end());
    double pace = Search(model_, terrain_, grounded, trace_).Slower().value;
    constexpr int kTries = 10;
    constexpr double kLower = 0.95;
    for (int i = 0; i < kTries && pace > 0.0; ++i) {
      const WalkCommand slower = AtPace(model_, request_.command, pace);
      const Result<GaitCycles> cycles = CyclesFor(slower);
      if (cycles && !Leaps(cycles->fitted)) return pace;
      pace = NextLower(kLower * pace);
    }
    return 0.0;
  }

  /// A share of the pace, and the number of a cycle.
  struct Ease {
    double pace;
    int cycle;
  };
  static constexpr std::array<Ease, 4> kEases = {{{1.0, -1}, {1.0, -2}, {1.0, -3}, {1.0, -4}}};
  static constexpr std::array<Ease, 6> kOwnEases = {{{1.0, -1}, {0.7, 0}, {0.7, -1}, {0.7, -2}, {0.5, -1}, {0.35, -2}}};

  bool IsOwnPace() const {
    const WalkCommand& c = request_.command;
    return request_.own_pace || (c.extent != WalkCommand::Extent::kSteps && c.speed_m_s == 0.0 &&
                                 c.lateral_speed_m_s == 0.0 && c.yaw_rate_rad_s == 0.0);
  }

  /// The first of some easier walks that passes. Over ground that is not level it is the ground that says how long
  /// steps are, so that quicker ones do not help.
  Result<PlannedWalk> Eased(const WalkCommand& command, std::span<const Ease> eases, FailureCode why) const {
    for (const Ease& ease : eases) {
      WalkCommand slower = command;
      if (ease.pace < 1.0) slower = AtPace(model_, command, ease.pace * PaceValue(model_, command));
      const Result<GaitCycles> cycles = CyclesFor(slower);
      if (!cycles) return cycles.failure();
      const Gait gait = cycles->At(ease.cycle);
      Result<PlannedWalk> planned = evaluator_.Whole(gait, slower, true);
      if (!planned && !IsTooMuch(planned.failure())) return planned;
      if (!IsSound(planned)) continue;
      std::vector<Adjustment>& adjustments = planned->motion.plan.adjustments;
      if (ease.pace < 1.0) adjustments.push_back(OfPace(command, PaceValue(model_, slower), why));
      if (ease.cycle != 0) adjustments.push_back(OfCycle(cycles->fitted.cycle_s, gait.cycle_s, why));
      return planned;
    }
    return Failure{FailureKind::kInfeasible,
                   FailureCode::kLimits,
                   "PlanWalk",
                   "no plan with a lower speed or longer cycle is feasible",
                   {}};
  }

  Adjustment OfPace(const WalkCommand& command, double given, FailureCode why) const {
    const Pace pace = PaceOf(command);
    return {PaceFlag(pace), PaceValue(model_, command), given, PaceUnit(pace), why};
  }

  /// Raises the largest pace so far to that whose brief walk passes with a cycle of that number, short of it by less
  /// than `grain` numbers of two digits; true when it is larger.
  bool Raise(int number, int grain, double& largest) const {
    const auto can_walk = [&](const WalkCommand& c) {
      const Result<GaitCycles> cycles = CyclesFor(c);
      return cycles && Brief(*cycles, number, c) > 0.0;
    };
    const double before = largest;
    largest = before > 0.0 ? LargestPaceAbove(model_, request_.command, before, grain, can_walk)
                           : LargestPace(model_, request_.command, can_walk);
    return largest > before;
  }

  /// Largest pace whose brief walk passes with any of the cycles, and the number of that: from the middle one of the
  /// quicker ones and from the fitted one on, by neighbours as long as they do better. 0 when none has any.
  double LargestBrief(int& serves) const {
    constexpr int kMiddle = GaitCycles::kQuickest / 2, kCoarse = 4;
    double largest = 0.0;
    const auto climb = [&](int from, int to, int step) {
      for (int i = from; i != to + step; i += step) {
        if (Raise(i, kCoarse, largest)) {
          serves = i;
        } else if (largest > 0.0) {
          return;
        }
      }
    };
    climb(kMiddle, GaitCycles::kQuickest, 1);
    if (serves == kMiddle) climb(kMiddle - 1, 1, -1);
    climb(0, kMiddle - 1, 1);
    climb(-1, GaitCycles::kSlowest, -1);
    if (largest > 0.0) Raise(serves, 1, largest);
    return largest;
  }

  Result<GaitCycles> CyclesFor(const WalkCommand& command) const { return FindCycles(model_, request_, command); }

  /// WalkEvaluator::Start with one of the cycles.
  double Brief(const GaitCycles& cycles, int number, const WalkCommand& command) const {
    return evaluator_.Start(cycles.At(number), cycles.fitted.cycle_s, command);
  }

  /// The plan with the first of some cycles that passes.
  Result<PlannedWalk> FirstOf(const std::vector<int>& numbers, const GaitCycles& cycles, const WalkCommand& command,
                              FailureCode why) const {
    std::set<double> tried_s;
    for (const int number : numbers) {
      const double height = Brief(cycles, number, command);
      if (height == 0.0) continue;
      const Gait gait = cycles.At(number);
      if (!tried_s.insert(gait.cycle_s).second) continue;  // all quicker ones are one where nothing is gained by them
      Result<PlannedWalk> planned = evaluator_.WholeAt(height, gait, command);
      if (!IsSound(planned)) continue;
      if (number != 0) planned->motion.plan.adjustments.push_back(OfCycle(cycles.fitted.cycle_s, gait.cycle_s, why));
      return planned;
    }
    return Failure{
        FailureKind::kInfeasible, FailureCode::kLimits, "PlanWalk", "no plan with another cycle is feasible", {}};
  }

  const RobotModel& model_;
  const Terrain& terrain_;
  const WalkRequest& request_;
  static constexpr double kEase = 0.8;
  mutable double ease_ = kEase;  // of the pace asked for, at which a plan is looked for first
  SearchTrace* trace_;
  mutable WalkEvaluator evaluator_;
};

/// The failure with what it would take instead; of a plan that was made and not given that it can be had all the same.
Failure Refusal(const Search& search, const RobotModel& model, const WalkRequest& request, Failure failure) {
  const WalkCommand& command = request.command;
  const Result<Gait> gait = FindGait(model, request.gait, CommandedSpeed(model, command), request.gait_options);
  if (!gait) return failure;
  const SlowerPace slower = search.Slower();
  const bool at_every_pace =
      failure.code == FailureCode::kLegsTooSlow || failure.code == FailureCode::kLegsTooWeak || IsInPlace(command);
  if (slower.value == 0.0) {
    if (!at_every_pace)
      failure.message += fmt::format("; no {1} of robot '{0}' was found that has a sound plan with gait '{2}'",
                                     model.name, PaceName(PaceOf(command)), gait->name);
    failure.suggestions.insert(failure.suggestions.begin(), "another gait");
    return failure;
  }
  const WalkCommand at_pace = AtPace(model, command, slower.value);
  failure.message += "; " + slower.Text(at_pace, gait->name);
  failure.suggestions.insert(failure.suggestions.begin(), slower.AsSuggestion(at_pace));
  return failure;
}

}  // namespace

Result<PlannedWalk> PlanWithin(const RobotModel& model, const Terrain& terrain, const WalkRequest& request,
                               SearchTrace* trace) {
  const Search search(model, terrain, request, trace);
  Result<PlannedWalk> planned = search.Plan(request.command);
  if (request.motion.pipeline.allow_limits || IsSound(planned)) return planned;
  if (planned) return Refusal(search, model, request, WhyForbidden(*planned));
  return IsTooMuch(planned.failure()) ? Refusal(search, model, request, planned.failure()) : planned;
}

}  // namespace gaitwright
