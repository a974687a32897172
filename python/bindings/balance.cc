// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include "kinematics/base/non_finite.h"
#include "python/bindings/playback.h"

namespace gaitwright::python {
namespace {

namespace py = pybind11;

const Playback& In(const py::object& self) { return self.cast<const Playback&>(); }

/// A table in which `fill` writes the row of each sample. A row whose state is not finite is NaN.
template <class Fill>
RowMatrix SampleRows(const Playback& playback, Eigen::Index columns, const Fill& fill) {
  const std::vector<MotionSample>& samples = playback.series().measured;
  RowMatrix table = RowMatrix::Constant(static_cast<Eigen::Index>(playback.log().samples.size()), columns, kNaN);
  for (std::size_t k = 0; k < samples.size(); ++k) fill(samples[k], table.row(static_cast<Eigen::Index>(k)));
  return table;
}

/// A vector per sample, as a table that is shared with Python.
template <auto Member>
py::array Table(const py::object& self, const char* name) {
  const auto fill = [](const MotionSample& sample, auto row) { row = (sample.*Member).transpose(); };
  return In(self).tables().Get(self, name, [&] { return SampleRows(In(self), (MotionSample{}.*Member).size(), fill); });
}

py::array ZmpOf(const py::object& self) {
  const auto fill = [](const MotionSample& sample, auto row) {
    if (sample.has_zmp) row = sample.p_WZ.transpose();
  };
  return In(self).tables().Get(self, "zmp", [&] { return SampleRows(In(self), 2, fill); });
}

py::array ZmpMarginOf(const py::object& self) {
  const auto fill = [](const MotionSample& sample, auto row) {
    if (sample.has_zmp) row(0) = sample.zmp_margin_m();
  };
  return In(self).tables().GetColumn(self, "zmp_margin", [&] { return SampleRows(In(self), 1, fill); });
}

py::array FeetOf(const py::object& self) {
  const Playback& playback = In(self);
  const std::size_t feet = playback.plan().model().feet.size();
  const auto fill = [feet](const MotionSample& sample, auto row) {
    for (std::size_t foot = 0; foot < feet; ++foot)
      row.template segment<3>(static_cast<Eigen::Index>(3 * foot)) = sample.feet[foot].p_WF.transpose();
  };
  const py::array flat = playback.tables().Get(
      self, "feet", [&] { return SampleRows(playback, static_cast<Eigen::Index>(3 * feet), fill); });
  return flat.attr("reshape")(playback.log().samples.size(), feet, 3);
}

py::array ContactOf(const py::object& self) {
  const Playback& playback = In(self);
  return playback.tables().GetTruths(self, "contact", [&] {
    const std::vector<LogSample>& samples = playback.log().samples;
    TruthMatrix touches(static_cast<Eigen::Index>(samples.size()),
                        static_cast<Eigen::Index>(playback.plan().model().feet.size()));
    for (Eigen::Index k = 0; k < touches.rows(); ++k)
      for (int foot = 0; foot < touches.cols(); ++foot)
        touches(k, foot) = Contains(samples[static_cast<std::size_t>(k)].contact, foot);
    return touches;
  });
}

RowMatrix SupportAt(const Playback& playback, py::ssize_t row) {
  const auto rows = static_cast<py::ssize_t>(playback.log().samples.size());
  if (row < -rows || row >= rows) throw py::index_error(fmt::format("row {} of {}", row, rows));
  const auto k = static_cast<std::size_t>(row < 0 ? row + rows : row);
  const std::vector<MotionSample>& samples = playback.series().measured;
  return k < samples.size() && !samples[k].support.empty() ? Rows(samples[k].support.polygon) : RowMatrix(0, 2);
}

py::list StancesOf(const Playback& playback) {
  py::list list;
  for (const StanceRecord& stance : playback.log().stances) {
    py::dict one;
    one["foot"] = playback.plan().model().feet[static_cast<std::size_t>(stance.foot)].name;
    one["touchdown_s"] = stance.touchdown_s;
    one["liftoff_s"] = stance.liftoff_s;
    one["touchdown_m"] = py::cast(stance.p_touchdown_W);
    one["touchdown_speed_m_s"] = stance.touchdown_speed_m_s;
    one["slip_m"] = stance.slip_m;
    one["peak_normal_n"] = stance.peak_normal_n;
    one["penetration_m"] = stance.penetration_m;
    one["friction_use_max"] = stance.friction_use_max;
    list.append(one);
  }
  return list;
}

py::list BodyContactsOf(const Playback& playback) {
  py::list list;
  for (const BodyContact& contact : playback.log().body_contacts)
    list.append(py::make_tuple(contact.time_s, contact.link));
  return list;
}

}  // namespace

void BindBalance(py::class_<Playback>& playback) {
  playback
      .def_property_readonly(
          "centre_of_mass_m", [](const py::object& self) { return Table<&MotionSample::p_WC>(self, "centre_of_mass"); },
          "Measured positions in world axes, N x 3 [m].")
      .def_property_readonly(
          "centre_of_mass_velocity_m_s",
          [](const py::object& self) { return Table<&MotionSample::v_WC>(self, "centre_of_mass_velocity"); }, "N x 3.")
      .def_property_readonly(
          "dcm_m", [](const py::object& self) { return Table<&MotionSample::dcm_W>(self, "dcm"); },
          "Divergent component of motion c + c' / omega in plan view, N x 2.")
      .def_property_readonly("zmp_m", ZmpOf,
                             "Zero-moment point of the contacts, low-pass filtered as for the score, N x 2; NaN in "
                             "flight or if the support is not in one plane.")
      .def_property_readonly("zmp_margin_m", ZmpMarginOf,
                             "Distance of the ZMP to the edge of the support, N: positive inside; NaN in flight or if "
                             "the support is not in one plane.")
      .def_property_readonly("feet_m", FeetOf, "Origins of the feet's contact frames, N x feet x 3.")
      .def_property_readonly("contact", ContactOf, "Whether each foot touches the ground, N x feet.")
      .def("support", SupportAt, py::arg("row"),
           "Corners of the support polygon of a row in plan view, K x 2, counter-clockwise: of the feet that are "
           "scheduled to stand, at their measured places.")
      .def_property_readonly("stances", StancesOf,
                             "Stance phases in order of touch-down: foot, touchdown_s, liftoff_s, "
                             "touchdown_m (3), touchdown_speed_m_s, slip_m, peak_normal_n, penetration_m, "
                             "friction_use_max (1 at the cone's edge).")
      .def_property_readonly("body_contacts", BodyContactsOf,
                             "(time_s, link) of the first ground contact of each link that is not a foot.");
}

}  // namespace gaitwright::python
