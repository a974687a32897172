// SPDX-License-Identifier: BSD-3-Clause
// The program of a build with GAITWRIGHT_VIEWER=OFF.
#include "tests/cli/stranger.h"

namespace gaitwright::cli {
namespace {

TEST_F(Stranger, ABuildWithoutTheViewerSaysSoAndHasTheRest) {
  ASSERT_EQ(Run({"walk", "--distance", "0.3", "--quiet", "--out-dir", "out"}).status, 0);
  EXPECT_EQ(Read("out/report.html").find("data-scene"), std::string::npos);
  const std::string why = "built without the viewer (GAITWRIGHT_VIEWER=OFF)";
  ExpectRefused(Run({"view", "out/log.json"}), 1, {why});
  ExpectRefused(Run({"render", "out/log.json", "--png", "p.png"}), 1, {why});
  ExpectRefused(Run({"live"}), 1, {why});
  EXPECT_EQ(Run({"render", "out/log.json", "--figure", "gait.svg", "--quiet"}).status, 0) << "which needs none";
}

}  // namespace
}  // namespace gaitwright::cli
