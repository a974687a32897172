// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/base/result.h"
#include "planning/tasks/lying.h"
#include "workflows/words/plan_tasks.h"
#include "workflows/words/plan_tasks_internal.h"

namespace gaitwright::tasks {

/// Plans tasks in sequence as one motion. Consecutive postures are planned as one motion; walks are planned separately
/// and joined.
class TaskPlanner {
  static constexpr double kThere = 0.02;  // [m] distance from a place at which the robot is there

 public:
  /// @param whole_model  the same robot, with support contacts for lying if the tasks need them; it is the robot of the
  ///                     motion.
  TaskPlanner(const RobotModel& model, const RobotModel& whole_model, const Terrain& terrain,
              const TaskOptions& options);

  /// Begins in a lying posture, or crouching if the robot cannot lie, instead of standing.
  void BeginLow();
  std::optional<Failure> Add(const Task& task);
  Result<MotionPlan> Finish();
  const std::vector<std::string>& notes() const { return notes_; }
  /// End of each added task [s].
  const std::vector<double>& ends_s() const { return ends_s_; }

 private:
  std::optional<Failure> FindGround();
  std::optional<Failure> DoTask(const Task& task, bool again);
  PlanarPose Here() const;
  Pose Start() const;
  std::optional<Failure> Append(MotionPlan next);
  std::optional<Failure> Flush();
  double ChainTime() const;
  std::optional<Failure> AddPosture(const MotionBySize& motion, const Sizes& sizes);
  std::optional<Failure> AddPosture(const PostureMotion& motion);
  std::optional<Failure> AddGestures(PostureKey from, double from_s);
  Result<PostureMotion> GestureMotion(const Task& gesture, const PostureKey& from, double duration_s) const;
  std::optional<Failure> AddWalk(WalkRequest request, bool gestures);
  Result<MotionPlan> WithGestures(MotionPlan walk, PostureKey& key) const;
  Result<MotionPlan> WithGesturesEased(const RobotModel& posed, const Terrain& ground, WalkRequest request,
                                       PostureKey& key) const;
  std::optional<Failure> GoToStartOf(const MotionPlan& walk);
  std::optional<Failure> Walk(const Task& task, bool gestures);
  std::optional<Failure> Turn(const Task& task);
  std::optional<Failure> DoJump(const Task& task);
  std::optional<Failure> JumpOnce(const Task& task, bool gestures);
  std::optional<Failure> JumpTo(const Task& task, double turn_rad);
  std::optional<Failure> Leap(const Jump& jump, bool gestures);
  std::optional<Failure> StandStraight();
  std::optional<Failure> LeapOnto(const Vector2& direction, double turn_rad, double farthest_m, const std::string& what,
                                  const std::function<bool(const GroundPoint&)>& is_it);
  std::optional<Jump> ShortestTo(const Vector2& direction, double turn_rad, double farthest_m,
                                 const std::function<bool(const GroundPoint&)>& is_it) const;
  std::vector<GroundPoint> GroundAfter(const Jump& jump) const;
  double HeightHere() const;
  std::optional<Failure> DoFlip(const Task& task);
  std::optional<Failure> AlreadyThere();
  std::optional<Failure> FaceTowards(const PlaceName& place);
  Vector2 DisplacementTo(const PlaceName& place) const;
  std::optional<Failure> WalkTo(const Task& task);
  std::optional<Failure> StandUp();
  std::optional<Failure> Lie();
  std::optional<Failure> Sit(const Task& task);
  std::optional<Failure> Move(const Task& task);
  std::optional<Failure> BowDown(const Task& task, int times);
  int FootOf(const std::string& side) const;

  const RobotModel& model_;
  const RobotModel& whole_model_;
  const Terrain& terrain_;
  const TaskOptions& options_;
  const Task* task_ = nullptr;  // present task; null for motions that are not requested
  Stance stance_;
  std::optional<Lying> lying_;
  std::vector<PostureMotion> chain_;                        // waiting postures, which are not planned yet
  std::vector<std::pair<PostureMotion, double>> gestures_;  // gestures during these postures, with their start times
  std::optional<MotionPlan> whole_;
  double ground_m_ = 0.0;  // height of the feet at its end above those at its start
  std::vector<std::string> notes_;
  std::vector<double> ends_s_;
};

}  // namespace gaitwright::tasks
