// SPDX-License-Identifier: BSD-3-Clause
#include "playback/score/agreement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/playback/synthetic.h"

namespace gaitwright {
namespace {

class AgreementTest : public testing::Test {
 protected:
  const QuantityAgreement& Of(const Agreement& agreement, const std::string& quantity) const {
    const auto found = std::find_if(agreement.quantities.begin(), agreement.quantities.end(),
                                    [&](const QuantityAgreement& one) { return one.quantity == quantity; });
    EXPECT_NE(found, agreement.quantities.end()) << quantity;
    return *found;
  }

  Agreement With(const PlaybackLog& other) const { return AgreementOf(model_, plan_, log_, other); }

  const RobotModel model_ = synthetic::Robot(2, FootType::kSole);
  const MotionPlan plan_ = synthetic::SteppingPlan(model_);
  const PlaybackLog log_ = synthetic::PerfectLog(model_, plan_);
};

TEST_F(AgreementTest, APlaybackAgreesWithItself) {
  const Agreement agreement = With(log_);
  EXPECT_EQ(agreement.first(), nullptr);
  EXPECT_EQ(agreement.samples, static_cast<int>(log_.samples.size()));
  EXPECT_EQ(agreement.quantities.size(), 3 * model_.feet.size() + 8);
  for (const QuantityAgreement& one : agreement.quantities) {
    EXPECT_EQ(one.largest, 0.0) << one.quantity;
    EXPECT_EQ(one.rms, 0.0) << one.quantity;
    EXPECT_GT(one.tolerance, 0.0) << one.quantity;
  }
}

TEST_F(AgreementTest, ABaseThatDriftsPartsWhereItPassesTheTolerance) {
  constexpr double kRate_m_s = 0.05;
  PlaybackLog drifting = log_;
  for (LogSample& sample : drifting.samples) sample.q[1] += kRate_m_s * (sample.time_s - log_.start_s);
  const Agreement agreement = With(drifting);
  const QuantityAgreement& y = Of(agreement, "base y");
  ASSERT_TRUE(y.parts_s.has_value());
  EXPECT_NEAR(*y.parts_s - log_.start_s, y.tolerance / kRate_m_s, 2.0 / log_.log_rate_hz);
  EXPECT_NEAR(y.b - y.a, y.tolerance, 2.0 * kRate_m_s / log_.log_rate_hz);
  const double end_s = log_.samples.back().time_s;
  EXPECT_NEAR(y.largest, kRate_m_s * (end_s - log_.start_s), 1e-9);
  EXPECT_EQ(y.at_s, end_s);
  EXPECT_NEAR(y.rms, y.largest / std::sqrt(3.0), 0.01 * y.largest);
  EXPECT_FALSE(Of(agreement, "base x").parts_s.has_value());
}

TEST_F(AgreementTest, TheEarliestQuantityIsFirst) {
  PlaybackLog other = log_;
  const std::size_t middle = other.samples.size() / 2;
  for (std::size_t k = middle; k < other.samples.size(); ++k) {
    other.samples[k].q[2] += 1.0;
    if (k < middle + 40) continue;
    other.samples[k].q[0] += 1.0;
  }
  const Agreement agreement = With(other);
  ASSERT_NE(agreement.first(), nullptr);
  EXPECT_EQ(agreement.first()->quantity, "base z");
  EXPECT_EQ(*agreement.first()->parts_s, other.samples[middle].time_s);
}

TEST_F(AgreementTest, ForcesAreMeansSoThatASpikeDoesNotCount) {
  PlaybackLog other = log_;
  const auto loaded = [](const LogSample& s) { return !s.wrenches.empty() && s.wrenches[0].force_W.z() > 0.0; };
  const auto spiked = std::find_if(other.samples.begin() + 20, other.samples.end(), loaded);
  ASSERT_NE(spiked, other.samples.end());
  spiked->wrenches[0].force_W.z() += model_.weight_n();
  const std::string name = "normal force of " + model_.feet[0].name;
  EXPECT_FALSE(Of(With(other), name).parts_s.has_value());
  for (auto sample = spiked; sample != other.samples.end() && sample < spiked + 20; ++sample) {
    if (loaded(*sample)) sample->wrenches[0].force_W.z() += model_.weight_n();
  }
  EXPECT_TRUE(Of(With(other), name).parts_s.has_value());
}

TEST_F(AgreementTest, OnlyTheSharedTimeCounts) {
  PlaybackLog fallen = log_;
  fallen.samples.resize(fallen.samples.size() / 2);
  const Agreement agreement = With(fallen);
  EXPECT_EQ(agreement.first(), nullptr);
  EXPECT_EQ(agreement.end_s, fallen.samples.back().time_s);
  EXPECT_EQ(agreement.samples, static_cast<int>(fallen.samples.size()));
}

TEST_F(AgreementTest, LogsOfDifferentRatesAreInterpolated) {
  PlaybackLog coarse = log_;
  std::vector<LogSample> kept;
  for (std::size_t k = 0; k < coarse.samples.size(); k += 2) kept.push_back(coarse.samples[k]);
  coarse.samples = kept;
  coarse.log_rate_hz *= 0.5;
  const Agreement agreement = With(coarse);
  EXPECT_LT(Of(agreement, "base x").largest, 1e-3);
  EXPECT_LT(Of(agreement, "base yaw").largest, 1e-3);
}

TEST_F(AgreementTest, YawThatTurnsPastPiIsOneTurn) {
  PlaybackLog a = log_, b = log_;
  for (std::size_t k = 0; k < a.samples.size(); ++k) {
    const double yaw = 3.0 + 0.3 * static_cast<double>(k) / static_cast<double>(a.samples.size());
    a.samples[k].q.segment<4>(3) = Quaternion(Eigen::AngleAxisd(yaw, Vector3::UnitZ())).coeffs();
    b.samples[k].q.segment<4>(3) = Quaternion(Eigen::AngleAxisd(yaw + 0.01, Vector3::UnitZ())).coeffs();
  }
  const Agreement agreement = AgreementOf(model_, plan_, a, b);
  EXPECT_NEAR(Of(agreement, "base yaw").largest, 0.01, 1e-9);
}

TEST_F(AgreementTest, JsonHasTheEnginesAndTheFirstQuantity) {
  PlaybackLog other = log_;
  other.options = {{"play.engine", "mujoco"}};
  for (LogSample& sample : other.samples) sample.q[2] += 1.0;
  EXPECT_EQ(EngineOf(log_), "bullet");
  EXPECT_EQ(EngineOf(other), "mujoco");
  const auto json = nlohmann::json::parse(AgreementJson(With(other)));
  EXPECT_EQ(json.at("engines"), (nlohmann::json{"bullet", "mujoco"}));
  EXPECT_EQ(json.at("agree"), false);
  EXPECT_EQ(json.at("first").at("quantity"), "base z");
  EXPECT_EQ(json.at("quantities").size(), 3 * model_.feet.size() + 8);
  const auto same = nlohmann::json::parse(AgreementJson(With(log_)));
  EXPECT_EQ(same.at("agree"), true);
  EXPECT_TRUE(same.at("first").is_null());
}

}  // namespace
}  // namespace gaitwright
