// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/robot_body.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/model/load_robot.h"
#include "kinematics/spatial/rotation.h"
#include "planning/gait/find_gait.h"
#include "tests/kinematics/drawn.h"

namespace gaitwright {
namespace {

constexpr double kReserve = 0.03;

/// Distance of a place inside a foot's workspace from the nearest side.
double InsideBy(const RigidFoot& foot, const Vector3& p_CF) {
  double least = std::numeric_limits<double>::infinity();
  for (const WorkspaceSide& side : foot.workspace_B) least = std::min(least, side.offset - side.normal.dot(p_CF));
  return least;
}

class RobotBodyTest : public testing::TestWithParam<const char*> {
 protected:
  RobotBodyTest() { ForwardKinematics(model_, StandingConfiguration(model_), scratch_); }

  /// The skeleton of a short walk.
  FootstepSkeleton Skeleton(const WalkCommand& command) const {
    const Gait gait = *FindGait(model_, "", CommandedSpeed(model_, command), {});
    return *PlanFootsteps(model_, FlatTerrain(), gait, command, {});
  }
  /// Forward and to the left, with a turn at the end.
  WalkCommand Curved() const {
    WalkCommand command;
    command.extent = WalkCommand::Extent::kGoal;
    command.goal_x_m = 0.3;
    command.goal_y_m = 0.1;
    command.goal_yaw_rad = 0.4;
    return command;
  }
  RigidBodyProblem Problem(const FootstepSkeleton& skeleton, const Terrain& terrain = FlatTerrain()) const {
    return ProblemOf(model_, body_, terrain, skeleton, BodyPath(model_, skeleton, 0.5));
  }

