// SPDX-License-Identifier: BSD-3-Clause
#include "playback/log/check_log.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "tests/playback/played.h"

namespace gaitwright {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
constexpr double kEndless = std::numeric_limits<double>::infinity();

PlaybackLog CheckedLog() {
  PlaybackLog log = synthetic::Stood().log;
  log.pushes = {{{10.0, 0.0, 0.0}, 0.2, 0.1, "base"}};
  log.samples[4].estimate = BaseEstimate();
  return log;
}

struct Spoilt {
  const char* name;
  std::function<void(PlaybackLog&)> spoil;
  std::vector<std::string> figures;  ///< words in the refusal; empty if the log is accepted
};

void PrintTo(const Spoilt& spoilt, std::ostream* out) { *out << spoilt.name; }

class CheckLogTest : public testing::TestWithParam<Spoilt> {};

TEST_P(CheckLogTest, RefusesWhatCannotBeWithKeyRowAndValue) {
  PlaybackLog log = CheckedLog();
  ASSERT_NO_THROW(CheckLog(log));
  GetParam().spoil(log);
  if (GetParam().figures.empty()) {
    EXPECT_NO_THROW(CheckLog(log));
    return;
  }
  try {
    CheckLog(log);
    FAIL() << "it is accepted";
  } catch (const InvalidArgument& error) {
    for (const std::string& figure : GetParam().figures) {
      EXPECT_TRUE(synthetic::Says(error.what(), figure)) << figure << " in: " << error.what();
    }
  }
}

using Log = PlaybackLog;

INSTANTIATE_TEST_SUITE_P(
    Head, CheckLogTest,
    testing::Values(Spoilt{"start", [](Log& l) { l.start_s = 2e6; }, {"'start_s'", "2000000"}},
                    Spoilt{"rate", [](Log& l) { l.log_rate_hz = 0.0; }, {"'log_rate_hz'", "is 0;"}},
                    Spoilt{"step", [](Log& l) { l.step_s = -0.001; }, {"'step_s'", "-0.001"}},
                    Spoilt{"mass", [](Log& l) { l.total_mass_kg = kNoNumber; }, {"'total_mass_kg'", "nan"}},
                    Spoilt{"noFriction", [](Log& l) { l.friction = 0.0; }, {}},
                    Spoilt{"friction", [](Log& l) { l.friction = -1e-9; }, {"'friction'", "-1e-09"}},
                    Spoilt{"saturated", [](Log& l) { l.saturated_s[1] = -0.5; }, {"'saturated_s'", "-0.5"}},
                    Spoilt{"bodyContact",
                           [](Log& l) {
                             l.body_contacts = {{kNoNumber, "trunk"}};
                           },
                           {"body_contacts", "nan"}},
                    Spoilt{"pushTime", [](Log& l) { l.pushes[0].at_s = kEndless; }, {"pushes, at_s", "inf"}},
                    Spoilt{"pushForNoTime", [](Log& l) { l.pushes[0].for_s = 0.0; }, {}},
                    Spoilt{"pushBackward", [](Log& l) { l.pushes[0].for_s = -0.1; }, {"pushes, for_s", "-0.1"}},
                    Spoilt{
                        "pushForce", [](Log& l) { l.pushes[0].force_W.z() = kNoNumber; }, {"pushes, force_n", "nan"}}),
    [](const auto& one) { return std::string(one.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Samples, CheckLogTest,
    testing::Values(
        Spoilt{"sameTime", [](Log& l) { l.samples[3].time_s = l.samples[2].time_s; }, {"row 3", "'time_s'", "0.01,"}},
        Spoilt{"timeWithoutNumber", [](Log& l) { l.samples[3].time_s = kNoNumber; }, {"'time_s'", "nan"}},
        Spoilt{"q", [](Log& l) { l.samples[5].q[9] = kNoNumber; }, {"row 5", "'q'", "nan"}},
        Spoilt{"v", [](Log& l) { l.samples[6].v[0] = -kEndless; }, {"row 6", "'v'", "-inf"}},
        Spoilt{"tau", [](Log& l) { l.samples[7].tau[0] = 2e12; }, {"row 7", "'tau_nm'", "2000000000000"}},
        Spoilt{"peak", [](Log& l) { l.samples[8].tau_peak[2] = kNoNumber; }, {"row 8", "'tau_peak_nm'"}},
        Spoilt{"force", [](Log& l) { l.samples[9].wrenches[1].force_W.y() = kNoNumber; }, {"row 9", "wrenches"}},
        Spoilt{"moment", [](Log& l) { l.samples[2].wrenches[0].moment_W.x() = kNoNumber; }, {"row 2", "wrenches"}},
        Spoilt{"fullEffort", [](Log& l) { l.samples[0].effort_use[0] = 1.0; }, {}},
        Spoilt{"effort", [](Log& l) { l.samples[0].effort_use[0] = 1.0 + 1e-9; }, {"'effort_use'", "0 to 1"}},
        Spoilt{"nearlyUnit", [](Log& l) { l.samples[1].q.segment<4>(3) *= 1.0009; }, {}},
        Spoilt{"notUnit", [](Log& l) { l.samples[1].q.segment<4>(3) *= 0.998; }, {"row 1", "'q'", "0.998"}},
        Spoilt{"noTurn", [](Log& l) { l.samples[1].q.segment<4>(3).setZero(); }, {"row 1", "'q'", "length 0"}},
        Spoilt{"bothFeet", [](Log& l) { l.samples[1].contact = 0b11; }, {}},
        Spoilt{"thirdFoot", [](Log& l) { l.samples[1].contact = 0b100; }, {"row 1", "'contact'", "is 4", "2 feet"}},
        Spoilt{"estimate", [](Log& l) { l.samples[4].estimate->v_WB.x() = kNoNumber; }, {"row 4", "'estimate'"}},
        Spoilt{"estimateTurn", [](Log& l) { l.samples[4].estimate->R_WB.coeffs() *= 2.0; }, {"row 4", "length 2"}},
        Spoilt{"manyFeet", [](Log& l) { l.samples[0].wrenches.resize(65); }, {"'contact_wrenches'", "65", "64"}}),
    [](const auto& one) { return std::string(one.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Stances, CheckLogTest,
    testing::Values(
        Spoilt{"thirdFoot", [](Log& l) { l.stances[0].foot = 2; }, {"'stances, foot'", "is 2", "0 to 1"}},
        Spoilt{"negativeFoot", [](Log& l) { l.stances[0].foot = -1; }, {"'stances, foot'", "is -1"}},
        Spoilt{"noSamples", [](Log& l) { l.samples.clear(), l.stances[0].foot = 7; }, {}},
        Spoilt{"touchAndGo", [](Log& l) { l.stances[0].liftoff_s = l.stances[0].touchdown_s; }, {}},
        Spoilt{"backward", [](Log& l) { l.stances[1].touchdown_s = 2.0; }, {"'stances, liftoff_s' is 1", "2 to"}},
        Spoilt{"place", [](Log& l) { l.stances[1].p_touchdown_W.z() = kNoNumber; }, {"touchdown_m", "nan"}},
        Spoilt{"slip", [](Log& l) { l.stances[1].slip_m = kNoNumber; }, {"'stances'", "nan"}},
        Spoilt{"frictionUse", [](Log& l) { l.stances[1].friction_use_max = kEndless; }, {"'stances'", "inf"}}),
    [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace gaitwright
