// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/motion_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "kinematics/base/nearest_name.h"
#include "kinematics/base/non_finite.h"
#include "kinematics/base/text.h"
#include "kinematics/spatial/rotation.h"
#include "workflows/exchange/column_target.h"

namespace gaitwright {
namespace {

/// A column of the file and its meaning.
struct Source {
  int column = -1;
  double scale = 1.0;
};

/// Maps the columns of a file to the quantities of a motion.
class Mapper {
 public:
  Mapper(const RobotModel& model, const CsvTable& table, const ColumnNames& names, const ImportOptions& options)
      : model_(model),
        table_(table),
        names_(names),
        options_(options),
        targets_(ColumnTargets(model, options)),
        position_(model.joints.size()),
        velocity_(model.joints.size()),
        acceleration_(model.joints.size()),
        torque_(model.joints.size()),
        contact_(model.feet.size()),
        force_(3 * model.feet.size()) {}

  MotionTable Run() {
    CheckNames();
    for (int c = 0; c < table_.num_columns(); ++c) Place(c);
    motion_.format = MotionFormat::kCsv;
    TakeTime();
    TakeBase();
    TakeJoints();
    TakeFeet();
    return std::move(motion_);
  }

 private:
  std::vector<std::string> KnownNames() const {
    std::vector<std::string> known;
    for (const auto& [name, target] : targets_) known.push_back(name);
    return known;
  }

  /// Checks that every name in the column-names file is a known name and a column of the table.
  void CheckNames() const {
    for (const auto& [theirs, ours] : names_.ours) {
      if (targets_.count(ours) == 0) {
        throw InvalidArgument(fmt::format("column '{}' is mapped to '{}', which is not a known name{}", theirs, ours,
                                          NearestHint(ours, KnownNames())));
      }
    }
    for (const auto& [theirs, ours] : names_.ours) RequireColumn(theirs, "take as '" + ours + "'");
    for (const auto& [theirs, scale] : names_.scale) RequireColumn(theirs, "scale");
    for (const std::string& theirs : names_.ignored) RequireColumn(theirs, "ignore");
  }

  void RequireColumn(const std::string& theirs, const std::string& use) const {
    const std::vector<std::string>& other = names_.elsewhere;
    if (names_.may_lack || table_.Find(theirs) >= 0) return;
    if (std::find(other.begin(), other.end(), theirs) != other.end()) return;
    throw InvalidArgument(
        fmt::format("there is no column '{}' to {}{}", theirs, use, NearestOrAll(theirs, table_.columns)));
  }

  void Place(int column) {
    const std::string& theirs = table_.columns[static_cast<std::size_t>(column)];
    if (std::find(names_.ignored.begin(), names_.ignored.end(), theirs) != names_.ignored.end()) {
      motion_.unused_columns.push_back(theirs);
      return;
    }
    const auto renamed = names_.ours.find(theirs);
    const std::string& name = renamed == names_.ours.end() ? theirs : renamed->second;
    const auto known = targets_.find(name);
    if (known == targets_.end()) {
      if (LooksLikeOurs(name)) {
        throw InvalidArgument(fmt::format("column {} '{}' is unknown for robot '{}'{}", column + 1, name, model_.name,
                                          NearestHint(name, KnownNames())));
      }
      motion_.unused_columns.push_back(theirs);
      return;
    }
    const auto scale = names_.scale.find(theirs);
    const ColumnTarget& target = known->second;
    const double factor = scale == names_.scale.end() ? target.scale : scale->second;
    Source& source = SourceOf(target);
    if (source.column >= 0) {
      throw InvalidArgument(fmt::format("columns '{}' and '{}' both are {}",
                                        table_.columns[static_cast<std::size_t>(source.column)], theirs, name));
    }
    source = {column, factor};
  }

