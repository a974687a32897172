// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/motion_file.h"

#include <gtest/gtest.h>

#include <set>

namespace gaitwright {
namespace {

struct FileText {
  std::string text;
  MotionFileKind kind;
};

class KindsOfFiles : public testing::TestWithParam<FileText> {};

TEST_P(KindsOfFiles, AreFoundInTheText) { EXPECT_EQ(KindOfText(GetParam().text), GetParam().kind) << GetParam().text; }

using FileKind = MotionFileKind;

INSTANTIATE_TEST_SUITE_P(
    Json, KindsOfFiles,
    testing::Values(FileText{R"({"format": "gaitwright-motion-plan", "schema": 1})", FileKind::kPlan},
                    FileText{" \r\n\t{\"format\":\"gaitwright-playback-log\"}", FileKind::kLog},
                    FileText{R"({"metrics": {}, "verdict": "pass"})", FileKind::kReport},
                    FileText{R"({"verdict": "pass", "plan": {"n": 1}, "metrics": []})", FileKind::kReport},
                    FileText{R"({"n": 10, "survived": 9, "survival": {}})", FileKind::kTrials},
                    FileText{R"({"joint_names": ["a"], "points": []})", FileKind::kTrajectory},
                    FileText{R"({"trajectory": {"joint_names": ["a"]}})", FileKind::kTrajectory},
                    FileText{R"({"metrics": {}})", FileKind::kJson}, FileText{"{}", FileKind::kJson},
                    FileText{R"({"format": "of-somebody-else", "metrics": {}, "verdict": "pass"})", FileKind::kJson}));
/// A key counts only in the outermost object, and a value does not count as a key.
INSTANTIATE_TEST_SUITE_P(
    NestedKeys, KindsOfFiles,
    testing::Values(FileText{R"({"inner": {"format": "gaitwright-motion-plan"}})", FileKind::kJson},
                    FileText{R"({"inner": {"metrics": 1, "verdict": 2}})", FileKind::kJson},
                    FileText{R"({"other": {"joint_names": ["a"]}})", FileKind::kJson},
                    FileText{R"({"title": "format", "note": "gaitwright-motion-plan"})", FileKind::kJson},
                    FileText{R"({"list": [{"format": "gaitwright-playback-log"}]})", FileKind::kJson}));
/// The start of a truncated file decides its kind; the reader reports the truncation.
INSTANTIATE_TEST_SUITE_P(BrokenOff, KindsOfFiles,
                         testing::Values(FileText{R"({"format": "gaitwright-motion-plan", "q": [1,)", FileKind::kPlan},
                                         FileText{R"({"joint_names": [)", FileKind::kTrajectory},
                                         FileText{"{", FileKind::kJson}, FileText{R"({"format": )", FileKind::kJson}));
INSTANTIATE_TEST_SUITE_P(NoJson, KindsOfFiles,
                         testing::Values(FileText{"", FileKind::kTable}, FileText{" \n", FileKind::kTable},
                                         FileText{"time_s,x\n0,1\n", FileKind::kTable},
                                         FileText{"joint_names: [a]\npoints: []\n", FileKind::kTrajectory},
                                         FileText{"header: {}\n  joint_names: [a]\n", FileKind::kTrajectory},
                                         FileText{"x, joint_names: y\n", FileKind::kTable},
                                         FileText{"[1, 2]", FileKind::kTable}));

TEST(MotionFile, EachKindHasANameOfItsOwn) {
  std::set<std::string> names;
  for (const MotionFileKind kind : {FileKind::kPlan, FileKind::kLog, FileKind::kReport, FileKind::kTrials,
                                    FileKind::kJson, FileKind::kTable, FileKind::kTrajectory})
    EXPECT_TRUE(names.insert(NameOf(kind)).second) << NameOf(kind);
}

}  // namespace
}  // namespace gaitwright
