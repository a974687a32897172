// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/numpy.h>

#include <map>
#include <string>
#include <vector>

#include "kinematics/spatial/pose.h"

namespace gaitwright::python {

/// A table in NumPy's order: row-major.
using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A table of truth values, row-major.
using TruthMatrix = Eigen::Matrix<bool, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Vectors of one size as the rows of a table.
template <class Vector>
RowMatrix Rows(const std::vector<Vector>& vectors) {
  RowMatrix rows(static_cast<Eigen::Index>(vectors.size()), vectors.empty() ? 0 : vectors.front().size());
  for (Eigen::Index k = 0; k < rows.rows(); ++k) rows.row(k) = vectors[static_cast<std::size_t>(k)].transpose();
  return rows;
}

/// Tables of an object that never changes. Each table is made on first use and then shared with Python as a read-only
/// array.
class Tables {
 public:
  /// @param owner  the object that Python keeps alive as long as it has the array.
  /// @param make   makes the table.
  template <class Make>
  pybind11::array Get(const pybind11::object& owner, const std::string& name, const Make& make) const {
    const RowMatrix& table = MadeIn(tables_, name, make);
    return Shared({table.rows(), table.cols()}, table.data(), owner);
  }
  /// As Of, for a table of truth values.
  template <class Make>
  pybind11::array GetTruths(const pybind11::object& owner, const std::string& name, const Make& make) const {
    const TruthMatrix& table = MadeIn(truths_, name, make);
    return Shared({table.rows(), table.cols()}, table.data(), owner);
  }
  /// As Of, for one column, as an array of one dimension.
  template <class Make>
  pybind11::array GetColumn(const pybind11::object& owner, const std::string& name, const Make& make) const {
    const RowMatrix& table = MadeIn(tables_, name, make);
    return Shared({table.size()}, table.data(), owner);
  }

 private:
  template <class Table, class Make>
  static const Table& MadeIn(std::map<std::string, Table>& tables, const std::string& name, const Make& make) {
    const auto known = tables.find(name);
    return known != tables.end() ? known->second : tables.emplace(name, make()).first->second;
  }

  template <class Number>
  static pybind11::array Shared(const std::vector<Eigen::Index>& shape, const Number* data,
                                const pybind11::object& owner) {
    pybind11::array_t<Number> array(shape, data, owner);
    array.attr("flags").attr("writeable") = false;
    return array;
  }

  mutable std::map<std::string, RowMatrix> tables_;
  mutable std::map<std::string, TruthMatrix> truths_;
};

/// Ground forces as an array of rows x feet x axes (W), shared like the other tables.
/// @param wrenches_at  the wrenches of the feet in a row; each row has the same number.
template <class WrenchesAt>
pybind11::array ForceTable(const Tables& tables, const pybind11::object& owner, std::size_t rows,
                           const WrenchesAt& wrenches_at) {
  const std::size_t feet = rows == 0 ? 0 : wrenches_at(0).size();
  const pybind11::array flat = tables.Get(owner, "forces_n", [&] {
    RowMatrix table(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(3 * feet));
    for (std::size_t row = 0; row < rows; ++row)
      for (std::size_t foot = 0; foot < feet; ++foot)
        table.block<1, 3>(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(3 * foot)) =
            wrenches_at(row)[foot].force_W.transpose();
    return table;
  });
  return flat.attr("reshape")(rows, feet, 3);
}

}  // namespace gaitwright::python