  Source& SourceOf(const ColumnTarget& target) {
    const auto i = static_cast<std::size_t>(target.index);
    switch (target.kind) {
      case ColumnKind::kTime:
        return time_;
      case ColumnKind::kBasePosition:
        return base_[i];
      case ColumnKind::kQuaternion:
        return quaternion_[i];
      case ColumnKind::kEuler:
        return euler_[i];
      case ColumnKind::kBaseRate:
        return base_rate_[i];
      case ColumnKind::kBaseAcceleration:
        return base_acceleration_[i];
      case ColumnKind::kPosition:
        return position_[i];
      case ColumnKind::kVelocity:
        return velocity_[i];
      case ColumnKind::kAcceleration:
        return acceleration_[i];
      case ColumnKind::kTorque:
        return torque_[i];
      case ColumnKind::kContact:
        return contact_[i];
      default:
        return force_[i];
    }
  }

  double Value(int row, const Source& source) const { return source.scale * table_.At(row, source.column); }

  /// The column that probably contains the times, or empty.
  std::string LikelyTime() const {
    constexpr std::size_t kLong = 8;  // longest name that may be a misspelt "time_s"
    for (const std::string& name : table_.columns) {
      const std::string lower = LowerCase(name);
      if (lower.find("time") != std::string::npos || lower.find("stamp") != std::string::npos) return name;
    }
    const std::string nearest = NearestName("time_s", table_.columns);
    return nearest.starts_with("t") && nearest.size() <= kLong ? nearest : "";
  }

  void TakeTime() {
    if (time_.column < 0) {
      const std::string likely = LikelyTime();
      throw InvalidArgument(fmt::format("has no time column: 'time_s' is needed{}",
                                        likely.empty() ? ", or 'time' or 't'; no column has a similar name"
                                                       : fmt::format("; the nearest to it is '{}'", likely)));
    }
    for (int row = 0; row < table_.rows(); ++row) {
      motion_.time_s.push_back(Value(row, time_));
      if (row > 0 &&
          !(motion_.time_s[static_cast<std::size_t>(row)] > motion_.time_s[static_cast<std::size_t>(row) - 1])) {
        throw InvalidArgument(fmt::format(
            "{}: {:.9g} does not come after {:.9g} in the previous row; times must increase",
            table_.Place(row, time_.column), table_.At(row, time_.column), table_.At(row - 1, time_.column)));
      }
    }
  }

  /// Whether all columns of a group are present; an incomplete group is refused.
  bool AllOrNone(const std::vector<Source>& sources, const std::vector<std::string>& names) const {
    std::vector<std::string> there, missing;
    for (std::size_t i = 0; i < sources.size(); ++i) (sources[i].column < 0 ? missing : there).push_back(names[i]);
    if (there.empty() || missing.empty()) return missing.empty();
    throw InvalidArgument(fmt::format("has {} but lacks {}; all of them are needed, or none",
                                      QuotedList({there.front()}), QuotedList(missing)));
  }

  /// The quaternion in the order x y z w, for any order of the four columns.
  Eigen::Vector4d QuaternionOf(int row) const {
    Eigen::Vector4d c;
    for (int i = 0; i < 4; ++i) c[i] = Value(row, quaternion_[static_cast<std::size_t>(i)]);
    return options_.quaternion_order == "wxyz" ? Eigen::Vector4d(c[1], c[2], c[3], c[0]) : c;
  }

  /// The six rates of the base; an incomplete set is not used.
  std::vector<Vector6> SixOf(const std::vector<Source>& sources) {
    std::vector<Vector6> rows;
    const bool all = std::all_of(sources.begin(), sources.end(), [](const Source& s) { return s.column >= 0; });
    for (const Source& source : sources) {
      if (!all && source.column >= 0)
        motion_.unused_columns.push_back(table_.columns[static_cast<std::size_t>(source.column)]);
    }
    for (int row = 0; all && row < table_.rows(); ++row) {
      Vector6 six;
      for (int i = 0; i < 6; ++i) six[i] = Value(row, sources[static_cast<std::size_t>(i)]);
      rows.push_back(six);
    }
    return rows;
  }

