// SPDX-License-Identifier: BSD-3-Clause
// Part of climb.h: converts walks up and down stairs to places.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "workflows/words/climb.h"
#include "workflows/words/items.h"
#include "workflows/words/places.h"
#include "workflows/words/stairs_words.h"

namespace gaitwright::words {
namespace {

/// The places along stairs, in order: the ground before them, the steps up, a landing that is not a step, the steps
/// down, the ground behind them. A place without a name is empty.
struct Stairs {
  std::vector<PlaceName> levels;
  int top = 0;  ///< index of the highest place in `levels`

  int end() const { return static_cast<int>(levels.size()) - 1; }
  /// Index of a place in `levels`; nothing if it is not on the stairs.
  std::optional<int> LevelOf(const PlaceName& place) const {
    if (IsStep(place.name)) return place.number == -1 ? top : place.number;
    const auto level = std::find(levels.begin(), levels.end(), place);
    if (level == levels.end()) return std::nullopt;
    return static_cast<int>(level - levels.begin());
  }
};

const PlaceName* Find(const std::vector<PlaceName>& places, const std::string& name) {
  const auto found =
      std::find_if(places.begin(), places.end(), [&](const PlaceName& place) { return place.name == name; });
  return found == places.end() ? nullptr : &*found;
}

std::optional<Stairs> StairsOf(const std::vector<PlaceName>& places, bool chinese) {
  const PlaceName* step = chinese ? Find(places, "台阶") : nullptr;
  for (const char* name : {"step", "stair", "台阶"}) step = step != nullptr ? step : Find(places, name);
  if (step == nullptr || step->number < 1) return std::nullopt;
  Stairs stairs;
  stairs.levels.push_back(Find(places, kStartOfStairs) != nullptr ? PlaceName{kStartOfStairs, 0} : PlaceName{});
  for (int k = 1; k <= step->number; ++k) stairs.levels.push_back({step->name, k});
  for (const char* landing : {"landing", "平台"}) {
    if (Find(places, landing) != nullptr) stairs.levels.push_back({landing, 0});
  }
  stairs.top = stairs.end();
  for (int k = 1; Find(places, fmt::format("{} {} down", step->name, k)) != nullptr; ++k)
    stairs.levels.push_back({fmt::format("{} {} down", step->name, k), 0});
  if (Find(places, kEndOfStairs) != nullptr) stairs.levels.push_back({kEndOfStairs, 0});
  return stairs;
}

/// Follows the robot's place on the stairs over the tasks.
class StairsWalker {
 public:
  StairsWalker(const std::string& text, const std::optional<Stairs>& stairs) : text_(text), stairs_(stairs) {}

  void Do(Draft& draft) {
    if (draft.action == "turn") return Turn(draft);
    if (draft.action != "walk") return;
    const auto said = draft.parameters.find("to");
    const bool is_said = said != draft.parameters.end() && std::get<PlaceName>(said->second).name != kStairs;
    if (draft.stairs != 0 && is_said) {
      CheckDirection(draft, std::get<PlaceName>(said->second));
    } else if (draft.stairs != 0) {
      if (!stairs_)
        Refuse(FailureCode::kPlace, draft, "needs stairs, but this ground has none",
               "--terrain stairs, or a file of a ground whose steps have names");
      SetPlace(draft, Target(draft));
    }
    const auto to = draft.parameters.find("to");
    at_ = to != draft.parameters.end() && stairs_ ? stairs_->LevelOf(std::get<PlaceName>(to->second)) : std::nullopt;
    turned_deg_ = 0.0;
  }

 private:
  [[noreturn]] void Refuse(FailureCode code, const Draft& draft, const std::string& why,
                           const std::string& say = "") const {
    throw Refused{{code, TextOf(text_, draft.words), why, "", say}};
  }

  void Turn(const Draft& draft) {
    const auto angle = draft.parameters.find("angle_deg"), direction = draft.parameters.find("direction");
    const bool right = direction != draft.parameters.end() && direction->second == TaskValue(std::string("right"));
    constexpr double kQuarter = 90.0;
    const double by_deg = angle == draft.parameters.end() ? kQuarter : std::get<double>(angle->second);
    turned_deg_ += right ? -by_deg : by_deg;
  }

