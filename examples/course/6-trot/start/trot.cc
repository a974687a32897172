// SPDX-License-Identifier: BSD-3-Clause
// Assignment 6: the parameters of a trot. See ../README.md. Plays options, prints the results and writes the options.
//   trot trot.yaml
#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "kinematics/base/file.h"
#include "workflows/walk/walk.h"

namespace {

using namespace gaitwright;

const OptionTexts kOptions = {
    {"gait.cycle_s", "2.0"},       // time from one touch-down of a foot to the next
    {"gait.duty_factor", "0.75"},  // fraction of the cycle that a foot is on the ground
    {"swing.height_m", "0.01"},    // height of the swing's bump
};
const std::vector<double> kSpeeds = {0.3, 0.6, 0.9};  // [m/s]

/// Plans a trot and plays it in physics.
Result<PlayedWalk> Tried(const RobotModel& model, const OptionTexts& options, double speed_m_s) {
  WalkRequest request;
  request.gait = "trot";
  request.command.speed_m_s = speed_m_s;
  request.command.distance_m = 1.5;
  OptionFields fields = request.Fields();
  for (const auto& [key, text] : options) SetOption(fields, key, text);
  const Result<PlannedWalk> planned = PlanWalk(model, request);
  if (!planned) return planned.failure();
  const PlayRequest as_usual;
  return PlayWalk(model, planned->motion.plan, as_usual);
}

/// One line with the measured values, or the reason why there is no plan.
std::string Line(const Result<PlayedWalk>& played) {
  if (!played) return played.failure().message;
  std::string line;
  for (const char* key : {"clearance_min_m", "joint_speed_use_max", "cost_of_transport"})
    line += fmt::format("{} {:.3f}, ", key, played->report.At(key).value.value_or(0.0));
  return line + played->report.reason;
}

}  // namespace

int main(int argc, char** argv) {
  const Result<RobotModel> model = ChooseRobot("a1", "");
  if (!model) return 1;
  for (const double speed_m_s : kSpeeds)
    fmt::print("{} m/s: {}\n", speed_m_s, Line(Tried(*model, kOptions, speed_m_s)));
  std::string yaml;
  for (const auto& [key, text] : kOptions) yaml += fmt::format("{}: {}\n", key, text);
  const Result<std::string> written = WriteFileAtomically(argc > 1 ? argv[1] : "trot.yaml", yaml);
  if (!written) fmt::print(stderr, "trot: {}\n", written.failure().message);
  return written ? 0 : 1;
}