  void TakeBase() {
    motion_.base_rate = SixOf(base_rate_);
    motion_.base_acceleration = SixOf(base_acceleration_);
    const bool placed = AllOrNone(base_, {"base_x_m", "base_y_m", "base_z_m"});
    const bool turned = AllOrNone(quaternion_, {"base_qx", "base_qy", "base_qz", "base_qw"});
    const bool by_angles = AllOrNone(euler_, {"base_roll_rad", "base_pitch_rad", "base_yaw_rad"});
    if (turned && by_angles) throw InvalidArgument("has both a quaternion and angles of the base; give one of them");
    if (placed && !turned && !by_angles) {
      throw InvalidArgument(
          "has the position of the base but not its orientation: base_qx, base_qy, base_qz, base_qw are needed, or "
          "base_roll_rad, base_pitch_rad, base_yaw_rad; without position and orientation, the pose is derived");
    }
    motion_.turned_by_angles = by_angles;
    for (int row = 0; row < table_.rows(); ++row) {
      if (placed) motion_.base_m.emplace_back(Value(row, base_[0]), Value(row, base_[1]), Value(row, base_[2]));
      if (turned) {
        motion_.quaternion.push_back(QuaternionOf(row));
      } else if (by_angles) {
        const Matrix3 R = RotationExp(Value(row, euler_[2]) * Vector3::UnitZ()) *
                          RotationExp(Value(row, euler_[1]) * Vector3::UnitY()) *
                          RotationExp(Value(row, euler_[0]) * Vector3::UnitX());
        motion_.quaternion.push_back(Quaternion(R).coeffs());
      }
    }
  }

  /// The joint that defines a dof.
  std::size_t LeaderOf(int dof) const {
    return static_cast<std::size_t>(model_.dof_joint[static_cast<std::size_t>(dof)]);
  }

  /// A hint on unused columns that may be meant for a missing one.
  std::string LikelyFor(const std::string& missing) const {
    constexpr std::size_t kMostListed = 16;
    const std::vector<std::string>& unused = motion_.unused_columns;
    const std::string nearest = NearestName(missing, unused);
    if (!nearest.empty()) return fmt::format("; the nearest to the first of them is '{}'", nearest);
    return unused.empty() || unused.size() > kMostListed ? "" : "; columns that are not used: " + QuotedList(unused);
  }

  void TakeJoints() {
    std::vector<std::string> missing;
    for (int d = 0; d < model_.num_dofs(); ++d) {
      if (position_[LeaderOf(d)].column < 0) missing.push_back(PositionColumn(model_.joints[LeaderOf(d)]));
    }
    if (!missing.empty() && ((options_.missing_joints == "refuse" && !names_.some_joints) ||
                             missing.size() == static_cast<std::size_t>(model_.num_dofs()))) {
      throw InvalidArgument(fmt::format("lacks {} of {} joint positions of robot '{}': {}{}", missing.size(),
                                        model_.num_dofs(), model_.name, QuotedList(missing),
                                        LikelyFor(missing.front())));
    }
    const VectorX none = VectorX::Constant(model_.num_dofs(), kNaN);
    if (!missing.empty() && !names_.some_joints)
      motion_.derived.push_back({"position of " + QuotedList(missing), "as in the standing posture"});
    motion_.q = Rows(position_, names_.some_joints ? none : model_.standing_joints);
    if (Any(velocity_)) motion_.v = Rows(velocity_, none);
    if (Any(acceleration_)) motion_.a = Rows(acceleration_, none);
    if (Any(torque_)) motion_.tau = Rows(torque_, none);
    CheckMimics();
  }

  static bool Any(const std::vector<Source>& sources) {
    return std::any_of(sources.begin(), sources.end(), [](const Source& source) { return source.column >= 0; });
  }