  static void SetPlace(Draft& draft, const PlaceName& place) {
    const auto steps = draft.said.find("steps");
    if (steps != draft.said.end()) draft.said["to"] = steps->second;
    draft.parameters["to"] = place;
    draft.parameters.erase("steps");
    draft.said.erase("steps");
  }

  int HeightOf(int level) const { return std::min(level, 2 * stairs_->top - level); }

  /// "go down to the second step": a given place on the stairs must be below the robot.
  void CheckDirection(const Draft& draft, const PlaceName& place) const {
    const std::optional<int> there = stairs_ ? stairs_->LevelOf(place) : std::nullopt;
    if (!there || !at_ || *there == *at_) return;
    const bool up = HeightOf(*there) > HeightOf(*at_);
    if (draft.stairs == 1 && !up)
      Refuse(FailureCode::kCannot, draft, "goes up, but the place is not above the robot's place at that time");
    if (draft.stairs == -1 && up)
      Refuse(FailureCode::kCannot, draft, "goes down, but the place is not below the robot's place at that time");
  }

  /// Direction along the levels: 1 or -1.
  int DirectionOf(const Draft& draft) const {
    const int at = *at_, top = stairs_->top;
    if (draft.stairs == 2) return 1;
    if (at != top) return (at < top) == (draft.stairs > 0) ? 1 : -1;
    if (draft.stairs > 0) Refuse(FailureCode::kCannot, draft, "goes up, but the robot is already at the top");
    if (stairs_->end() == top) return -1;
    const double forward = std::cos(turned_deg_ * std::numbers::pi / 180.0);
    constexpr double kForward = 0.3;
    if (std::abs(forward) < kForward)
      Refuse(FailureCode::kAmbiguous, draft, "does not name the side of the stairs to go down",
             "'turn around' before it, or nothing");
    return forward > 0.0 ? 1 : -1;
  }

  PlaceName Target(const Draft& draft) const {
    const auto steps = draft.parameters.find("steps");
    const bool whole = steps == draft.parameters.end();
    if (!at_ && whole && draft.stairs == 1) return stairs_->levels[static_cast<std::size_t>(stairs_->top)];
    if (!at_)
      Refuse(FailureCode::kAmbiguous, draft,
             "starts on the stairs, but the step where the previous walk ends is unknown",
             "a step by its number: 'to the second step'");
    const int at = *at_, end = stairs_->end(), top = stairs_->top;
    if (draft.stairs == -1 && (at == 0 || (at == end && end > top)))
      Refuse(FailureCode::kCannot, draft, "goes down, but the robot stands on the ground below the stairs",
             "climb the stairs first: 'climb the stairs, then go down'");
    const int direction = DirectionOf(draft), limit = draft.stairs == 1 ? top : direction > 0 ? end : 0;
    const int there = std::abs(limit - at);
    const int by = whole ? there : std::get<int>(steps->second);
    if (by < 1 || by > there)
      Refuse(FailureCode::kRange, draft,
             fmt::format("goes {} steps, but there are {} steps from the robot's place at that time", by, there));
    PlaceName place = stairs_->levels[static_cast<std::size_t>(at + direction * by)];
    if (place.name.empty())
      Refuse(FailureCode::kCannot, draft,
             "goes down to the ground before the stairs, which has no name on this ground");
    return place;
  }

  const std::string& text_;
  const std::optional<Stairs>& stairs_;
  std::optional<int> at_ = 0;
  double turned_deg_ = 0.0;
};

}  // namespace

void SettleStairs(const std::string& text, const std::vector<PlaceName>& places, std::vector<Draft>& drafts) {
  const std::optional<Stairs> stairs = StairsOf(places, LanguageOf(text) == Language::kChinese);
  StairsWalker walker(text, stairs);
  for (Draft& draft : drafts) walker.Do(draft);
}

}  // namespace gaitwright::words
