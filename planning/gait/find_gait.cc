// SPDX-License-Identifier: BSD-3-Clause
#include "planning/gait/find_gait.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gaitwright {
namespace {

constexpr double kLongest = 2.0;  // as a multiple of the default cycle, if that scales with the leg
// A gait that needs a cycle shorter than kShortCycle times its default gets a cycle of kRunning times the default
// and a smaller duty factor.
constexpr double kShortCycle = 0.57, kRunning = 0.6;
constexpr double kLeastDuty = 0.3, kRunningDuty = 0.62;
constexpr int kRunningFeet = 4;  // with fewer feet this would be another gait
constexpr double kLeastFlight_s = 0.005;

Failure BadGait(const std::string& message) {
  return {FailureKind::kBadInput, FailureCode::kGait, "FindGait", message, {}};
}

/// File and gait name of a text such as FILE.yaml:NAME; both empty if the text does not name a file.
struct FileAndName {
  std::string file, gait;
  bool is_file() const { return !file.empty(); }
};

FileAndName SplitName(const std::string& name) {
  for (const std::string ending : {".yaml", ".yml"}) {
    if (name.ends_with(ending)) return {name, ""};
    const std::size_t at = name.rfind(ending + ":");
    if (at != std::string::npos) return {name.substr(0, at + ending.size()), name.substr(at + ending.size() + 1)};
  }
  return {};
}

/// The gait for which "walk" or "" stands.
std::string ResolvedName(const std::string& name, int feet) {
  if (!name.empty() && name != "walk") return name;
  if (feet == 2) return "biped";
  if (feet == 4) return name.empty() ? "trot" : "crawl";
  if (feet == 6) return "tripod";
  return name.empty() && feet > 6 && feet % 2 == 0 ? "alternating" : "wave";
}

Result<GaitEntry> EntryOfFile(const FileAndName& wanted, int feet) {
  const Result<std::vector<GaitEntry>> gaits = LoadGaits(wanted.file);
  if (!gaits) return gaits.failure();
  std::vector<std::string> names;
  for (const GaitEntry& entry : *gaits) {
    names.push_back(entry.gait.name);
    const bool is_it = wanted.gait.empty() || entry.gait.name == wanted.gait;
    if (!is_it) continue;
    if (entry.gait.num_feet() == feet) return entry;
    if (wanted.gait.empty() && gaits->size() > 1) {
      return BadGait(
          fmt::format("'{}': its first gait '{}' is for {} feet, but the robot has {}; name another gait as FILE:NAME",
                      wanted.file, entry.gait.name, entry.gait.num_feet(), feet));
    }
    return BadGait(fmt::format("'{}': gait '{}' is for {} feet, but the robot has {}", wanted.file, entry.gait.name,
                               entry.gait.num_feet(), feet));
  }
  return BadGait(fmt::format("'{}' has no gait '{}'; there {} {}", wanted.file, wanted.gait,
                             names.size() == 1 ? "is" : "are", QuotedList(names)));
}

Result<GaitEntry> FindEntry(const std::string& name, int feet) {
  const FileAndName file = SplitName(name);
  if (file.is_file()) return EntryOfFile(file, feet);
  if (feet < 2) return BadGait(fmt::format("the robot has {} feet; gaits need two or more", feet));
  Result<std::vector<GaitEntry>> gaits = BuiltInGaits();
  if (!gaits) return gaits.failure();
  const std::vector<GaitEntry> generated = GeneratedGaits(feet);
  gaits->insert(gaits->end(), generated.begin(), generated.end());
  const std::string wanted = ResolvedName(name, feet);
  std::vector<std::string> names;
  int other_feet = 0;
  for (const GaitEntry& entry : *gaits) {
    if (entry.gait.name == wanted && entry.gait.num_feet() != feet) other_feet = entry.gait.num_feet();
    if (entry.gait.num_feet() != feet) continue;
    if (entry.gait.name == wanted) return entry;
    names.push_back(entry.gait.name);
  }
  if (other_feet > 0) {
    return BadGait(fmt::format("gait '{}' is for {} feet, but the robot has {}; choose one of {}", name, other_feet,
                               feet, QuotedList(names)));
  }
  return BadGait(fmt::format("there is no gait '{}' for {} feet; accepted: {}", name, feet, QuotedList(names)));
}

/// Whether a biped cannot shift its weight over one foot: no ankle rolls its soles, or it has none. Its body falls
/// from foot to foot then.
bool FallsFromFootToFoot(const RobotModel& model) {
  return model.legs.size() == 2 && std::any_of(model.feet.begin(), model.feet.end(),
                                               [](const Foot& foot) { return foot.type != FootType::kSole; });
}

/// Default cycle of a gait for a robot, before it is shortened for speed.
double OwnCycle(const GaitEntry& entry, const RobotModel& model) {
  constexpr double kFalling = 2.4;  // leg times in which a body falls little to each side
  if (entry.gait.cycle_s > 0.0) return entry.gait.cycle_s;
  const double leg_times =
      FallsFromFootToFoot(model) ? std::min(entry.cycle_per_leg_time, kFalling) : entry.cycle_per_leg_time;
  return leg_times * std::sqrt(model.leg_length_m() / kGravity);
}

/// The gait with all duty factors increased by `share` (may be negative).
Gait WithLongerStance(Gait gait, double share) {
  for (double& duty : gait.duty_factor) duty += share;
  return gait;
}

/// If feet lift exactly when others land, forces would jump from some feet to others. A flight of kLeastFlight_s is
/// then inserted.
Gait ClearOfExchanges(const Gait& gait) {
  const double least = kLeastFlight_s / gait.cycle_s;
  const auto flies_still = [&](double longer) {
    return HasFlight(WithLongerStance(gait, longer + (1.0 - 1e-6) * least));
  };
  if (flies_still(0.0) || !HasFlight(WithLongerStance(gait, -0.5 * least))) return gait;
  constexpr int kHalvings = 40;
  double clear = -2.0 * least, blurred = 0.0;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (clear + blurred);
    (flies_still(middle) ? clear : blurred) = middle;
  }
  return WithLongerStance(gait, clear);
}

