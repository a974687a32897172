// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tests/workflows/repair/standing_motion.h"
#include "workflows/exchange/export_frames_internal.h"
#include "workflows/exchange/export_npz.h"
#include "workflows/exchange/npz_motion_internal.h"
#include "workflows/exchange/read_zip_internal.h"
#include "workflows/exchange/stored_zip.h"

namespace gaitwright {
namespace {

/// A robot that moves its base and all its joints, each by another amount.
MotionRows Moving(const RobotModel& model) {
  MotionRows rows;
  for (int k = 0; k < 30; ++k) {
    rows.time_s.push_back(0.02 * k);
    VectorX q = StandingConfiguration(model);
    q[0] += 0.01 * k;
    q.segment<4>(3) = Quaternion(Eigen::AngleAxisd(0.02 * k, Vector3(0.6, 0.0, 0.8))).coeffs();
    for (int d = 0; d < model.num_dofs(); ++d) q[7 + d] += 0.001 * (d + 1) * k;
    rows.q.push_back(q);
    rows.v.push_back(VectorX::LinSpaced(model.nv(), -1.0, 1.0));
  }
  return rows;
}

void ExpectMotion(const MotionTable& table, const MotionRows& rows, double tolerance) {
  ASSERT_EQ(table.time_s.size(), rows.time_s.size());
  for (std::size_t k = 0; k < rows.q.size(); ++k) {
    EXPECT_NEAR(table.time_s[k], rows.time_s[k], 1e-9);
    EXPECT_LT((table.base_m[k] - rows.q[k].head<3>()).norm(), tolerance);
    EXPECT_LT((table.quaternion[k] - rows.q[k].segment<4>(3)).norm(), tolerance);
    EXPECT_LT((table.q[k] - rows.q[k].tail(table.q[k].size())).norm(), tolerance);
  }
}

/// Arrays of a motion by name, to be changed and packed.
class Packed {
 public:
  std::string Zip() const {
    std::vector<ZipEntry> entries;
    for (const auto& [name, bytes] : arrays) entries.push_back({name + ".npy", bytes});
    return StoredZip(entries);
  }
  std::map<std::string, std::string> arrays;
};

/// Arrays of frames with the joints in an order.
Packed Frames(const MotionRows& rows, const RobotModel& model, const std::vector<std::string>& order) {
  std::vector<double> q, p, R;
  for (const VectorX& row : rows.q) {
    for (const std::string& name : order) q.push_back(row[7 + model.DofIndex(name)]);
    for (Eigen::Index i = 0; i < 3; ++i) p.push_back(row[i]);
    for (Eigen::Index i = 3; i < 7; ++i) R.push_back(row[i]);
  }
  Packed packed;
  packed.arrays = {{"fps", NpyOfNumbers({50.0}, {1})},
                   {"dof_pos", NpyOfNumbers(q, {rows.q.size(), order.size()})},
                   {"root_pos", NpyOfNumbers(p, {rows.q.size(), 3})},
                   {"root_rot", NpyOfNumbers(R, {rows.q.size(), 4})}};
  return packed;
}

std::string ReasonNoMotion(const RobotModel& model, const Packed& packed) {
  const auto read = ParseNpzMotion(model, packed.Zip(), "a.npz", {});
  return read.ok() ? "" : read.failure().message;
}

TEST(NpzMotion, ReadsRootAndJointsInTheDescribedOrder) {
  for (const char* name : {"a1", "h1"}) {
    const RobotModel& model = NamedRobot(name);
    const MotionRows rows = Moving(model);
    const auto read = ParseNpzMotion(model, Frames(rows, model, DescribedJointOrder(model)).Zip(), "a.npz", {});
    ASSERT_TRUE(read.ok()) << read.failure().message;
    EXPECT_EQ(read->format, MotionFormat::kFramesNpz);
    ExpectMotion(*read, rows, 1e-12);
  }
}

TEST(NpzMotion, NamesInTheFileDecideTheOrder) {
  const RobotModel& model = NamedRobot("h1");
  const MotionRows rows = Moving(model);
  std::vector<std::string> order = DescribedJointOrder(model);
  std::reverse(order.begin(), order.end());
  Packed packed = Frames(rows, model, order);
  packed.arrays["joint_names"] = NpyOfTexts(order);
  const auto read = ParseNpzMotion(model, packed.Zip(), "a.npz", {});
  ASSERT_TRUE(read.ok()) << read.failure().message;
  ExpectMotion(*read, rows, 1e-12);
  order[1] = order[0];
  packed.arrays["joint_names"] = NpyOfTexts(order);
  EXPECT_NE(ReasonNoMotion(model, packed).find("' twice"), std::string::npos);
  order[1] = "left_kneee_joint";
  packed.arrays["joint_names"] = NpyOfTexts(order);
  EXPECT_NE(ReasonNoMotion(model, packed).find("left_kneee_joint"), std::string::npos);
}

TEST(NpzMotion, BodiesTellTheOrderOfTheJoints) {
  const RobotModel& model = NamedRobot("h1");
  ASSERT_NE(DescribedJointOrder(model), BreadthFirstJointOrder(model)) << "nothing to tell";
  const MotionRows rows = Moving(model);
  const std::string zip = FramesNpz(model, rows, 50.0);
  const auto described = ParseNpzMotion(model, zip, "a.npz", {});
  ASSERT_TRUE(described.ok()) << described.failure().message;
  ExpectMotion(*described, rows, 1e-9);
  EXPECT_EQ(described->unused_columns,
            (std::vector<std::string>{"body_ang_vel_w", "body_lin_vel_w", "body_names", "joint_vel"}));
  for (const bool breadth_first : {false, true}) {
    const auto order = breadth_first ? BreadthFirstJointOrder(model) : DescribedJointOrder(model);
    Packed packed = Frames(rows, model, order);
    packed.arrays["joint_pos"] = packed.arrays["dof_pos"];
    for (const char* const gone : {"dof_pos", "root_pos", "root_rot"}) packed.arrays.erase(gone);
    for (const ZipEntry& entry : ReadZip(zip, 1U << 24U)) {
      if (entry.name.starts_with("body_")) packed.arrays[entry.name.substr(0, entry.name.size() - 4)] = entry.bytes;
    }
    const auto read = ParseNpzMotion(model, packed.Zip(), "a.npz", {});
    ASSERT_TRUE(read.ok()) << read.failure().message;
    ExpectMotion(*read, rows, 1e-9);
    const auto how = std::find_if(read->derived.begin(), read->derived.end(),
                                  [](const DerivedPart& part) { return part.what == "columns"; });
    ASSERT_NE(how, read->derived.end());
    EXPECT_NE(how->how.find(breadth_first ? "breadth first" : "in the order of the robot's description"),
              std::string::npos)
        << how->how;
  }
}

TEST(NpzMotion, BreadthFirstGoesLevelByLevel) {
  const std::vector<std::string> order = BreadthFirstJointOrder(NamedRobot("a1"));
  ASSERT_EQ(order.size(), 12U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NE(order[i].find("hip"), std::string::npos);
    EXPECT_NE(order[4 + i].find("thigh"), std::string::npos);
    EXPECT_NE(order[8 + i].find("calf"), std::string::npos);
    EXPECT_EQ(order[i].substr(0, 2), order[8 + i].substr(0, 2)) << "legs keep their order";
  }
}

TEST(NpzMotion, ReadsWhatExportWrites) {
  const RobotModel& model = NamedRobot("a1");
  MotionRows rows = Moving(model);
  rows.tau.assign(rows.q.size(), VectorX::Constant(model.num_dofs(), 3.0));
  rows.contact.assign(rows.q.size(), FootBit(1) | FootBit(2));
  const auto read = ParseNpzMotion(model, MotionNpz(model, rows), "a.npz", {});
  ASSERT_TRUE(read.ok()) << read.failure().message;
  EXPECT_EQ(read->format, MotionFormat::kNpz);
  ExpectMotion(*read, rows, 1e-15);
  EXPECT_EQ(read->tau, rows.tau);
  EXPECT_EQ(read->contact, rows.contact);
  EXPECT_EQ(read->base_rate[3], Vector6(rows.v[3].head<6>()));
  EXPECT_EQ(read->v[3], VectorX(rows.v[3].tail(model.num_dofs())));
}

TEST(NpzMotion, SaysWhatIsMissingOrWrong) {
  const RobotModel& model = NamedRobot("a1");
  const Packed good = Frames(Moving(model), model, DescribedJointOrder(model));
  EXPECT_EQ(ReasonNoMotion(model, good), "");
  Packed bad = good;
  bad.arrays.erase("root_rot");
  EXPECT_NE(ReasonNoMotion(model, bad).find("array 'root_rot' is missing"), std::string::npos);
  bad = good;
  bad.arrays.erase("dof_pos");
  EXPECT_NE(ReasonNoMotion(model, bad).find("its arrays are 'fps', 'root_pos', 'root_rot'"), std::string::npos)
      << ReasonNoMotion(model, bad);
  bad = good;
  bad.arrays["fps"] = NpyOfNumbers({0.0}, {1});
  EXPECT_NE(ReasonNoMotion(model, bad).find("'fps' must be one number above zero"), std::string::npos);
  bad = good;
  bad.arrays["root_pos"] = NpyOfNumbers({0.0, 1.0, 2.0}, {1, 3});
  EXPECT_NE(ReasonNoMotion(model, bad).find("array 'root_pos' has shape (1, 3); needed: 30 rows of 3 numbers"),
            std::string::npos)
      << ReasonNoMotion(model, bad);
  EXPECT_NE(ReasonNoMotion(NamedRobot("h1"), good).find("needed: 30 rows of 19 numbers"), std::string::npos);
  const auto read = ParseNpzMotion(model, "no archive", "a.npz", {});
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.failure().message, "'a.npz': it is not a ZIP archive, or is cut off");
}

}  // namespace
}  // namespace gaitwright
