// SPDX-License-Identifier: BSD-3-Clause
// Provenance in plans and logs is sufficient to reproduce them.
#include <gtest/gtest.h>

#include <filesystem>

#include "kinematics/base/file.h"
#include "kinematics/base/version.h"
#include "kinematics/model/load_robot.h"
#include "planning/plan/plan_json.h"
#include "playback/log/log_json.h"
#include "tests/scratch_folder.h"
#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

const RobotModel& Robot() {
  static const RobotModel model = *LoadNamedRobot("a1");
  return model;
}

MotionPlan Planned(WalkRequest request = {}) {
  request.command.distance_m = 0.1;
  return PlanWalk(Robot(), request)->motion.plan;
}

PlaybackLog Played(const MotionPlan& plan, double dcm_gain) {
  PlayRequest request;
  request.stabilised.dcm_gain = dcm_gain;
  return PlayWalk(Robot(), plan, request)->log;
}

std::string At(const OptionTexts& texts, const std::string& key) {
  for (const auto& [name, text] : texts) {
    if (name == key) return text;
  }
  ADD_FAILURE() << "no '" << key << "'";
  return "";
}

TEST(LogProvenance, HasEveryOptionOfThePlayback) {
  const MotionPlan plan = Planned();
  const PlaybackLog log = Played(plan, 1.5);
  EXPECT_EQ(log.program_version, Version());
  EXPECT_EQ(log.controller, "stabilised");
  EXPECT_EQ(log.plan_hash, MotionHash(plan));
  PlayRequest request;
  for (const OptionField& field : request.Fields())
    EXPECT_EQ(At(log.options, field.key), field.key == "stabilised.dcm_gain" ? "1.5" : OptionText(field));
  EXPECT_EQ(log.options.size(), request.Fields().size());
  EXPECT_EQ(LogFromJson(LogToJson(log), "log")->options, log.options);
}

TEST(LogProvenance, AnOptionOfTheControllerIsSeenAndTheSameTwiceIsTheSameBytes) {
  const MotionPlan plan = Planned();
  const PlaybackLog one = Played(plan, 1.3), other = Played(plan, 1.5);
  EXPECT_NE(one.options, other.options);
  EXPECT_EQ(LogToJson(one), LogToJson(Played(plan, 1.3)));
}

TEST(PlanProvenance, HasWhatWasAskedForAndEveryOption) {
  WalkRequest request;
  request.gait = "trot";
  request.seed = 7;
  request.motion.swing.height_m = 0.05;
  const MotionPlan plan = Planned(request);
  const Provenance& p = plan.provenance;
  EXPECT_EQ(p.program_version, Version());
  EXPECT_EQ(p.seed, 7U);
  EXPECT_EQ(At(p.options, "gait"), "trot");
  EXPECT_EQ(At(p.options, "terrain"), "flat");
  EXPECT_EQ(At(p.options, "sequence"), "");
  for (const OptionField& field : request.Fields()) EXPECT_EQ(At(p.options, field.key), OptionText(field));
  EXPECT_EQ(p.options.size(), request.Fields().size() + 3);
  EXPECT_EQ(PlanFromJson(PlanToJson(plan), "plan")->provenance, p);
}

TEST(PlanProvenance, AGaitFileIsNamedWithoutItsFolder) {
  const std::filesystem::path folder = ScratchFile("provenance");
  const std::string path = (folder / "mine.yaml").string();
  ASSERT_TRUE(WriteFileAtomically(path,
                                  "mine:\n  feet: 4\n  cycle_s: 0.5\n  duty_factor: 0.6\n"
                                  "  phase: [0.0, 0.5, 0.5, 0.0]\n  description: diagonal pairs\n"));
  WalkRequest request;
  request.gait = path;
  const MotionPlan plan = Planned(request);
  std::filesystem::remove_all(folder);
  EXPECT_EQ(plan.parts.front().gait.name, "mine");
  EXPECT_EQ(At(plan.provenance.options, "gait"), "mine.yaml");
  EXPECT_EQ(PlanToJson(plan).find(folder.string()), std::string::npos);
}

TEST(ChangedOptions, AreThoseOfPlanAndPlaybackThatWereSet) {
  WalkRequest walk;
  walk.gait = "trot";
  walk.motion.pipeline.max_passes = 3;
  const MotionPlan plan = Planned(walk);
  const std::vector<OptionChange> expected = {
      {"gait", "trot", ""}, {"pipeline.max_passes", "3", "6"}, {"stabilised.dcm_gain", "1.5", "1.3"}};
  EXPECT_EQ(ChangedOptions(plan, Played(plan, 1.5)), expected);
  const MotionPlan usual = Planned();
  EXPECT_TRUE(ChangedOptions(usual, Played(usual, StabilisedOptions{}.dcm_gain)).empty());
}

}  // namespace
}  // namespace gaitwright