Gait Fitted(const GaitEntry& entry, const RobotModel& model, double speed_m_s, const GaitOptions& options) {
  Gait gait = entry.gait;
  if (options.duty_factor > 0.0) std::fill(gait.duty_factor.begin(), gait.duty_factor.end(), options.duty_factor);
  if (gait.cycle_s <= 0.0) {
    const double own = OwnCycle(entry, model);
    const double duty = *std::max_element(gait.duty_factor.begin(), gait.duty_factor.end());
    const double travel = options.stance_travel * model.leg_length_m();
    const double wanted = travel / std::max(speed_m_s * duty, 1e-9);
    gait.cycle_s = std::clamp(wanted, entry.shortest_cycle * own, own);
    const bool may_run = options.duty_factor == 0.0 && gait.num_feet() >= kRunningFeet && duty <= kRunningDuty;
    if (may_run && wanted < kShortCycle * own) {
      gait.cycle_s = kRunning * own;
      for (double& share : gait.duty_factor)
        share = std::max(share * wanted / gait.cycle_s, std::min(share, kLeastDuty));
      gait = ClearOfExchanges(gait);
    }
  }
  if (options.cycle_s > 0.0) gait.cycle_s = options.cycle_s;
  const double step_s = options.cycle_step_s;
  if (step_s > 0.0) gait.cycle_s = step_s * std::max(1.0, std::round(gait.cycle_s / step_s));
  return gait;
}

/// The shortest or the longest cycle of a gait, or the cycle in the options if one is given.
Result<double> ScaledCycle(const RobotModel& model, const std::string& name, const GaitOptions& options, bool longest) {
  const Result<GaitEntry> entry = FindEntry(name, static_cast<int>(model.feet.size()));
  if (!entry) return entry.failure();
  if (options.cycle_s > 0.0) return options.cycle_s;
  const double scale = longest ? kLongest : entry->shortest_cycle;
  return (entry->gait.cycle_s > 0.0 ? 1.0 : scale) * OwnCycle(*entry, model);
}

/// Failure for options that are out of range.
std::optional<Failure> CheckGaitOptions(const GaitOptions& options) {
  constexpr double kLeastCycle = 0.05, kLeast = 0.05;  // as in files
  if (options.cycle_s != 0.0 && options.cycle_s < kLeastCycle) {
    return BadGait(fmt::format("option 'gait.cycle_s' is {} s; accepted: {} to 20, or 0 for the gait's default",
                               options.cycle_s, kLeastCycle));
  }
  if (options.duty_factor != 0.0 && options.duty_factor < kLeast) {
    return BadGait(fmt::format("option 'gait.duty_factor' is {}; accepted: {} to 0.99, or 0 for the gait's default",
                               options.duty_factor, kLeast));
  }
  return std::nullopt;
}

}  // namespace

Result<Gait> FindGait(const RobotModel& model, const std::string& name, double speed_m_s, const GaitOptions& options) {
  if (const auto failure = CheckGaitOptions(options)) return *failure;
  const Result<GaitEntry> entry = FindEntry(name, static_cast<int>(model.feet.size()));
  if (!entry) return entry.failure();
  return Fitted(*entry, model, speed_m_s, options);
}

std::string GaitFileOf(const std::string& name) { return SplitName(name).file; }

Result<double> ShortestCycle(const RobotModel& model, const std::string& name, const GaitOptions& options) {
  return ScaledCycle(model, name, options, false);
}

Result<double> LongestCycle(const RobotModel& model, const std::string& name, const GaitOptions& options) {
  return ScaledCycle(model, name, options, true);
}

Result<std::optional<std::array<double, 2>>> OwnTravel(const RobotModel& model, const std::string& name) {
  const Result<GaitEntry> entry = FindEntry(name, static_cast<int>(model.feet.size()));
  if (!entry) return entry.failure();
  std::optional<std::array<double, 2>> travel_m = entry->travel_per_leg;
  if (travel_m) {
    for (double& m : *travel_m) m *= model.leg_length_m();
  }
  return travel_m;
}

Result<double> OwnStride(const RobotModel& model, const std::string& name) {
  const Result<GaitEntry> entry = FindEntry(name, static_cast<int>(model.feet.size()));
  if (!entry) return entry.failure();
  return entry->stride_per_leg * model.leg_length_m();
}

}  // namespace gaitwright
