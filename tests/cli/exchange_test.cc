// SPDX-License-Identifier: BSD-3-Clause
// Files of one verb are read by another.
#include "tests/cli/exchanged.h"

namespace gaitwright::cli {
namespace {

TEST_F(Exchange, WhatIsExportedIsImportedAsTheSameMotion) {
  ASSERT_EQ(Run({"export", "out/plan.json", "--rate-hz", "500", "--out", "motion.csv", "--quiet"}).status, 0);
  const Ran imported = Run({"import", "motion.csv", "--robot", "a1", "--out", "again.json", "--quiet"});
  ASSERT_TRUE(imported.status == 0 || imported.status == 3) << imported.err;
  const Json c = Run({"compare", "out/plan.json", "again.json", "--json"}).json();
  EXPECT_NEAR(c.at("alignment").at("best_offset_s").get<double>(), 0.0, 2e-4);
  for (const auto& [joint, difference] : c.at("joints").items()) {
    EXPECT_LT(difference.at("position").at("largest"), 1e-3) << joint;
    EXPECT_LT(difference.at("speed").at("rms"), 0.05) << joint;
  }
  EXPECT_LT(c.at("base").at("x of the base").at("largest"), 1e-4);
  EXPECT_FALSE(c.at("words").empty()) << "who made them is not the same";
}

TEST_F(Exchange, TrajectoriesComeBackFromBothLanguages) {
  for (const char* language : {"yaml", "json"}) {
    const std::string file = std::string("trajectory.") + language;
    ASSERT_EQ(Run({"export", "out/plan.json", "--format", std::string("joint-trajectory-") + language, "--out", file,
                   "--quiet"})
                  .status,
              0);
    const Ran ran = Run({"import", file, "--robot", "a1", "--out", "again.json", "--json"});
    ASSERT_TRUE(ran.status == 0 || ran.status == 3) << ran.err;
    EXPECT_EQ(ran.json().at("format"), "joint-trajectory") << language;
  }
  Write("broken.json", Read("trajectory.json").substr(0, 2000));
  ExpectRefused(Run({"import", "broken.json", "--robot", "a1"}), 1, {"broken.json", "its JSON is cut short"});
}

}  // namespace
}  // namespace gaitwright::cli
