// SPDX-License-Identifier: BSD-3-Clause
#include "examples/standing.h"

#include "examples/standing_controllers.h"
#include "kinematics/model/load_robot.h"
#include "optimisation/pipeline/plan_posture.h"
#include "planning/tasks/repertoire.h"
#include "playback/bullet/play.h"
#include "playback/report/svg_plot.h"
#include "playback/score/stability_report.h"

namespace gaitwright::examples {
namespace {

bool Stands(const RobotModel& model, const MotionPlan& plan, const std::string& strategy, const Vector3& force_W) {
  const auto controller = MakeStandingController(strategy, model, plan);
  PlayOptions options;
  options.push_force_W = force_W;
  options.push_at_s = 0.5;
  const Result<PlaybackLog> log = Play(model, plan, *controller, options);
  if (!log) throw InvalidArgument(log.failure().message);
  return Score(model, plan, *log).At("fell").value == 0.0;
}

/// By doubling, then halving what is left.
double LargestPush(const RobotModel& model, const MotionPlan& plan, const std::string& strategy, const Vector3& way) {
  double stands_n = 0.0, falls_n = 0.1 * model.weight_n();
  if (!Stands(model, plan, strategy, Vector3::Zero())) return 0.0;
  while (Stands(model, plan, strategy, falls_n * way) && falls_n < 20.0 * model.weight_n()) {
    stands_n = falls_n;
    falls_n *= 2.0;
  }
  while (falls_n - stands_n > 0.05 * falls_n) {
    const double middle_n = 0.5 * (stands_n + falls_n);
    (Stands(model, plan, strategy, middle_n * way) ? stands_n : falls_n) = middle_n;
  }
  return stands_n;
}

}  // namespace

std::vector<Withstood> CompareStanding(const std::string& robot) {
  constexpr double kStand = 3.0;  // [s]
  const Result<RobotModel> model = LoadNamedRobot(robot);
  if (!model) throw InvalidArgument(model.failure().message);
  const Result<MotionPlan> plan = PlanPosture(*model, Hold(StandingKey(*model), kStand), {});
  if (!plan) throw InvalidArgument(plan.failure().message);
  std::vector<Withstood> all;
  for (const std::string& strategy : StandingStrategies()) {
    const auto largest = [&](double x, double y) { return LargestPush(*model, *plan, strategy, {x, y, 0.0}); };
    all.push_back({strategy, largest(1.0, 0.0), largest(-1.0, 0.0), largest(0.0, 1.0)});
  }
  return all;
}

std::string StandingPlot(const std::string& robot, const std::vector<Withstood>& all) {
  SvgPlot::Options options;
  options.title = "What " + robot + " can take, standing still: pushes of 0.1 s";
  options.x_label = "largest push withstood [N]";
  options.x_lowest = 0.0;
  for (const Withstood& one : all) {
    for (const char* way : {", ahead", ", back", ", to the left"}) options.rows.push_back(one.strategy + way);
  }
  SvgPlot plot(options);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const int row = 3 * static_cast<int>(k);
    plot.Bar(row, 0.0, all[k].ahead_n, Ink::kDcm, Stroke::kMeasured);
    plot.Bar(row + 1, 0.0, all[k].back_n, Ink::kDcm, Stroke::kMeasured);
    plot.Bar(row + 2, 0.0, all[k].left_n, Ink::kDcm, Stroke::kMeasured);
  }
  return StandaloneSvg(plot.Svg());
}

}  // namespace gaitwright::examples
