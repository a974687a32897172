// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace gaitwright {

/// An array of NumPy: numbers or texts, row-major.
struct NpyArray {
  std::vector<std::size_t> shape;
  std::vector<double> numbers;
  std::vector<std::string> texts;  ///< in UTF-8; of arrays of texts only

  bool has_texts = false;
  /// Numbers of all axes but the first.
  std::size_t width() const;
  std::size_t rows() const { return shape.empty() ? 1 : shape.front(); }
};

/// Reads a `.npy` of version 1 to 3: integers, truth values, single and double floats in either byte order, texts
/// (`U`, `S`), in C or Fortran order. https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html
/// @throws InvalidArgument with the reason for others: Python objects are refused, because reading them runs code.
NpyArray ParseNpy(const std::string& bytes);

}  // namespace gaitwright
