// SPDX-License-Identifier: BSD-3-Clause
#include "planning/paths/rrt_star.h"

#include <ompl/base/MotionValidator.h>
#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/StateSampler.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/util/Console.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <numbers>
#include <random>

#include "planning/paths/grid_neighbours_internal.h"

namespace gaitwright {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

using State = ob::SE2StateSpace::StateType;

constexpr double kRangeOfLeg = 3.0;  // longest edge of the tree, in leg lengths

PlanarPose PoseOf(const ob::State* state) {
  const auto* s = state->as<State>();
  return {s->getX(), s->getY(), s->getYaw()};
}

void Put(const PlanarPose& pose, ob::State* state) {
  state->as<State>()->setXY(pose.x_m, pose.y_m);
  const double yaw = std::remainder(pose.yaw_rad, 2.0 * std::numbers::pi);
  state->as<State>()->setYaw(yaw < std::numbers::pi ? yaw : -std::numbers::pi);  // OMPL takes [-pi, pi)
}

/// Pose b with its yaw unwrapped to the value nearest to that of a.
PlanarPose Following(const PlanarPose& a, PlanarPose b) {
  b.yaw_rad = UnwrappedNear(b.yaw_rad, a.yaw_rad);
  return b;
}

/// Keeps OMPL silent while any instance exists, in any thread.
class Silence {
 public:
  Silence() {
    const std::lock_guard<std::mutex> lock(Mutex());
    if (Count()++ > 0) return;
    Before() = ompl::msg::getLogLevel();
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  }
  ~Silence() {
    const std::lock_guard<std::mutex> lock(Mutex());
    if (--Count() == 0) ompl::msg::setLogLevel(Before());
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  static std::mutex& Mutex() {
    static std::mutex mutex;
    return mutex;
  }
  static int& Count() {
    static int count = 0;
    return count;
  }
  static ompl::msg::LogLevel& Before() {
    static ompl::msg::LogLevel before = ompl::msg::LOG_NONE;
    return before;
  }
};

class Validity : public ob::StateValidityChecker {
 public:
  Validity(const ob::SpaceInformationPtr& si, PoseCheck& check) : ob::StateValidityChecker(si), check_(check) {}
  bool isValid(const ob::State* state) const override { return check_.IsFree(PoseOf(state)); }

 private:
  PoseCheck& check_;
};

class Motions : public ob::MotionValidator {
 public:
  Motions(const ob::SpaceInformationPtr& si, PoseCheck& check) : ob::MotionValidator(si), check_(check) {}
  bool checkMotion(const ob::State* a, const ob::State* b) const override {
    const PlanarPose from = PoseOf(a);
    return check_.IsFreeBetween(from, Following(from, PoseOf(b)));
  }
  bool checkMotion(const ob::State* a, const ob::State* b, std::pair<ob::State*, double>& last) const override {
    last.second = 0.0;
    if (last.first != nullptr) si_->copyState(last.first, a);
    return checkMotion(a, b);
  }

 private:
  PoseCheck& check_;
};

class Objective : public ob::OptimizationObjective {
 public:
  Objective(const ob::SpaceInformationPtr& si, const TravelWeights& weights)
      : ob::OptimizationObjective(si), weights_(weights) {}
  bool isSymmetric() const override { return false; }
  ob::Cost stateCost(const ob::State*) const override { return identityCost(); }
  ob::Cost motionCost(const ob::State* a, const ob::State* b) const override {
    const PlanarPose from = PoseOf(a);
    return ob::Cost(TravelCost(from, Following(from, PoseOf(b)), weights_));
  }

 private:
  TravelWeights weights_;
};

/// Draws poses: sometimes the goal until a path is found; near the focus; or anywhere that can improve the path.
class Sampler : public ob::StateSampler {
 public:
  Sampler(const ob::StateSpace* space, const RrtStarProblem& problem, const SampleFocus& focus, double spread_m)
      : ob::StateSampler(space), problem_(problem), focus_(focus), spread_m_(spread_m), random_(problem.seed) {}

  void sampleUniform(ob::State* state) override {
    constexpr double kGoalShare = 0.05, kFocusShare = 0.5;
    constexpr int kAttempts = 100;
    if (guided_ < problem_.guide.size()) return Put(problem_.guide[guided_++], state);
    const double kind = Share();
    if (focus_.cost <= 0.0 && kind < kGoalShare) return Put(problem_.goal, state);
    PlanarPose pose;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      pose = kind < kGoalShare + kFocusShare && !focus_.route.empty() ? NearFocus() : Anywhere();
      if (MayHelp(pose)) break;
    }
    Put(pose, state);
  }
  void sampleUniformNear(ob::State* state, const ob::State* near, double distance) override {
    const PlanarPose at = PoseOf(near);
    Put({at.x_m + distance * Signed(), at.y_m + distance * Signed(), at.yaw_rad + distance * Signed()}, state);
  }
  void sampleGaussian(ob::State* state, const ob::State* mean, double deviation) override {
    sampleUniformNear(state, mean, 2.0 * deviation);
  }

