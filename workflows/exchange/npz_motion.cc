// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "kinematics/base/options.h"
#include "kinematics/dynamics/dynamics.h"
#include "workflows/exchange/csv_table.h"
#include "workflows/exchange/frame_motion_internal.h"
#include "workflows/exchange/npy_array_internal.h"
#include "workflows/exchange/npz_motion_internal.h"
#include "workflows/exchange/read_motion_internal.h"
#include "workflows/exchange/read_zip_internal.h"

namespace gaitwright {
namespace {

constexpr std::size_t kMostNpzBytes = std::size_t{1} << 30U;  // unpacked

std::string ShapeOf(const NpyArray& array) { return fmt::format("({})", fmt::join(array.shape, ", ")); }

/// The arrays of a file; those that were asked for count as used.
class NpzArrays {
 public:
  explicit NpzArrays(const std::string& bytes) {
    for (const ZipEntry& entry : ReadZip(bytes, kMostNpzBytes)) {
      constexpr std::string_view kEnding = ".npy";
      if (!entry.name.ends_with(kEnding)) continue;
      const std::string name = entry.name.substr(0, entry.name.size() - kEnding.size());
      try {
        arrays_.emplace(name, ParseNpy(entry.bytes));
      } catch (const InvalidArgument& error) {
        refused_.emplace(name, error.what());
      }
    }
  }

  bool Has(const std::string& name) const { return arrays_.count(name) > 0 || refused_.count(name) > 0; }

  const NpyArray& At(const std::string& name) {
    used_.insert(name);
    if (const auto refused = refused_.find(name); refused != refused_.end())
      throw InvalidArgument(fmt::format("array '{}': {}", name, refused->second));
    return arrays_.at(name);
  }

  /// An array of finite numbers with rows; `width` 0: any.
  const NpyArray& Rows(const std::string& name, std::size_t rows, std::size_t width) {
    const NpyArray& array = At(name);
    const bool fits =
        !array.has_texts && !array.shape.empty() && array.rows() == rows && (width == 0 || array.width() == width);
    if (!fits) {
      throw InvalidArgument(fmt::format("array '{}' has shape {}; needed: {} rows of {}numbers", name, ShapeOf(array),
                                        rows, width == 0 ? "" : fmt::format("{} ", width)));
    }
    const auto bad =
        std::find_if(array.numbers.begin(), array.numbers.end(), [](double x) { return !std::isfinite(x); });
    if (bad != array.numbers.end())
      throw InvalidArgument(fmt::format("array '{}' has a value that is not finite", name));
    return array;
  }

  std::vector<std::string> Unused() const {
    std::vector<std::string> names;
    for (const auto& [name, array] : arrays_) {
      if (used_.count(name) == 0) names.push_back(name);
    }
    for (const auto& [name, why] : refused_) {
      if (used_.count(name) == 0) names.push_back(name);
    }
    return names;
  }
  std::string Names() const {
    std::vector<std::string> names;
    for (const auto& [name, array] : arrays_) names.push_back(name);
    for (const auto& [name, why] : refused_) names.push_back(name);
    return names.empty() ? "none" : QuotedList(names);
  }

 private:
  std::map<std::string, NpyArray> arrays_;
  std::map<std::string, std::string> refused_;  // why, by name
  std::set<std::string> used_;
};

class NpzReader {
 public:
  NpzReader(const RobotModel& model, NpzArrays& arrays, const ImportOptions& options)
      : model_(model), arrays_(arrays), options_(options) {}

  MotionTable Run() {
    const std::string joints = arrays_.Has("joint_pos") ? "joint_pos" : arrays_.Has("dof_pos") ? "dof_pos" : "";
    if (!joints.empty()) {
      ReadFrames(joints);
    } else if (arrays_.Has("q") && arrays_.Has("time_s")) {
      ReadOwn();
    } else {
      throw InvalidArgument(
          fmt::format("its arrays are {}; needed: joint_pos with body_pos_w and body_quat_w, dof_pos with root_pos and "
                      "root_rot, or the arrays that 'export --format npz' writes",
                      arrays_.Names()));
    }
    table_.unused_columns = arrays_.Unused();
    return std::move(table_);
  }

