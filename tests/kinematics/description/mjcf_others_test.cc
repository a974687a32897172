// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/description/mjcf_others_internal.h"
#include "tests/kinematics/description/mjcf_texts.h"

namespace gaitwright {
namespace {

const MjcfFiles kNoOtherFiles;

/// The notes about the elements below <mujoco>.
std::vector<std::string> NotesOf(const std::string& sections) {
  MjcfContext context("<mujoco>\n" + sections + "</mujoco>", kNoOtherFiles, "model.xml");
  NoteMjcfOthers(context);
  return context.notes;
}

/// Expects a note for each row, in this order.
void ExpectNotes(const std::string& sections, const std::vector<std::vector<std::string>>& rows) {
  const std::vector<std::string> notes = NotesOf(sections);
  ASSERT_EQ(notes.size(), rows.size()) << sections << (notes.empty() ? "" : notes.front());
  for (std::size_t i = 0; i < rows.size(); ++i) ExpectSays(notes[i], rows[i]);
}

TEST(MjcfOthers, KnownSectionsAndAttributesAreNotNoted) {
  ExpectNotes(
      "<size njmax='5'/><visual/><statistic/><option timestep='0.001' gravity='0 0 -9.81'/><sensor/><custom/>"
      "<compiler angle='radian' texturedir='t' assetdir='m'/><worldbody><geom size='1' rgba='1 1 1 1' solref='1 1'/>"
      "<body name='b' user='1'><joint name='j' user='1' group='2'/></body></worldbody>",
      {});
}

TEST(MjcfOthers, UnknownAttributesAreNotedWhereverTheyStandWithTheNearest) {
  ExpectNotes(
      "<compiler angel='radian'/>\n<worldbody>\n<body nmae='b'>\n<frame><joint axsi='0 0 "
      "1'/></frame></body></worldbody>"
      "<default><default class='c'><geom denisty='1'/></default></default>",
      {{"line 2: <compiler>", "'angel'", "'angle'"},
       {"line 4: <body>", "'nmae'", "'name'"},
       {"line 5: <joint>", "'axsi'", "'axis'"},
       {"<geom>", "'denisty'", "'density'"}});
}

TEST(MjcfOthers, UnknownSectionsAreNoted) {
  ExpectNotes("<actuators/>", {{"line 2: <actuators>", "'actuator'"}});
  ExpectNotes("<quite_another/>", {{"<quite_another>", "unknown; it is ignored"}});
}

TEST(MjcfOthers, GravityThatDiffersIsNotedAndTheUsualOnesAreNot) {
  for (const char* usual : {"0 0 -9.81", "0 0 -9.80665", "0 0 -9.8"})
    EXPECT_TRUE(NotesOf("<option gravity='" + std::string(usual) + "'/>").empty()) << usual;
  for (const char* other : {"0 0 0", "0 0 -1.62", "0 -9.81 0", "0 0 9.81", "0.5 0 -9.81"})
    EXPECT_EQ(NotesOf("<option gravity='" + std::string(other) + "'/>").size(), 1U) << other;
}

TEST(MjcfOthers, TheMediumAndWhatIsSwitchedOffAreNoted) {
  ExpectNotes(
      "<option wind='1 0 0' density='1.2' viscosity='0'><flag contact='disable' gravity='enable' limit='disable'"
      "/></option>",
      {{"<option>", "wind"}, {"<option>", "'density'"}, {"<flag>", "'limit'"}, {"<flag>", "'contact'"}});
}

TEST(MjcfOthers, ContactsAndTendonsAreNotedByTheirNames) {
  ExpectNotes(
      "<contact>\n<exclude body1='a' body2='b'/>\n<pair geom1='g'/></contact><tendon><spatial name='t'/></tendon>"
      "<deformable><skin name='s'/></deformable>",
      {{"line 3: <exclude>", "'a' and 'b'"},
       {"line 4: <pair>", "'g' and ''"},
       {"spatial 't'", "tendon"},
       {"skin 's'", "deformable"}});
}

TEST(MjcfOthers, NotesEndAtAThousandAndOne) {
  std::string sections;
  for (int i = 0; i < 1500; ++i) sections += "<other/>";
  const std::vector<std::string> notes = NotesOf(sections);
  ASSERT_EQ(notes.size(), kMostMjcfNotes + 1);
  ExpectSays(notes[kMostMjcfNotes - 1], {"<other>"});
  EXPECT_EQ(notes.back().find("<other>"), std::string::npos);
}

}  // namespace
}  // namespace gaitwright
