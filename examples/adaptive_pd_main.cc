// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "examples/carry_payload.h"

int main(int argc, char** argv) {
  using namespace gaitwright;
  CLI::App app("Joint PD that estimates the robot's payload and adapts its feed-forward", "adaptive_pd");
  std::string robot = "a1";
  double payload_kg = 4.0, rate_per_s = 3.0;
  app.add_option("--robot", robot, "Name of a built-in robot")->capture_default_str();
  app.add_option("--payload", payload_kg, "Payload [kg]")->capture_default_str();
  app.add_option("--rate", rate_per_s, "Adaptation rate [1/s]; 0 disables adaptation")->capture_default_str();
  try {
    app.parse(argc, argv);
    const examples::CarriedPayload adaptive = examples::CarryPayload(robot, payload_kg, rate_per_s);
    const examples::CarriedPayload plain = examples::CarryPayload(robot, payload_kg, 0.0);
    const std::size_t quarter = 250;
    for (std::size_t k = quarter; k <= adaptive.estimates_kg.size(); k += quarter)
      fmt::print("{:5.2f} s  {:6.3f} kg of {:.3f} kg\n", 1e-3 * static_cast<double>(k), adaptive.estimates_kg[k - 1],
                 payload_kg);
    const auto error_rad = [](const examples::CarriedPayload& run) {
      return run.report.At("tracking_joint_rms_rad").value.value_or(0.0);
    };
    fmt::print("joint tracking error {:.2f} mrad rms, without adaptation {:.2f} mrad\n", 1e3 * error_rad(adaptive),
               1e3 * error_rad(plain));
    fmt::print("{}\n", adaptive.report.reason);
    return adaptive.report.pass ? 0 : 3;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "adaptive_pd: {}\n", error.what());
    return 1;
  }
}
