// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"
#include "planning/plan/terrain.h"
#include "playback/engine/controller.h"
#include "workflows/grade/marks.h"
#include "workflows/grade/motion_measures.h"
#include "workflows/grade/rubric.h"
#include "workflows/walk/walk.h"

namespace gaitwright {

/// One run of a part, with values drawn from the ranges of its rubric.
struct MotionRun {
  std::string title;
  std::string terrain_text;  ///< text as for --terrain
  Terrain terrain;
  WalkRequest walk;
  PlayRequest play;
  std::uint64_t seed = 0;  ///< seed of its trials
};

/// The runs of a part: a pure function of rubric and seed. @throws InvalidArgument if the rubric is wrong, for example
/// with terrain parameters out of range; this is reported before marking.
std::vector<MotionRun> DrawRuns(const RubricPart& part, const RobotModel& model, std::uint64_t seed);

/// Goal of a command, relative to the robot's start. @throws InvalidArgument for a command of steps or of a duration.
PlanarPose GoalOf(const RobotModel& model, const WalkCommand& command);

/// Thrown if a submission's code cannot continue, so its part gets no points.
class BrokenCode : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The program's plan of a run, for submitted controllers. @throws InvalidArgument if there is none.
MotionPlan GivenPlan(const RubricPart& part, const RobotModel& model, const MotionRun& run);

/// Makes a submitted controller for a plan; null for the one that the request names.
using ControllerMaker = std::function<std::unique_ptr<Controller>(const MotionPlan& plan)>;

/// Requirements of a part on its motions.
struct JudgeSetup {
  const RubricPart& part;
  const RobotModel& model;
  ControllerMaker own = {};
  std::function<std::string()> broken = {};  ///< why the submitted controller cannot continue; "" while it can
};

/// Audits and plays a plan as set by a run, including trials. The page of its playback is added to `pages`. The outcome
/// states if it cannot be played. @throws BrokenCode
RunOutcome JudgeRun(const JudgeSetup& setup, const MotionRun& run, const MotionPlan& plan,
                    std::vector<MotionPage>& pages);

/// The mark of a part from its runs: checks, and reasons of failed runs.
PartMark MarkOfRuns(const RubricPart& part, const std::vector<RunOutcome>& runs, std::vector<MotionPage> pages);

}  // namespace gaitwright
