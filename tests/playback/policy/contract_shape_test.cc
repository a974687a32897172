// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "playback/policy/contract_internal.h"
#include "playback/policy/observations_internal.h"

namespace gaitwright {
namespace {

TEST(ContractShapeTest, HasEveryObservation) {
  const std::vector<std::string> keys = ContractShape().At("observations").Keys();
  for (const std::string& name : ObservationNames()) EXPECT_NE(std::find(keys.begin(), keys.end(), name), keys.end());
}

TEST(ContractShapeTest, NeedsWhatAPolicyCannotRunWithout) {
  const std::vector<std::string> needed = ContractShape().NeededKeys();
  for (const char* key : {"step_dt", "stiffness", "damping", "default_joint_pos", "actions", "observations"})
    EXPECT_NE(std::find(needed.begin(), needed.end(), key), needed.end()) << key;
}

}  // namespace
}  // namespace gaitwright