 private:
  double LengthUnit() const { return options_.length_unit == "mm" ? 1e-3 : 1.0; }

  static Vector3 Triple(const NpyArray& array, std::size_t row) {
    const double* const at = array.numbers.data() + row * array.width();
    return {at[0], at[1], at[2]};
  }
  /// @param w_first  of the file. @return x y z w.
  static Eigen::Vector4d Turn(const NpyArray& array, std::size_t row, bool w_first) {
    const double* const at = array.numbers.data() + row * array.width();
    return w_first ? Eigen::Vector4d(at[1], at[2], at[3], at[0]) : Eigen::Vector4d(at[0], at[1], at[2], at[3]);
  }

  void SetTimes(std::size_t rows) {
    double rate_hz = options_.rate_hz;
    const bool known = arrays_.Has("fps");
    if (known) {
      const NpyArray& fps = arrays_.At("fps");
      if (fps.has_texts || fps.numbers.size() != 1 || !(fps.numbers[0] > 0.0) || !std::isfinite(fps.numbers[0]))
        throw InvalidArgument("array 'fps' must be one number above zero");
      rate_hz = fps.numbers[0];
    }
    for (std::size_t row = 0; row < rows; ++row) table_.time_s.push_back(static_cast<double>(row) / rate_hz);
    table_.derived.push_back({"times", fmt::format("{:.6g} frames a second ({})", rate_hz, known ? "fps" : "rate_hz")});
  }

  void ReadFrames(const std::string& joints) {
    table_.format = MotionFormat::kFramesNpz;
    const std::size_t n = model_.dof_names.size();
    const std::size_t rows = arrays_.At(joints).rows();
    if (rows > static_cast<std::size_t>(kMostCsvRows))
      throw InvalidArgument(fmt::format("it has {} frames; at most {} are read", rows, kMostCsvRows));
    const NpyArray& q = arrays_.Rows(joints, rows, n);
    SetTimes(rows);
    const bool bodies = arrays_.Has("body_pos_w") && arrays_.Has("body_quat_w");
    const char *const place = bodies ? "body_pos_w" : "root_pos", *const turn = bodies ? "body_quat_w" : "root_rot";
    for (const char* const name : {place, turn}) {
      if (!arrays_.Has(name)) {
        throw InvalidArgument(fmt::format("array '{}' is missing; the arrays are {}", name, arrays_.Names()));
      }
    }
    const NpyArray &p = arrays_.Rows(place, rows, bodies ? 0 : 3), &R = arrays_.Rows(turn, rows, bodies ? 0 : 4);
    if (p.width() < 3 || p.width() % 3 != 0 || R.width() < 4 || R.width() % 4 != 0)
      throw InvalidArgument(fmt::format("arrays '{}' and '{}' need 3 and 4 numbers for each body", place, turn));
    // Arrays of bodies have w first. The order of a root's is checked later, unless it is set.
    const bool w_first = bodies || options_.quaternion_order == "wxyz";
    for (std::size_t row = 0; row < rows; ++row) {
      table_.base_m.emplace_back(LengthUnit() * Triple(p, row));
      table_.quaternion.push_back(Turn(R, row, w_first));
    }
    SetJoints(q, OrderOf(q, bodies && p.width() >= 9 ? &p : nullptr));
  }

  void SetJoints(const NpyArray& q, const std::vector<std::string>& order) {
    std::vector<std::pair<int, double>> places;  // dof and unit, by column
    for (const std::string& name : order) {
      const int dof = model_.DofIndex(name);
      const double turning = options_.angle_unit == "deg" ? std::numbers::pi / 180.0 : 1.0;
      places.emplace_back(dof, model_.LeaderOf(dof).is_prismatic() ? LengthUnit() : turning);
    }
    table_.q.clear();
    for (std::size_t row = 0; row < table_.time_s.size(); ++row) {
      VectorX one(model_.num_dofs());
      for (std::size_t i = 0; i < places.size(); ++i)
        one[places[i].first] = places[i].second * q.numbers[row * places.size() + i];
      table_.q.push_back(std::move(one));
    }
  }

