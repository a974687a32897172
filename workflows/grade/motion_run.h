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

/// One run of a part, with everything drawn that its rubric gives ranges for.
struct MotionRun {
  std::string title;
  std::string terrain_text;  ///< as --terrain names it
  Terrain terrain;
  WalkRequest walk;
  PlayRequest play;
  std::uint64_t seed = 0;  ///< of its trials
};

/// The runs of a part: pure in rubric and seed. @throws InvalidArgument where the rubric asks for what there is not,
/// such as a ground whose parameters are out of range; that is the rubric's fault, and told before anything is marked.
std::vector<MotionRun> DrawRuns(const RubricPart& part, const RobotModel& model, std::uint64_t seed);

/// Where a command leads, from where the robot stands. @throws InvalidArgument for one of steps or of a duration.
PlanarPose GoalOf(const RobotModel& model, const WalkCommand& command);

/// Thrown where a submission's code is of no more use, so that nothing of its part counts.
class BrokenCode : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The program's own plan of a run, that controllers are given. @throws InvalidArgument where there is none.
MotionPlan GivenPlan(const RubricPart& part, const RobotModel& model, const MotionRun& run);

/// Makes a controller of somebody's own for a plan; null for the one that the request names.
using ControllerMaker = std::function<std::unique_ptr<Controller>(const MotionPlan& plan)>;

/// What a part wants of its motions.
struct JudgeSetup {
  const RubricPart& part;
  const RobotModel& model;
  ControllerMaker own = {};
  std::function<std::string()> broken = {};  ///< why the own controller cannot go on; "" while it can
};

/// Audits and plays a plan as a run says, in trials too. The page of its playback is added to `pages`. What cannot be
/// played is told in the outcome. @throws BrokenCode
RunOutcome JudgeRun(const JudgeSetup& setup, const MotionRun& run, const MotionPlan& plan,
                    std::vector<MotionPage>& pages);

/// The mark of a part by its runs: checks, and why runs failed.
PartMark MarkOfRuns(const RubricPart& part, const std::vector<RunOutcome>& runs, std::vector<MotionPage> pages);

}  // namespace gaitwright
