// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/numpy.h>

#include <map>
#include <string>
#include <vector>

#include "kinematics/spatial/pose.h"

namespace gaitwright::python {

/// A table as NumPy has it: a row after the other.
using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Vectors of one size as the rows of a table.
template <class Vector>
RowMatrix Rows(const std::vector<Vector>& vectors) {
  RowMatrix rows(static_cast<Eigen::Index>(vectors.size()), vectors.empty() ? 0 : vectors.front().size());
  for (Eigen::Index k = 0; k < rows.rows(); ++k) rows.row(k) = vectors[static_cast<std::size_t>(k)].transpose();
  return rows;
}

/// Tables of an object that never changes, each made when it is first asked for and then shared with Python, which may
/// not write to it.
class Tables {
 public:
  /// @param owner  what Python keeps alive for as long as it has the array.
  /// @param make   makes the table.
  template <class Make>
  pybind11::array Get(const pybind11::object& owner, const std::string& name, const Make& make) const {
    const auto [known, is_new] = tables_.try_emplace(name);
    if (is_new) known->second = make();
    const RowMatrix& table = known->second;
    return Shared({table.rows(), table.cols()}, table.data(), owner);
  }
  /// The same of one column, as an array of one dimension.
  template <class Make>
  pybind11::array GetColumn(const pybind11::object& owner, const std::string& name, const Make& make) const {
    const auto [known, is_new] = tables_.try_emplace(name);
    if (is_new) known->second = make();
    return Shared({known->second.size()}, known->second.data(), owner);
  }

 private:
  static pybind11::array Shared(const std::vector<Eigen::Index>& shape, const double* data,
                                const pybind11::object& owner) {
    pybind11::array_t<double> array(shape, data, owner);
    array.attr("flags").attr("writeable") = false;
    return array;
  }

  mutable std::map<std::string, RowMatrix> tables_;
};

}  // namespace gaitwright::python