  std::vector<VectorX> Rows(const std::vector<Source>& by_joint, const VectorX& otherwise) const {
    std::vector<VectorX> rows(static_cast<std::size_t>(table_.rows()), otherwise);
    for (int d = 0; d < model_.num_dofs(); ++d) {
      const Source& source = by_joint[LeaderOf(d)];
      if (source.column < 0) continue;
      for (int row = 0; row < table_.rows(); ++row) rows[static_cast<std::size_t>(row)][d] = Value(row, source);
    }
    return rows;
  }

  /// Checks that mimic joints in the file follow their leaders.
  void CheckMimics() const {
    constexpr double kSame = 1e-3;  // [rad], [m]
    for (std::size_t j = 0; j < model_.joints.size(); ++j) {
      const Joint& joint = model_.joints[j];
      if (!joint.is_mimic || position_[j].column < 0) continue;
      for (int row = 0; row < table_.rows(); ++row) {
        const double expected = joint.multiplier * motion_.q[static_cast<std::size_t>(row)][joint.dof] + joint.offset;
        const double value = Value(row, position_[j]);
        if (std::abs(value - expected) <= kSame) continue;
        throw InvalidArgument(fmt::format("{}: joint '{}' mimics '{}' and would be at {:.6g}, but the file has {:.6g}",
                                          table_.Place(row, position_[j].column), joint.name,
                                          model_.dof_names[static_cast<std::size_t>(joint.dof)], expected, value));
      }
    }
  }

  void TakeFeet() {
    std::vector<std::string> contacts, forces;
    for (const Foot& foot : model_.feet) {
      contacts.push_back("contact_" + foot.link);
      for (const char axis : {'x', 'y', 'z'}) forces.push_back(fmt::format("force_{}_{}_n", foot.link, axis));
    }
    const bool has_contacts = AllOrNone(contact_, contacts), has_forces = AllOrNone(force_, forces);
    for (int row = 0; row < table_.rows(); ++row) {
      if (has_contacts) {
        FootSet feet = 0;
        for (std::size_t f = 0; f < contact_.size(); ++f) {
          const double flag = Value(row, contact_[f]);
          if (flag != 0.0 && flag != 1.0) {
            throw InvalidArgument(
                fmt::format("{}: {:.6g} is neither 0 nor 1", table_.Place(row, contact_[f].column), flag));
          }
          if (flag == 1.0) feet |= FootBit(static_cast<int>(f));
        }
        motion_.contact.push_back(feet);
      }
      if (!has_forces) continue;
      std::vector<Vector3> of_row;
      for (std::size_t f = 0; f < model_.feet.size(); ++f)
        of_row.emplace_back(Value(row, force_[3 * f]), Value(row, force_[3 * f + 1]), Value(row, force_[3 * f + 2]));
      motion_.force_W.push_back(std::move(of_row));
    }
  }

  const RobotModel& model_;
  const CsvTable& table_;
  const ColumnNames& names_;
  const ImportOptions& options_;
  const std::map<std::string, ColumnTarget> targets_;
  Source time_;
  std::vector<Source> base_ = std::vector<Source>(3), quaternion_ = std::vector<Source>(4),
                      euler_ = std::vector<Source>(3);
  std::vector<Source> base_rate_ = std::vector<Source>(6), base_acceleration_ = std::vector<Source>(6);
  std::vector<Source> position_, velocity_, acceleration_, torque_, contact_, force_;
  MotionTable motion_;
};

}  // namespace

Result<MotionTable> MotionFromCsv(const RobotModel& model, const CsvTable& table, const ColumnNames& names,
                                  const ImportOptions& options) {
  try {
    return Mapper(model, table, names, options).Run();
  } catch (const InvalidArgument& error) {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kColumns,
                   "ImportMotion",
                   fmt::format("'{}': {}", table.source, error.what()),
                   {"docs/import.md lists the column names; --columns FILE maps other names"}};
  }
}

}  // namespace gaitwright
