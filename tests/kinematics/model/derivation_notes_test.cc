// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "kinematics/model/apply_yaml.h"
#include "tests/kinematics/made_robots.h"
#include "tests/kinematics/model/small_urdf.h"
#include "tests/unusual_robots.h"

namespace gaitwright {
namespace {

/// Number of notes that contain all parts.
long NotesWith(const std::vector<std::string>& notes, const std::vector<std::string>& parts) {
  return std::count_if(notes.begin(), notes.end(), [&](const std::string& note) {
    return std::all_of(parts.begin(), parts.end(),
                       [&](const auto& part) { return note.find(part) != std::string::npos; });
  });
}

std::vector<std::string> NotesOfLoaded(const std::string& urdf, const std::string& yaml = "") {
  const Result<RobotModel> model = LoadRobotFromText(urdf, yaml);
  EXPECT_TRUE(model.ok()) << (model.ok() ? "" : model.failure().message);
  return model.ok() ? model->notes : std::vector<std::string>();
}

TEST(DerivationNotes, EachLegHasItsFootLengthAndKneeAndEachPairOnce) {
  const RobotModel model = *LoadRobotFromText(FourLegs(), "");
  const std::vector<std::string> notes = DerivationNotes({}, model);
  for (const Leg& leg : model.legs) {
    EXPECT_EQ(NotesWith(notes, {"foot '" + leg.name + "':"}), 1) << leg.name;
    EXPECT_EQ(NotesWith(notes, {"leg '" + leg.name + "':", "m long"}), 1) << leg.name;
    EXPECT_EQ(NotesWith(notes, {"leg '" + leg.name + "': its knee is"}), 1) << leg.name;
  }
  EXPECT_EQ(NotesWith(notes, {"mirror each other"}), 2);
  EXPECT_EQ(NotesWith(notes, {"has no mirrored leg"}), 0);
  EXPECT_EQ(NotesWith(NotesOfLoaded(unusual::Tripod()), {"has no mirrored leg"}), 1);
}

TEST(DerivationNotes, WhatComesFromTheFileIsSaidToDoSo) {
  const std::string key = "robot.yaml";
  const std::vector<std::string> plain = NotesOfLoaded(FourLegs());
  EXPECT_EQ(NotesWith(plain, {key}), 0);
  const std::vector<std::string> given =
      NotesOfLoaded(FourLegs(),
                    "nominal_speed_m_s: 0.2\nlegs: {A_foot: {knee_side: minus}}\nlimits: {B_hip: {effort_nm: 20}}\n"
                    "gains: {C_hip: {stiffness_nm_rad: 50}}\nmirror_pairs: [[A_foot, B_foot], [C_foot, D_foot]]\n");
  for (const std::vector<std::string>& parts : std::vector<std::vector<std::string>>{{"default speed 0.200", key},
                                                                                     {"'A_foot'", "minus", key},
                                                                                     {"limits of 'B_hip'", key},
                                                                                     {"gains of 'C_hip'", key}})
    EXPECT_EQ(NotesWith(given, parts), 1) << parts[0];
  EXPECT_EQ(NotesWith(given, {"mirror each other", key}), 2);
}

TEST(DerivationNotes, PlaceholdersAreNamedByTheirJoint) {
  const std::string urdf = Replaced(FourLegs(), "effort='30' velocity='20'", "effort='5000' velocity='20'");
  const std::vector<std::string> notes = NotesOfLoaded(urdf);
  EXPECT_EQ(NotesWith(notes, {"effort limit 5000 is a placeholder"}), 8);
  EXPECT_EQ(NotesWith(notes, {"velocity limit 20 is a placeholder"}), 8);
  EXPECT_EQ(NotesWith(NotesOfLoaded(FourLegs()), {"placeholder"}), 0);
}

TEST(DerivationNotes, MotorsOfATransmissionWithoutLimitsAreNamed) {
  const std::vector<std::string> notes = NotesOfLoaded(FourLegs(),
                                                       "transmissions: [{name: t, joints: [A_hip, A_knee], motors: "
                                                       "[{name: m1, ratios: [1, 1], effort_nm: 5}, {name: m2, "
                                                       "ratios: [1, -1], velocity_rad_s: 3}]}]");
  EXPECT_EQ(NotesWith(notes, {"'A_hip', 'A_knee'", "transmission 't'"}), 1);
  EXPECT_EQ(NotesWith(notes, {"'m1'", "speed limit is unknown"}), 1);
  EXPECT_EQ(NotesWith(notes, {"'m1'", "effort limit is unknown"}), 0);
  EXPECT_EQ(NotesWith(notes, {"'m2'", "effort limit is unknown"}), 1);
}

TEST(DerivationNotes, ASoleGiveWithoutSolesHasNoEffect) {
  RobotYaml yaml;
  yaml.sole_give_m = 0.003;
  const std::string text = "'sole_give_m'";
  EXPECT_EQ(NotesWith(DerivationNotes(yaml, *LoadRobotFromText(FourLegs(), "")), {text, "no effect"}), 1);
  EXPECT_EQ(NotesWith(DerivationNotes(yaml, Made(SixJoints())), {text}), 0);
}

}  // namespace
}  // namespace gaitwright
