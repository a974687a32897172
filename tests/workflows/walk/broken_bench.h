// SPDX-License-Identifier: BSD-3-Clause
// What the tests of broken plans share: a robot, its whole plan, and how both judges are asked.
#pragma once

#include <string>
#include <vector>

#include "workflows/walk/walk.h"

namespace gaitwright {

/// A robot and a plan of two short strides straight ahead, a little below its standing height, so that its legs have
/// room for what is broken.
struct Bench {
  RobotModel model;
  MotionPlan plan;
};

/// Made once for each robot.
const Bench& BenchOf(const std::string& robot);

/// The laws that the plan breaks, each once, in the audit's order.
std::vector<Law> BrokenLaws(const RobotModel& model, const MotionPlan& plan);

/// @throws std::logic_error when it cannot be played at all.
PlayedWalk Played(const RobotModel& model, const MotionPlan& plan, const std::string& controller = "joint-pd");

bool Says(const std::string& text, const std::string& part);

/// A phase about half way in which as many feet swing as ever do.
int MiddleSwingPhase(const MotionPlan& plan);

/// The first foothold that is taken after 40 % of the time.
std::size_t MiddleFoothold(const MotionPlan& plan);

/// Every swing of one foot bent down through the ground, by a quarter of its lift.
MotionPlan WithSwingsThroughTheGround(const Bench& bench, int foot);

}  // namespace gaitwright
