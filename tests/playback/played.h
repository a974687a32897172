// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "playback/score/stability_report.h"
#include "tests/playback/synthetic.h"

namespace gaitwright::synthetic {

/// A synthetic robot, its plan, and the log of a playback that follows the plan exactly; tests then modify them.
struct Played {
  explicit Played(RobotModel robot, MotionPlan motion)
      : model(std::move(robot)), plan(std::move(motion)), log(PerfectLog(model, plan)) {}

  RobotModel model;
  MotionPlan plan;
  PlaybackLog log;

  double Value(const std::string& key) const { return Score(model, plan, log).At(key).value.value(); }
  double Planned(const std::string& key) const { return Score(model, plan, log).At(key).planned.value(); }
};

/// Two soles, or four feet of a type.
inline RobotModel RobotWith(int legs, FootType of_four) { return Robot(legs, legs == 2 ? FootType::kSole : of_four); }

/// A biped that stands for a second.
inline Played Stood() {
  const RobotModel model = RobotWith(2, FootType::kSole);
  return Played(model, StandingPlan(model, 1.0));
}

/// A biped or a quadruped on spheres that walks.
inline Played Walked(int legs = 2, const Steps& steps = {}) {
  const RobotModel model = RobotWith(legs, FootType::kSphere);
  return Played(model, SteppingPlan(model, steps));
}

/// Whether a text contains a part.
inline bool Says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace gaitwright::synthetic
