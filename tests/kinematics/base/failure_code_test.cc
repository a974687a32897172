// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/base/failure_code.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace gaitwright {
namespace {

TEST(FailureCode, NamesAreOfOneCodeEachAndInOrder) {
  const std::vector<std::string>& names = FailureCodeNames();
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto code = static_cast<FailureCode>(i);
    EXPECT_EQ(FailureCodeName(code), names[i]);
    EXPECT_EQ(FailureCodeOfName(names[i]), code);
    EXPECT_EQ(names[i].find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"), std::string::npos) << names[i];
  }
  EXPECT_EQ(FailureCodeName(FailureCode::kUrdfLoop), "urdf_loop");
  EXPECT_EQ(FailureCodeName(FailureCode::kNo3d), "no_3d");
  EXPECT_EQ(FailureCodeOfName("no_such_code"), std::nullopt);
  EXPECT_EQ(FailureCodeOfName(""), std::nullopt);
}

TEST(FailureCode, EachLawHasACodeOfItsName) {
  for (const Law law : AllLaws()) {
    std::ostringstream out;
    out << FailureCodeOf(law);
    EXPECT_EQ(out.str(), LawName(law));
  }
}

}  // namespace
}  // namespace gaitwright