  const RobotModel model_ = *LoadNamedRobot(GetParam());
  const StandingBody body_ = BodyOf(model_, kReserve);
  DynamicsScratch scratch_{model_};
};

INSTANTIATE_TEST_SUITE_P(Robots, RobotBodyTest, testing::Values("a1", "nao"), [](const auto& i) { return i.param; });

TEST_P(RobotBodyTest, ABodyEndsAtTheGoalWhereItsFeetCameToStandNearIt) {
  FootstepSkeleton skeleton = Skeleton(Curved());
  const Vector3 end = Problem(skeleton).goal.p_WC;
  for (const double off : {0.03, 0.07, 0.1}) {  // of the leg
    FootstepSkeleton moved = skeleton;
    moved.goal.x_m += off * model_.leg_length_m();
    const RigidBodyProblem problem = Problem(moved);
    const double by_m = off < 0.08 ? off * model_.leg_length_m() : 0.0;
    EXPECT_NEAR((problem.goal.p_WC - end - Vector3(by_m, 0.0, 0.0)).norm(), 0.0, 1e-9) << off;
    EXPECT_EQ(problem.path.p_WC.back(), problem.goal.p_WC);
  }
}

TEST_P(RobotBodyTest, FeetLikeToStandWhereTheyDoInStandingAndThatIsInTheirWorkspaces) {
  ASSERT_EQ(body_.feet.size(), model_.feet.size());
  const Vector3 p_WC = CentreOfMass(model_, scratch_);
  for (std::size_t f = 0; f < body_.feet.size(); ++f) {
    const RigidFoot& foot = body_.feet[f];
    EXPECT_NEAR(foot.p_CF_nominal_B.z(), -p_WC.z(), 1e-6) << "on the ground";
    const Vector3 p_WF = ContactFrame(model_, scratch_, static_cast<int>(f)).translation();
    EXPECT_LT((p_WC + foot.p_CF_nominal_B - p_WF).norm(), 1e-12);
    EXPECT_GT(InsideBy(foot, foot.p_CF_nominal_B), 0.005 * model_.leg_length_m()) << f;
    EXPECT_EQ(foot.contacts_F.size(), model_.feet[f].has_sole() ? model_.feet[f].sole_F.size() : 1U);
  }
}

/// The controlled frame is a radius above the contact frame in the standing posture. If the two were confused,
/// workspaces would be wrong by the radius.
TEST_P(RobotBodyTest, WorkspacesAreOfContactFramesFromTheCentreOfMass) {
  for (int f = 0; f < static_cast<int>(body_.feet.size()); ++f) {
    LegWorkspace workspace(model_, f, kReserve);
    const RigidFoot& foot = body_.feet[static_cast<std::size_t>(f)];
    const double radius = model_.feet[static_cast<std::size_t>(f)].radius;
    std::mt19937 engine(5);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    int tried = 0, reached = 0;
    for (int i = 0; i < 40000 && tried < 300; ++i) {
      const Vector3 p_CF = foot.p_CF_nominal_B + 0.6 * model_.leg_length_m() * Drawn<Vector3>(unit, engine);
      if (InsideBy(foot, p_CF) < 0.0) continue;
      Pose X_BF = workspace.standing();
      X_BF.translation() = body_.R_HB.transpose() * (body_.p_HC + p_CF + radius * Vector3::UnitZ());
      ++tried;
      reached += workspace.Reaches(X_BF) ? 1 : 0;
    }
    ASSERT_EQ(tried, 300);
    EXPECT_GE(reached, tried * 97 / 100) << f << ": all but those between two rays, as of the polytope itself";
  }
}

TEST_P(RobotBodyTest, WorkspacesOfTwoFeetAreApart) {
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (std::size_t i = 0; i < body_.feet.size(); ++i) {
    int inside = 0;
    for (int draw = 0; draw < 4000; ++draw) {
      const Vector3 p = body_.feet[i].p_CF_nominal_B + 0.6 * model_.leg_length_m() * Drawn<Vector3>(unit, engine);
      if (InsideBy(body_.feet[i], p) < 0.0) continue;
      ++inside;
      for (std::size_t j = 0; j < body_.feet.size(); ++j) {
        if (i == j) continue;
        Vector3 across = body_.feet[j].p_CF_nominal_B - body_.feet[i].p_CF_nominal_B;
        across.z() = 0.0;
        const double middle = across.dot(0.5 * (body_.feet[i].p_CF_nominal_B + body_.feet[j].p_CF_nominal_B));
        EXPECT_LT((across.dot(p) - middle) / across.norm(), -0.04 * model_.leg_length_m()) << i << " and " << j;
        EXPECT_LT(InsideBy(body_.feet[j], p), 0.0);
      }
    }
    EXPECT_GT(inside, 25);
  }
}

TEST_P(RobotBodyTest, TheInertiaIsOneThatABodyCanHave) {
  const Vector3 main = Eigen::SelfAdjointEigenSolver<Matrix3>(body_.inertia_H).eigenvalues();
  EXPECT_LT((body_.inertia_H - body_.inertia_H.transpose()).norm(), 1e-12);
  EXPECT_GT(main[0], 0.0);
  EXPECT_LE(main[2], main[0] + main[1]);
  // The radius of gyration is a plausible share of the robot's size.
  const double gyration_m = std::sqrt(main[2] / model_.total_mass_kg);
  EXPECT_GT(gyration_m, 0.2 * model_.leg_length_m());
  EXPECT_LT(gyration_m, 2.0 * model_.leg_length_m());
  EXPECT_LT((body_.inertia_H - LockedInertia(model_, scratch_)).norm(), 1e-12);
}

TEST_P(RobotBodyTest, TheGreatestForceIsWhatTheFirstMotorHolds) {
  for (int f = 0; f < static_cast<int>(body_.feet.size()); ++f) {
    const RigidFoot& foot = body_.feet[static_cast<std::size_t>(f)];
    VectorX tau = VectorX::Zero(model_.nv());
    AddPointForce(model_, scratch_, model_.feet[static_cast<std::size_t>(f)].body,
                  ContactFrame(model_, scratch_, f).translation(), foot.force_max_n * Vector3::UnitZ(), tau);
    double used = 0.0;
    for (int d = 0; d < model_.num_dofs(); ++d)
      used = std::max(used, std::abs(tau[6 + d]) / model_.dof_effort_limit(d));
    EXPECT_NEAR(used, 1.0, 1e-9) << f;
    EXPECT_GT(foot.force_max_n, 1.5 * model_.weight_n() / static_cast<double>(body_.feet.size())) << f;
  }
}

TEST_P(RobotBodyTest, LeftAndRightAreMirrored) {
  for (std::size_t f = 0; f < body_.feet.size(); ++f) {
    const int other = model_.legs[f].mirror;
    ASSERT_GE(other, 0);
    const RigidFoot &a = body_.feet[f], &b = body_.feet[static_cast<std::size_t>(other)];
    EXPECT_LT((a.p_CF_nominal_B - Vector3(b.p_CF_nominal_B.x(), -b.p_CF_nominal_B.y(), b.p_CF_nominal_B.z())).norm(),
              0.02 * model_.leg_length_m());
    EXPECT_NEAR(a.force_max_n, b.force_max_n, 0.02 * a.force_max_n);
  }
}

TEST_P(RobotBodyTest, AWalksProblemGoesFromStandingToStanding) {
  const FootstepSkeleton skeleton = Skeleton(Curved());
  const RigidBodyProblem problem = Problem(skeleton);
  EXPECT_NO_THROW(CheckRigidBodyProblem(problem));
  EXPECT_EQ(problem.mass_kg, model_.total_mass_kg);
  EXPECT_NEAR(problem.duration_s, skeleton.schedule.end_s() - skeleton.schedule.start_s(), 1e-12);
  EXPECT_LT((problem.start.p_WC - CentreOfMass(model_, scratch_)).norm(), 1e-9);
  EXPECT_NEAR(problem.goal.angles_rad.z(), skeleton.goal.yaw_rad, 1e-6);
  EXPECT_GT(std::abs(skeleton.goal.yaw_rad), 0.1);
  int at_start = 0, at_end = 0;
  for (const RigidStance& stance : problem.stances) {
    const RigidFoot& foot = problem.feet[static_cast<std::size_t>(stance.foot)];
    const bool first = stance.start_s <= 0.0, last = stance.end_s >= problem.duration_s;
    EXPECT_EQ(stance.held, first || last);
    if (!first && !last) continue;
    (first ? at_start : at_end) += 1;
    const RigidBodyState& state = first ? problem.start : problem.goal;
    const Vector3 p_CF = RotationOf(state.angles_rad).transpose() * (stance.X_WF.translation() - state.p_WC);
    EXPECT_LT((p_CF - foot.p_CF_nominal_B).norm(), 2e-3) << "foot " << stance.foot << (first ? " first" : " last");
    EXPECT_EQ(state.v_WC.norm() + state.w_WB_B.norm(), 0.0);
  }
  EXPECT_EQ(at_start, static_cast<int>(model_.feet.size()));
  EXPECT_EQ(at_end, static_cast<int>(model_.feet.size()));
}

TEST_P(RobotBodyTest, StancesAreTheFootholdsOfTheSkeletonAndThePathIsItsPath) {
  const FootstepSkeleton skeleton = Skeleton(Curved());
  const RigidBodyProblem problem = Problem(skeleton);
  ASSERT_EQ(problem.stances.size(), skeleton.footsteps.footholds.size());
  for (std::size_t i = 0; i < problem.stances.size(); ++i) {
    const Foothold& foothold = skeleton.footsteps.footholds[i];
    EXPECT_EQ(problem.stances[i].foot, foothold.foot);
    EXPECT_NEAR(problem.stances[i].start_s, foothold.touchdown_s - skeleton.schedule.start_s(), 1e-12);
    EXPECT_NEAR(problem.stances[i].end_s, foothold.liftoff_s - skeleton.schedule.start_s(), 1e-12);
    EXPECT_TRUE(problem.stances[i].X_WF.isApprox(foothold.X_WF));
    EXPECT_EQ(problem.stances[i].friction, FlatTerrain().patches[0].friction);
  }
  EXPECT_LT((problem.path.p_WC.front() - problem.start.p_WC).norm(), 1e-12);
  EXPECT_LT((problem.path.p_WC.back() - problem.goal.p_WC).norm(), 1e-12);
  for (std::size_t k = 1; k < problem.path.time_s.size(); ++k)
    EXPECT_LE(problem.path.time_s[k] - problem.path.time_s[k - 1], 0.05 + 1e-9);
}

TEST_P(RobotBodyTest, OnGroundThatIsNotLevelFootholdsAreHeld) {
  const FootstepSkeleton skeleton = Skeleton(Curved());
  Terrain tiled = FlatTerrain();
  tiled.patches[0].outline_T = {{-5.0, -5.0}, {5.0, -5.0}, {5.0, 5.0}, {-5.0, 5.0}};
  for (const RigidStance& stance : Problem(skeleton, tiled).stances) EXPECT_TRUE(stance.held);
}

}  // namespace
}  // namespace gaitwright
