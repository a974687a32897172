// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/grade/motion_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/hash.h"
#include "kinematics/base/random.h"
#include "planning/plan/terrain_scale.h"
#include "planning/terrain/load_terrain.h"
#include "workflows/walk/walk_extent.h"

namespace gaitwright {
namespace {

constexpr std::uint64_t kSeedMask = 0x7fffffff;  // range of seeds in options

/// Draws the numbers of a run, and stores them as text.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : random_(seed) {}

  double Draw(const std::string& name, const NumberRange& range) {
    if (range.low == range.high) return range.low;
    // Rounded, so that the printed value equals the value used.
    const double value = std::round((range.low + random_.Uniform() * (range.high - range.low)) * 1e4) / 1e4;
    words_.push_back(fmt::format("{}={:g}", name, value));
    return std::clamp(value, range.low, range.high);
  }
  std::uint64_t Seed() { return random_.Bits() & kSeedMask; }
  const std::vector<std::string>& words() const { return words_; }

 private:
  SplitMix random_;
  std::vector<std::string> words_;
};

std::string TerrainText(const MotionSetup& setup, Draws& draws) {
  std::vector<std::string> parameters;
  for (const auto& [name, range] : setup.terrain_parameters)
    parameters.push_back(fmt::format("{}={}", name, draws.Draw(name, range)));
  if (parameters.empty()) return setup.terrain;
  return fmt::format("{}{}{}", setup.terrain, setup.terrain.find(':') == std::string::npos ? ":" : ",",
                     fmt::join(parameters, ","));
}

/// The command of a rubric, by key.
class SaidCommand {
 public:
  SaidCommand(const NamedRanges& ranges, Draws& draws) {
    for (const auto& [name, range] : ranges) said_.emplace_back(name, draws.Draw(name, range));
  }
  std::optional<double> Find(const std::string& key) const {
    for (const auto& [name, value] : said_) {
      if (name == key) return value;
    }
    return std::nullopt;
  }
  double Or0(const std::string& key) const { return Find(key).value_or(0.0); }

 private:
  std::vector<std::pair<std::string, double>> said_;
};

WalkCommand CommandOf(const RobotModel& model, const SaidCommand& said) {
  WalkExtent extent{said.Find("distance_m"), said.Find("duration_s"), {}, {}, said.Find("step_length_m")};
  if (said.Find("goal_x_m") || said.Find("goal_y_m") || said.Find("goal_yaw_rad"))
    extent.goal = PlanarPose{said.Or0("goal_x_m"), said.Or0("goal_y_m"), said.Or0("goal_yaw_rad")};
  if (const auto steps = said.Find("steps")) extent.steps = static_cast<int>(std::lround(*steps));
  WalkCommand command;
  command.speed_m_s = said.Or0("speed_m_s");
  command.lateral_speed_m_s = said.Or0("lateral_speed_m_s");
  command.yaw_rate_rad_s = said.Or0("yaw_rate_rad_s");
  SetExtent(model, extent, command);
  return command;
}

PlayRequest PlaybackOf(const MotionSetup& setup, Draws& draws) {
  PlayRequest play;
  play.controller = setup.controller;
  play.play.world.seed = play.sensing.sensors.seed = static_cast<int>(draws.Seed());
  OptionFields fields = play.Fields();
  for (const auto& [key, text] : setup.play_words) SetOption(fields, key, text);
  for (const auto& [key, range] : setup.play_numbers) SetOption(fields, key, fmt::format("{}", draws.Draw(key, range)));
  CheckOptions(fields);
  return play;
}

MotionRun DrawRun(const RubricPart& part, const RobotModel& model, std::uint64_t seed, int number) {
  Draws draws(Fnv1a(fmt::format("{}/{}/{}", part.name, seed, number)));
  MotionRun run;
  run.terrain_text = TerrainText(part.motion, draws);
  Result<Terrain> terrain = LoadTerrain(run.terrain_text, ScaleOf(model));
  if (!terrain) throw InvalidArgument(terrain.failure().message);
  run.terrain = std::move(*terrain);
  run.walk.gait = part.motion.gait;
  run.walk.terrain = run.terrain_text;
  run.walk.command = CommandOf(model, SaidCommand(part.motion.command, draws));
  run.walk.seed = seed;
  run.play = PlaybackOf(part.motion, draws);
  run.seed = draws.Seed();
  run.title = part.motion.runs == 1 ? run.terrain_text : fmt::format("run {}: {}", number + 1, run.terrain_text);
  for (const std::string& word : draws.words()) {
    if (run.terrain_text.find(word) == std::string::npos) run.title += ", " + word;
  }
  return run;
}

}  // namespace

std::vector<MotionRun> DrawRuns(const RubricPart& part, const RobotModel& model, std::uint64_t seed) {
  std::vector<MotionRun> runs;
  try {
    for (int number = 0; number < part.motion.runs; ++number) runs.push_back(DrawRun(part, model, seed, number));
  } catch (const InvalidArgument& error) {
    throw InvalidArgument(fmt::format("part '{}' of the rubric: {}", part.name, error.what()));
  }
  return runs;
}

MotionPlan GivenPlan(const RubricPart& part, const RobotModel& model, const MotionRun& run) {
  Result<PlannedWalk> planned = PlanWalkOn(model, run.terrain, run.walk);
  if (!planned)
    throw InvalidArgument(fmt::format("part '{}' of the rubric has no plan: {}", part.name, planned.failure().message));
  return std::move(planned->motion.plan);
}

PlanarPose GoalOf(const RobotModel& model, const WalkCommand& command) {
  if (command.extent == WalkCommand::Extent::kGoal) return {command.goal_x_m, command.goal_y_m, command.goal_yaw_rad};
  if (command.extent != WalkCommand::Extent::kDistance)
    throw InvalidArgument("a command of steps or of a duration does not set a goal; give a goal or a distance");
  const bool own = command.speed_m_s == 0.0 && command.lateral_speed_m_s == 0.0;
  const double forward = own ? model.nominal_speed_m_s : command.speed_m_s, left = command.lateral_speed_m_s;
  const double turn = command.yaw_rate_rad_s * command.distance_m / std::hypot(forward, left);
  // Along an arc: the chord of the path, at half of the turning angle.
  const double chord =
      std::abs(turn) < 1e-9 ? command.distance_m : command.distance_m * std::sin(turn / 2.0) / (turn / 2.0);
  const double heading = std::atan2(left, forward) + turn / 2.0;
  return {chord * std::cos(heading), chord * std::sin(heading), turn};
}

}  // namespace gaitwright