  /// Joint names by column.
  std::vector<std::string> OrderOf(const NpyArray& q, const NpyArray* bodies_m) {
    const char* const how = bodies_m != nullptr ? "the order in which the bodies are where the file says" : "";
    std::vector<std::string> order = DescribedJointOrder(model_);
    if (arrays_.Has("joint_names")) {
      order = NamedOrder();
      table_.derived.push_back({"columns", "joints by the file's joint_names"});
      return order;
    }
    std::string which = "in the order of the robot's description";
    if (const std::vector<std::string> other = BreadthFirstJointOrder(model_); bodies_m != nullptr && other != order) {
      const double off_m = DistanceOfBodies(q, *bodies_m, order), other_off_m = DistanceOfBodies(q, *bodies_m, other);
      if (other_off_m < off_m) {
        order = other;
        which = "breadth first";
      }
      which += fmt::format(" ({}: {:.1f} mm off, in the other order {:.1f} mm)", how,
                           1e3 * std::min(off_m, other_off_m), 1e3 * std::max(off_m, other_off_m));
    }
    table_.derived.push_back({"columns", fmt::format("{} joints {}: {}", order.size(), which, fmt::join(order, ", "))});
    return order;
  }

  std::vector<std::string> NamedOrder() {
    const NpyArray& names = arrays_.At("joint_names");
    if (!names.has_texts || names.texts.size() != model_.dof_names.size()) {
      throw InvalidArgument(fmt::format("array 'joint_names' must have {} texts, one for each joint of robot '{}'",
                                        model_.dof_names.size(), model_.name));
    }
    std::set<int> known;
    for (const std::string& name : names.texts) {
      if (!known.insert(model_.DofIndex(name)).second)
        throw InvalidArgument(fmt::format("array 'joint_names' has '{}' twice", name));
    }
    return names.texts;
  }

  /// Mean distance of the file's bodies from the nearest link, over some frames.
  double DistanceOfBodies(const NpyArray& q, const NpyArray& bodies_m, const std::vector<std::string>& order) {
    constexpr std::size_t kFrames = 20;
    SetJoints(q, order);
    DynamicsScratch scratch(model_);
    const std::size_t rows = table_.q.size(), step = std::max<std::size_t>(1, rows / kFrames);
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t row = 0; row < rows; row += step) {
      VectorX full(model_.nq());
      full << table_.base_m[row], table_.quaternion[row], table_.q[row];
      ForwardKinematics(model_, full, scratch);
      for (std::size_t at = 0; at < bodies_m.width(); at += 3, ++count) {
        const double* const p = bodies_m.numbers.data() + row * bodies_m.width() + at;
        const Vector3 p_W = LengthUnit() * Vector3(p[0], p[1], p[2]);
        double nearest = std::numeric_limits<double>::infinity();
        for (const Vector3& p_WB : scratch.p_WB) nearest = std::min(nearest, (p_WB - p_W).norm());
        sum += nearest;
      }
    }
    return count == 0 ? 0.0 : sum / static_cast<double>(count);
  }

