// SPDX-License-Identifier: BSD-3-Clause
// Parts that the tests of broken plans share: a robot, its plan, and calls of the audit and of physics.
#pragma once

#include <string>
#include <vector>

#include "workflows/walk/walk.h"

namespace gaitwright {

/// A robot and a plan of two short strides straight forward, slightly below its standing height, so that its legs have
/// room for the changes.
struct Bench {
  RobotModel model;
  MotionPlan plan;
};

/// Made once for each robot.
const Bench& BenchOf(const std::string& robot);

/// The checks that the plan fails, each once, in the audit's order.
std::vector<Law> BrokenLaws(const RobotModel& model, const MotionPlan& plan);

/// @throws std::logic_error if it cannot be played at all.
PlayedWalk Played(const RobotModel& model, const MotionPlan& plan, const std::string& controller = "joint-pd");

bool Says(const std::string& text, const std::string& part);

/// A phase near the middle of the plan in which the largest number of feet swing.
int MiddleSwingPhase(const MotionPlan& plan);

/// The first foothold with a touch-down after 40 % of the time.
std::size_t MiddleFoothold(const MotionPlan& plan);

/// Bends every swing of one foot down into the ground, by a quarter of its lift.
MotionPlan WithSwingsThroughTheGround(const Bench& bench, int foot);

}  // namespace gaitwright