 private:
  double Share() { return static_cast<double>(random_() >> 11U) * 0x1.0p-53; }  // uniform in [0, 1)
  double Signed() { return 2.0 * Share() - 1.0; }
  double Bell() { return Signed() + Signed() + Signed(); }  // standard deviation 1

  PlanarPose Anywhere() {
    const Vector2 low = problem_.extent.min(), size = problem_.extent.sizes();
    return {low.x() + Share() * size.x(), low.y() + Share() * size.y(), std::numbers::pi * Signed()};
  }
  PlanarPose NearFocus() {
    constexpr double kTurn = 0.3;  // [rad]
    const auto i = static_cast<std::size_t>(Share() * static_cast<double>(focus_.route.size()));
    const PlanarPose& at = focus_.route[i];
    const PlanarPose pose{at.x_m + spread_m_ * Bell(), at.y_m + spread_m_ * Bell(), at.yaw_rad + kTurn * Bell()};
    return problem_.extent.contains(Vector2(pose.x_m, pose.y_m)) ? pose : at;
  }
  bool MayHelp(const PlanarPose& pose) const {
    if (focus_.cost <= 0.0) return true;
    const auto distance = [&](const PlanarPose& p) { return std::hypot(p.x_m - pose.x_m, p.y_m - pose.y_m); };
    return distance(problem_.start) + distance(problem_.goal) <= focus_.cost;
  }

  const RrtStarProblem& problem_;
  const SampleFocus& focus_;
  double spread_m_;
  std::size_t guided_ = 0;
  std::mt19937_64 random_;
};

/// RRT* with its own random numbers and neighbour search, so that results are repeatable.
class RepeatableRrtStar : public og::RRTstar {
 public:
  RepeatableRrtStar(const ob::SpaceInformationPtr& si, const RrtStarProblem& problem, double range_m)
      : og::RRTstar(si) {
    rng_.setLocalSeed(problem.seed + 1);
    setGoalBias(0.0);  // the sampler draws the goal
    setRange(range_m);
    const auto place = [](Motion* const& motion) {
      const auto* s = motion->state->as<State>();
      return Vector2(s->getX(), s->getY());
    };
    const double area = problem.extent.sizes().prod();
    const double cell = std::max(0.3 * range_m, std::sqrt(area / 1e5));
    nn_ = std::make_shared<GridNeighbours<Motion*>>(problem.extent, cell, place);
  }
  int states() const { return static_cast<int>(nn_->size()); }
};

std::shared_ptr<ob::SE2StateSpace> SpaceOf(const RrtStarProblem& problem) {
  auto space = std::make_shared<ob::SE2StateSpace>();
  ob::RealVectorBounds bounds(2);
  for (unsigned i = 0; i < 2; ++i) {
    bounds.setLow(i, problem.extent.min()[i]);
    bounds.setHigh(i, problem.extent.max()[i]);
  }
  space->setBounds(bounds);
  space->setSubspaceWeight(1, problem.weights.turn_m_rad);
  return space;
}

/// The path from OMPL's states, which run from the goal to the start, without both ends.
std::vector<PlanarPose> RouteFrom(const std::vector<const ob::State*>& states, const RrtStarProblem& problem) {
  std::vector<PlanarPose> route = {problem.start};
  const std::vector<const ob::State*> in_order(states.rbegin(), states.rend());
  for (const ob::State* state : in_order) route.push_back(Following(route.back(), PoseOf(state)));
  route.push_back(Following(route.back(), problem.goal));
  return route;
}

}  // namespace

RrtStarReport SearchRrtStar(PoseCheck& check, const RrtStarProblem& problem, SampleFocus& focus,
                            const RouteFound& on_route) {
  const Silence silence;
  const double leg = check.space().leg_length_m;
  const auto space = SpaceOf(problem);
  const auto si = std::make_shared<ob::SpaceInformation>(space);
  si->setStateValidityChecker(std::make_shared<Validity>(si, check));
  si->setMotionValidator(std::make_shared<Motions>(si, check));
  space->setStateSamplerAllocator([&](const ob::StateSpace* s) -> ob::StateSamplerPtr {
    return std::make_shared<Sampler>(s, problem, focus, 0.5 * leg);
  });
  si->setup();
  const auto definition = std::make_shared<ob::ProblemDefinition>(si);
  ob::ScopedState<ob::SE2StateSpace> start(space), goal(space);
  Put(problem.start, start.get());
  Put(problem.goal, goal.get());
  constexpr double kSameGoal = 1e-9;
  definition->setStartAndGoalStates(start, goal, kSameGoal);
  definition->setOptimizationObjective(std::make_shared<Objective>(si, problem.weights));
  definition->setIntermediateSolutionCallback(
      [&](const ob::Planner*, const std::vector<const ob::State*>& states, const ob::Cost cost) {
        on_route(RouteFrom(states, problem), cost.value());
      });
  RepeatableRrtStar planner(si, problem, kRangeOfLeg * leg);
  planner.setProblemDefinition(definition);
  planner.setup();
  int asked = 0;
  planner.solve(ob::PlannerTerminationCondition([&] { return asked++ >= problem.iterations; }));
  return {static_cast<int>(planner.numIterations()), planner.states()};
}

}  // namespace gaitwright