  void ReadOwn() {
    table_.format = MotionFormat::kNpz;
    const NpyArray& times = arrays_.At("time_s");
    const std::size_t rows = times.rows(), n = model_.dof_names.size();
    if (rows > static_cast<std::size_t>(kMostCsvRows))
      throw InvalidArgument(fmt::format("it has {} rows; at most {} are read", rows, kMostCsvRows));
    table_.time_s = arrays_.Rows("time_s", rows, 1).numbers;
    for (double& time_s : table_.time_s) time_s *= options_.time_unit_s();
    for (std::size_t row = 1; row < rows; ++row) {
      if (!(table_.time_s[row] > table_.time_s[row - 1])) throw InvalidArgument("the times of 'time_s' do not rise");
    }
    const std::vector<std::string> order = arrays_.Has("joint_names") ? NamedOrder() : model_.dof_names;
    std::vector<int> dofs;
    for (const std::string& name : order) dofs.push_back(model_.DofIndex(name));
    const auto joints = [&](const double* from) {
      VectorX one(model_.num_dofs());
      for (std::size_t i = 0; i < n; ++i) one[dofs[i]] = from[i];
      return one;
    };
    const NpyArray& q = arrays_.Rows("q", rows, 7 + n);
    for (std::size_t row = 0; row < rows; ++row) {
      const double* const at = q.numbers.data() + row * q.width();
      table_.base_m.emplace_back(at[0], at[1], at[2]);
      table_.quaternion.emplace_back(at[3], at[4], at[5], at[6]);
      table_.q.push_back(joints(at + 7));
    }
    const auto rates = [&](const char* name, std::vector<Vector6>& of_base, std::vector<VectorX>& of_joints) {
      if (!arrays_.Has(name)) return;
      const NpyArray& array = arrays_.Rows(name, rows, 6 + n);
      for (std::size_t row = 0; row < rows; ++row) {
        const double* const at = array.numbers.data() + row * array.width();
        of_base.emplace_back(Eigen::Map<const Vector6>(at));
        of_joints.push_back(joints(at + 6));
      }
    };
    rates("v", table_.base_rate, table_.v);
    rates("a", table_.base_acceleration, table_.a);
    if (arrays_.Has("tau")) {
      const NpyArray& array = arrays_.Rows("tau", rows, n);
      for (std::size_t row = 0; row < rows; ++row) table_.tau.push_back(joints(array.numbers.data() + row * n));
    }
    ReadContacts(rows);
  }

  void ReadContacts(std::size_t rows) {
    if (!arrays_.Has("contact")) return;
    const std::size_t feet = model_.feet.size();
    const NpyArray& array = arrays_.Rows("contact", rows, feet);
    for (const char* const unused : {"foot_names", "robot"}) {
      if (arrays_.Has(unused)) arrays_.At(unused);
    }
    for (std::size_t row = 0; row < rows; ++row) {
      FootSet contact = 0;
      for (std::size_t f = 0; f < feet; ++f) {
        if (array.numbers[row * feet + f] > 0.5) contact |= FootBit(static_cast<int>(f));
      }
      table_.contact.push_back(contact);
    }
    if (!arrays_.Has("contact_wrench")) return;
    const NpyArray& wrenches = arrays_.Rows("contact_wrench", rows, 6 * feet);
    for (std::size_t row = 0; row < rows; ++row) {
      std::vector<Vector3> forces_W;
      for (std::size_t f = 0; f < feet; ++f)
        forces_W.emplace_back(Eigen::Map<const Vector3>(wrenches.numbers.data() + 6 * (row * feet + f)));
      table_.force_W.push_back(std::move(forces_W));
    }
  }

  const RobotModel& model_;
  NpzArrays& arrays_;
  const ImportOptions& options_;
  MotionTable table_;
};

}  // namespace

std::vector<std::string> BreadthFirstJointOrder(const RobotModel& model) {
  std::map<std::string, std::size_t> place;
  for (const std::string& name : DescribedJointOrder(model)) place.emplace(name, place.size());
  std::vector<std::string> order;
  std::vector<int> level{0};
  while (!level.empty()) {
    std::vector<int> next;
    for (const int body : level) {
      std::vector<int> children;
      for (int j = 0; j < static_cast<int>(model.joints.size()); ++j) {
        if (model.joints[static_cast<std::size_t>(j)].parent_body == body) children.push_back(j);
      }
      const auto rank = [&](int j) {
        const auto found = place.find(model.joints[static_cast<std::size_t>(j)].name);
        return found == place.end() ? place.size() : found->second;
      };
      std::stable_sort(children.begin(), children.end(), [&](int a, int b) { return rank(a) < rank(b); });
      for (const int j : children) {
        const std::string& name = model.joints[static_cast<std::size_t>(j)].name;
        if (place.count(name) > 0) order.push_back(name);
        next.push_back(j + 1);
      }
    }
    level = std::move(next);
  }
  return order;
}

Result<MotionTable> ParseNpzMotion(const RobotModel& model, const std::string& bytes, const std::string& source,
                                   const ImportOptions& options) {
  try {
    NpzArrays arrays(bytes);
    return NpzReader(model, arrays, options).Run();
  } catch (const InvalidArgument& error) {
    return RefusedMotion(source, error.what());
  }
}

}  // namespace gaitwright
