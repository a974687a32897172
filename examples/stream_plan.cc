// SPDX-License-Identifier: BSD-3-Clause
#include "examples/stream_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "planning/plan/sample_plan.h"
#include "workflows/walk/walk.h"

namespace gaitwright::examples {
namespace {

/// The machine's own clock.
std::function<double(double)> RealTime() {
  return [start = std::chrono::steady_clock::now()](double until_s) {
    std::this_thread::sleep_until(start + std::chrono::duration<double>(until_s));
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
}

}  // namespace

StreamReport StreamPlan(const MotionPlan& plan, const Gains& gains, HardwareAdapter& adapter,
                        const StreamOptions& options) {
  const auto wait_until = options.wait_until ? options.wait_until : RealTime();
  const auto commands = 1 + std::llround(plan.duration_s() / options.period_s);
  const Eigen::Index n = gains.stiffness.size();
  const auto time_s = [&](auto number) {
    return plan.whole_body.start_s + static_cast<double>(number) * options.period_s;
  };
  StreamReport report;
  WholeBodySample wanted;
  double first_s = 0.0, last_s = 0.0;
  for (long long k = 0, stops = 0; k < commands && stops < 10; ++k, stops += adapter.stopped() ? 1 : 0) {
    last_s = wait_until(static_cast<double>(k) * options.period_s);
    if (k == 0) first_s = last_s;
    SampleWholeBody(plan.whole_body, time_s(k), wanted);
    const JointCommand command{wanted.q.tail(n), wanted.v.tail(n), wanted.tau, gains.stiffness, gains.damping};
    const std::optional<JointState> state = adapter.Exchange(last_s, command, options.patience_s);
    if (!state) continue;
    SampleWholeBody(plan.whole_body, time_s(state->number), wanted);
    report.largest_error = std::max(report.largest_error, (state->q - wanted.q.tail(n)).lpNorm<Eigen::Infinity>());
  }
  report.sent = adapter.sent();
  report.lost = adapter.lost();
  report.stopped = adapter.stopped();
  if (last_s > first_s) report.rate_hz = static_cast<double>(report.sent - 1) / (last_s - first_s);
  return report;
}

StreamReport StreamWalk(const std::string& robot, std::uint16_t port, const StreamOptions& options) {
  const Result<RobotModel> model = ChooseRobot(robot, "");
  if (!model) throw InvalidArgument(model.failure().message);
  WalkRequest request;
  request.command.distance_m = 0.3;
  const Result<PlannedWalk> planned = PlanWalk(*model, request);
  if (!planned) throw InvalidArgument(planned.failure().message);
  HardwareAdapter adapter(port, options.watchdog_s);
  return StreamPlan(planned->motion.plan, DeriveGains(*model), adapter, options);
}

StandInProcess::StandInProcess(const std::string& program, const StandInOptions& options) : said_(nullptr, pclose) {
  const std::string command =
      fmt::format("exec '{}' --step {} --load-error {} --loses-every {} --silent-after {}", program, options.step_s,
                  options.load_error, options.loses_every, options.silent_after);
  said_.reset(popen(command.c_str(), "r"));
  if (!said_ || std::fscanf(said_.get(), "%hu", &port_) != 1)
    throw InvalidArgument(fmt::format("the stand-in robot '{}' does not start", program));
}

}  // namespace gaitwright::examples
