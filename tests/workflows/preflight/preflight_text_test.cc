// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/workflows/formats/fits_shape.h"
#include "tests/workflows/preflight/made_up_preflight.h"
#include "workflows/formats/result_shapes_internal.h"

namespace gaitwright {
namespace {

bool TextHas(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(PreflightTexts, TheVerdictIsFirstAndItsReasonsAreSections) {
  Preflight p = MakeUpPreflight();
  EXPECT_TRUE(PreflightText(p).starts_with("PREFLIGHT: GO\n"));
  EXPECT_FALSE(TextHas(PreflightText(p), "Reasons for no-go"));
  p.reasons = {"the knee is weak", "nobody tried it"};
  const std::string text = PreflightText(p);
  EXPECT_TRUE(text.starts_with("PREFLIGHT: NO-GO\n"));
  EXPECT_TRUE(TextHas(text, "Reasons for no-go\n  - the knee is weak\n  - nobody tried it\n")) << text;
}

TEST(PreflightTexts, BothHashesOfThePlanAndTheRobotsAreThere) {
  const std::string text = PreflightText(MakeUpPreflight());
  for (const char* hash : {"robot-hash", "motion-hash", "plan-hash"}) EXPECT_TRUE(TextHas(text, hash)) << hash;
  EXPECT_TRUE(TextHas(text, "2500 samples at 1000 Hz")) << text;
}

TEST(PreflightTexts, LimitsShowTheTightestOfEachCheck) {
  const std::string text = PreflightText(MakeUpPreflight());
  const std::string limits = text.substr(text.find("\nLimits"), text.find("\nMargins") - text.find("\nLimits"));
  EXPECT_TRUE(TextHas(limits, "5 N m (20 %) left at 0.500 s: knee, 20 N m of 25 N m")) << limits;
  EXPECT_FALSE(TextHas(limits, "hip")) << limits;
  EXPECT_TRUE(TextHas(limits, "0.3 left at 1.250 s: left")) << "no share of a limit that is no size";
}

TEST(PreflightTexts, TrialsHaveCountsCausesWorstAndConditions) {
  const std::string with = PreflightText(MakeUpPreflight(true)), without = PreflightText(MakeUpPreflight());
  EXPECT_TRUE(TextHas(without, "survival rate under disturbances is unknown")) << without;
  EXPECT_FALSE(TextHas(with, "is unknown"));
  for (const char* part : {"97 of 100 trials survived", "3 of the falls: tipped <over>", "worst: seed 42, base under",
                           "controller: stabilised", "play.friction", "      friction: <0.5>\n"})
    EXPECT_TRUE(TextHas(with, part)) << part << " in: " << with;
}

TEST(PreflightTexts, LinesToSignAreTheLastOnes) {
  const std::string text = PreflightText(MakeUpPreflight());
  EXPECT_TRUE(text.ends_with("Date ______________\n"));
  EXPECT_LT(text.find("Not checked\n  - the battery"), text.find("Signature"));
}

TEST(PreflightJsons, FitTheirShapeWithAndWithoutTrials) {
  for (const bool trials : {false, true}) {
    Preflight p = MakeUpPreflight(trials);
    const auto json = nlohmann::ordered_json::parse(PreflightJson(p, {{"report", "a.html"}}));
    EXPECT_EQ(Misfit(json, PreflightShape()), "") << trials;
    EXPECT_EQ(json.at("verdict"), "go");
    EXPECT_EQ(json.at("trials").is_null(), !trials);
    EXPECT_EQ(json.at("files").at("report"), "a.html");
    EXPECT_EQ(json.at("limits").size(), 2U);
    EXPECT_TRUE(json.at("limits")[1].at("share").is_null());
  }
}

}  // namespace
}  // namespace gaitwright
