// SPDX-License-Identifier: BSD-3-Clause
#include "tests/fuzz/motion_laws.h"

#include <cmath>

#include "tests/fuzz/plan_laws.h"
#include "workflows/exchange/check_motion_table.h"
#include "workflows/exchange/import_motion.h"
#include "workflows/walk/walk.h"

namespace gaitwright::fuzz {
namespace {

constexpr double kShort_s = 1.0;  // longer motions are not planned: they take too long for a million inputs

template <class Column>
void CheckLength(const MotionTable& table, const Column& column) {
  Require(column.empty() || column.size() == table.time_s.size(), "a column has a value for each row, or is empty");
}

/// Laws of each accepted table. Missing speeds and torques of joints are NaN.
void CheckTableLaws(const MotionTable& table) {
  Require(table.rows() > 0, "a motion has rows");
  for (std::size_t k = 0; k < table.time_s.size(); ++k) {
    Require(std::abs(table.time_s[k]) <= 1e11, "times are finite");
    Require(k == 0 || table.time_s[k] > table.time_s[k - 1], "times rise");
  }
  CheckLength(table, table.base_m), CheckLength(table, table.quaternion), CheckLength(table, table.q);
  CheckLength(table, table.v), CheckLength(table, table.a), CheckLength(table, table.tau);
  CheckLength(table, table.base_rate), CheckLength(table, table.base_acceleration);
  CheckLength(table, table.contact), CheckLength(table, table.force_W);
  for (const Vector3& p : table.base_m) Require(IsSensible(p), "places of the base are finite");
  for (const VectorX& q : table.q)
    Require(q.size() == Quadruped().num_dofs() && IsSensible(q), "positions of all joints are finite");
  for (const auto& columns : {table.v, table.a, table.tau}) {
    for (const VectorX& values : columns) {
      Require(values.size() == Quadruped().num_dofs(), "there is one value per joint");
      for (const double value : values)
        Require(std::isnan(value) || std::abs(value) <= kMostOfAnything, "rates and torques are finite");
    }
  }
  const FootSet all = AllFeet(static_cast<int>(Quadruped().feet.size()));
  for (const FootSet feet : table.contact) Require((feet & ~all) == 0, "feet in contact exist");
  for (const auto& forces : table.force_W) {
    for (const Vector3& force : forces) Require(IsSensible(force), "forces are finite");
  }
}

/// A short motion gives a valid plan, or is refused.
void CheckPlanOf(const MotionTable& table, const std::string& file) {
  if (table.time_s.back() - table.time_s.front() > kShort_s || table.rows() > 200) return;
  ImportRequest request;
  request.file = file;
  const Result<ImportedMotion> imported = ImportMotion(Quadruped(), request);
  if (imported) CheckPlanLaws(imported->plan);
}

}  // namespace

const RobotModel& Quadruped() {
  static const RobotModel model = *ChooseRobot("a1", "");
  return model;
}

bool IsSensible(const VectorX& values) { return values.allFinite() && values.cwiseAbs().maxCoeff() <= kMostOfAnything; }

Verdict CheckMotion(const Result<MotionTable>& read, const std::string& file) {
  if (!read) return Verdict::kRefused;
  const MotionTable& table = *read;
  try {
    CheckMotionTable(Quadruped(), FlatTerrain(), {}, table);
  } catch (const InvalidArgument&) {
    return Verdict::kRefused;
  }
  CheckTableLaws(table);
  for (const Eigen::Vector4d& c : table.quaternion)
    Require(std::abs(c.norm() - 1.0) < 0.02, "quaternions have length 1");
  CheckPlanOf(table, file);
  return Verdict::kAccepted;
}

}  // namespace gaitwright::fuzz
