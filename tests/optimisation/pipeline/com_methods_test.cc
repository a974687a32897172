// SPDX-License-Identifier: BSD-3-Clause
// Three methods for the centre of mass with one gait: each passes the audit, and they agree.
#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"
#include "optimisation/pipeline/plan_motion.h"
#include "planning/audit/audit.h"
#include "planning/gait/find_gait.h"

namespace gaitwright {
namespace {

struct Walk {
  std::string robot;
  WalkCommand command;
};

std::vector<Walk> Walks() {
  WalkCommand nao;
  nao.extent = WalkCommand::Extent::kSteps;
  nao.steps = 4;
  nao.step_length_m = 0.04;
  WalkCommand a1;
  a1.speed_m_s = 0.3;
  a1.distance_m = 0.6;
  return {{"nao", nao}, {"a1", a1}};
}

MotionPlan Planned(const RobotModel& model, const WalkCommand& command, const std::string& method,
                   const std::string& name = "") {
  MotionOptions options;
  options.centre_of_mass.method = method;
  const Result<Gait> gait = FindGait(model, name, CommandedSpeed(model, command), {});
  const Result<PlannedMotion> motion = PlanMotion(model, FlatTerrain(), *gait, command, options);
  EXPECT_TRUE(motion.ok()) << method << ": " << motion.failure().message;
  return motion->plan;
}

TEST(ComMethods, EachPassesTheAuditAndEndsAtRest) {
  for (const Walk& walk : Walks()) {
    const RobotModel model = *LoadNamedRobot(walk.robot);
    for (const std::string method : {"optimised", "closed-form", "preview"}) {
      const MotionPlan plan = Planned(model, walk.command, method);
      const Result<AuditReport> audit = Audit(model, plan, {});
      ASSERT_TRUE(audit.ok());
      EXPECT_TRUE(audit->pass()) << walk.robot << " " << method << "\n" << AuditText(*audit);
      for (const auto& end : {plan.centroidal.v_WC.front(), plan.centroidal.v_WC.back()}) EXPECT_LT(end.norm(), 1e-6);
      for (const auto& end : {plan.centroidal.a_WC.front(), plan.centroidal.a_WC.back()}) EXPECT_LT(end.norm(), 0.01);
    }
  }
}

/// With supports without area, on whose edge the ZMP changes to supports with area: no sample may be outside of them.
TEST(ComMethods, EveryGaitWithoutFlightPassesTheAudit) {
  const RobotModel a1 = *LoadNamedRobot("a1");
  for (const std::string gait : {"crawl", "amble", "trot", "pace"}) {
    for (const std::string method : {"optimised", "closed-form", "preview"}) {
      for (const double speed : {0.1, 0.3}) {
        WalkCommand command;
        command.speed_m_s = speed;
        command.distance_m = 2.0 * speed;
        const Result<AuditReport> audit = Audit(a1, Planned(a1, command, method, gait), {});
        ASSERT_TRUE(audit.ok());
        EXPECT_TRUE(audit->pass()) << gait << " " << method << " " << speed << " m/s\n" << AuditText(*audit);
      }
    }
  }
}

TEST(ComMethods, PreviewGoesWhereOptimisationGoes) {
  const double preview_s = CentreOfMassOptions().preview_s;
  for (const Walk& walk : Walks()) {
    const RobotModel model = *LoadNamedRobot(walk.robot);
    const CentroidalTrajectory optimised = Planned(model, walk.command, "optimised").centroidal;
    const CentroidalTrajectory preview = Planned(model, walk.command, "preview").centroidal;
    // Preview control stands longer by one preview horizon at both ends.
    const auto shift = static_cast<std::size_t>(std::lround(preview_s / preview.step_s));
    ASSERT_EQ(preview.p_WC.size(), optimised.p_WC.size() + 2 * shift);
    double apart = 0.0;
    for (std::size_t k = 0; k < optimised.p_WC.size(); ++k) {
      apart = std::max(apart, (optimised.p_WC[k] - preview.p_WC[k + shift]).norm());
    }
    EXPECT_GT(apart, 1e-5) << "they are two roads";
    EXPECT_LT(apart, 0.015) << walk.robot;
    RecordProperty(walk.robot + "_apart_mm", std::to_string(1e3 * apart));
  }
}

TEST(ComMethods, TheMethodIsInTheProvenance) {
  const RobotModel model = *LoadNamedRobot("nao");
  const MotionPlan plan = Planned(model, Walks()[0].command, "preview");
  const auto& options = plan.provenance.options;
  const auto has = [&](const std::string& key, const std::string& value) {
    return std::find(options.begin(), options.end(), std::pair{key, value}) != options.end();
  };
  EXPECT_TRUE(has("centre_of_mass.method", "preview"));
  // Options are stored as given: the time that preview control adds is not added again when the plan is made again.
  EXPECT_TRUE(has("footsteps.initial_stand_s", "0.8"));
}

}  // namespace
}  // namespace gaitwright
