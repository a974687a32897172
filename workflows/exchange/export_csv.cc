// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/export_csv.h"

#include <fmt/format.h>

#include <cmath>

#include "kinematics/base/result.h"
#include "kinematics/model/dof_units.h"
#include "workflows/exchange/number_text.h"

namespace gaitwright {
namespace {

/// Optional parts of a row.
struct Has {
  bool accelerations = true, torques = true, contacts = true;
};

std::vector<std::string> ColumnsOf(const RobotModel& model, const Has& has) {
  std::vector<std::string> names = {"time_s",  "base_x_m", "base_y_m", "base_z_m",
                                    "base_qx", "base_qy",  "base_qz",  "base_qw"};
  const auto by_joint = [&](const char* kind, const char* turning, const char* sliding) {
    for (int i = 0; i < model.num_dofs(); ++i) {
      names.push_back(fmt::format("{}_{}_{}", kind, model.dof_names[static_cast<std::size_t>(i)],
                                  Slides(model, i) ? sliding : turning));
    }
  };
  const auto by_axis = [&](const char* kind, const char* unit) {
    for (const char axis : {'x', 'y', 'z'}) names.push_back(fmt::format("base_{}{}_{}", kind, axis, unit));
  };
  by_joint("q", "rad", "m");
  by_joint("v", "rad_s", "m_s");
  by_axis("v", "m_s");
  by_axis("w", "rad_s");
  if (has.accelerations) {
    by_joint("a", "rad_s2", "m_s2");
    by_axis("a", "m_s2");
    by_axis("alpha", "rad_s2");
  }
  if (has.torques) by_joint("tau", "nm", "n");
  if (has.contacts) {
    for (const Foot& foot : model.feet) names.push_back("contact_" + foot.link);
  }
  return names;
}

/// A cell; in quotes if it contains a character that would end it.
std::string Cell(const std::string& name) {
  if (name.find_first_of(",;\t\"#\r\n ") == std::string::npos) return name;
  std::string quoted = "\"";
  for (const char c : name) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

/// Writes one line; keeps the column names for messages.
class RowWriter {
 public:
  RowWriter(std::string& text, const std::vector<std::string>& names) : text_(text), names_(names) {}

  void Add(double value) {
    if (!std::isfinite(value)) {
      throw InvalidArgument(
          fmt::format("column '{}' is {} at {} s; only finite numbers are exported", names_[column_], value, time_s_));
    }
    if (column_ == 0) time_s_ = value;
    if (column_ > 0) text_ += ',';
    AppendNumber(value, text_);
    ++column_;
  }
  template <class Values>
  void AddAll(const Values& values) {
    for (Eigen::Index i = 0; i < values.size(); ++i) Add(values[i]);
  }
  void End() {
    text_ += '\n';
    column_ = 0;
  }

 private:
  std::string& text_;
  const std::vector<std::string>& names_;
  std::size_t column_ = 0;
  double time_s_ = 0.0;
};

}  // namespace

std::vector<std::string> MotionCsvColumns(const RobotModel& model) { return ColumnsOf(model, {}); }

std::string MotionCsv(const RobotModel& model, const MotionRows& rows) {
  const Has has{!rows.a.empty(), !rows.tau.empty(), !rows.contact.empty()};
  const std::vector<std::string> names = ColumnsOf(model, has);
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) text += (i == 0 ? "" : ",") + Cell(names[i]);
  text += '\n';
  RowWriter line(text, names);
  for (std::size_t k = 0; k < rows.time_s.size(); ++k) {
    line.Add(rows.time_s[k]);
    line.AddAll(rows.q[k]);
    line.AddAll(rows.v[k].tail(model.num_dofs()));
    line.AddAll(rows.v[k].head<6>());
    if (has.accelerations) {
      line.AddAll(rows.a[k].tail(model.num_dofs()));
      line.AddAll(rows.a[k].head<6>());
    }
    if (has.torques) line.AddAll(rows.tau[k]);
    for (std::size_t f = 0; has.contacts && f < model.feet.size(); ++f)
      line.Add(Contains(rows.contact[k], static_cast<int>(f)) ? 1.0 : 0.0);
    line.End();
  }
  return text;
}

}  // namespace gaitwright
