// SPDX-License-Identifier: BSD-3-Clause
#include "playback/sensing/sensor_options.h"

#include <gtest/gtest.h>

#include <set>

namespace gaitwright {
namespace {

TEST(SensorOptionFields, EachIsAMemberOfItsOwnAndNoneIsForgotten) {
  SensorOptions options;
  std::set<const void*> targets;
  std::set<std::string> keys;
  for (const OptionField& field : options.Fields()) {
    keys.insert(field.key);
    targets.insert(std::visit([](auto* target) { return static_cast<const void*>(target); }, field.target));
  }
  const std::size_t numbers = 21;  // without the seed, which fits into padding
  EXPECT_EQ(keys.size(), numbers + 1);
  EXPECT_EQ(targets.size(), keys.size());
  EXPECT_LT(sizeof(SensorOptions), (numbers + 2) * sizeof(double)) << "a new member needs a field";
}

TEST(SensorOptionFields, AnyOneThatIsSetMakesAnotherSensor) {
  const OptionFields fields = SensorOptions().Fields();
  for (const OptionField& field : fields) {
    SensorOptions options;
    OptionFields own = options.Fields();
    SetOption(own, field.key, field.key == "seed" ? "5" : "0.05");
    EXPECT_FALSE(options == SensorOptions()) << field.key;
    EXPECT_THROW(SetOption(own, field.key, "-1"), InvalidArgument) << field.key;
  }
}

TEST(SensorOptionFields, DelaysReachTheLongestAndNoFurther) {
  for (const char* key : {"encoder_delay_s", "imu_delay_s", "contact_delay_s"}) {
    SensorOptions options;
    OptionFields fields = options.Fields();
    EXPECT_NO_THROW(SetOption(fields, key, std::to_string(kLongestDelay)));
    EXPECT_THROW(SetOption(fields, key, std::to_string(1.01 * kLongestDelay)), InvalidArgument);
  }
}

TEST(SensorOptionSets, CheaperSensorsAreNoisier) {
  const SensorOptions good = SensorsOfKind("good"), hobby = SensorsOfKind("hobby");
  for (const auto figure : {&SensorOptions::encoder_noise_rad, &SensorOptions::gyroscope_noise_rad_s_sqrt_hz,
                            &SensorOptions::gyroscope_bias_rad_s, &SensorOptions::gyroscope_walk_rad_s2_sqrt_hz,
                            &SensorOptions::accelerometer_noise_m_s2_sqrt_hz, &SensorOptions::accelerometer_bias_m_s2,
                            &SensorOptions::accelerometer_walk_m_s3_sqrt_hz, &SensorOptions::contact_noise}) {
    EXPECT_GT(good.*figure, 0.0);
    EXPECT_GT(hobby.*figure, good.*figure);
  }
  for (const auto bandwidth : {&SensorOptions::speed_cutoff_hz, &SensorOptions::gyroscope_cutoff_hz}) {
    EXPECT_GT(hobby.*bandwidth, 0.0);
    EXPECT_LT(hobby.*bandwidth, good.*bandwidth);
  }
}

TEST(SensorOptionNames, AreInTheOrderOfTheirEnumerations) {
  EXPECT_EQ(StateSourceOf("true"), StateSource::kTrue);
  EXPECT_EQ(StateSourceOf("measured"), StateSource::kMeasured);
  EXPECT_EQ(DriveLoopOf("own"), DriveLoop::kOwn);
  EXPECT_EQ(DriveLoopOf("sensed"), DriveLoop::kSensed);
  for (std::size_t i = 0; i < StateSourceNames().size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(StateSourceOf(StateSourceNames()[i])), i);
  }
}

TEST(SensorOptionNames, ThatAreNotKnownAreRefusedWithThoseThatAre) {
  const auto refused = [](const auto& read, const std::string& name, const std::vector<std::string>& known) {
    try {
      read(name);
      ADD_FAILURE() << name << " is accepted";
    } catch (const InvalidArgument& error) {
      EXPECT_NE(std::string(error.what()).find("'" + name + "'"), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(QuotedList(known)), std::string::npos) << error.what();
    }
  };
  for (const char* name : {"", "True", "own "}) {
    refused(SensorsOfKind, name, SensorKinds());
    refused(StateSourceOf, name, StateSourceNames());
    refused(DriveLoopOf, name, DriveLoopNames());
  }
}

}  // namespace
}  // namespace gaitwright
