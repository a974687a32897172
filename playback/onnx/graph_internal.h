// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gaitwright::onnx {

using Dims = std::vector<std::int64_t>;

/// Product of the sizes. @throws InvalidArgument for a negative size or more than `most` elements.
std::int64_t CountOf(const Dims& dims, std::int64_t most);

/// "1 x 45", for messages; "a scalar" without sizes.
std::string DimsText(const Dims& dims);

/// A constant of the file. Elements of all types are kept as floats, in row-major order.
struct Tensor {
  std::string name;
  Dims dims;
  bool whole = false;  ///< whole numbers or truth values
  std::vector<float> numbers;
};

struct Attribute {
  float number = 0.0F;
  std::int64_t whole = 0;
  std::string text;
  std::optional<Tensor> tensor;
  std::vector<float> numbers;
  std::vector<std::int64_t> wholes;
};

/// An operation of the graph.
struct Node {
  std::string op, name;
  std::vector<std::string> inputs, outputs;
  std::map<std::string, Attribute> attributes;

  /// "node 'Gemm_0' (Gemm)", for messages.
  std::string Text() const;
};

/// An input or output of the graph. A symbolic size is -1.
struct Port {
  std::string name;
  bool is_float = true;
  std::optional<Dims> dims;  ///< nothing if the file does not give it
};

/// The parts of an ONNX file that an evaluation needs.
struct Graph {
  std::vector<Node> nodes;
  std::vector<Tensor> constants;
  std::vector<Port> inputs, outputs;         ///< inputs without those that are constants
  std::int64_t opset = 0;                    ///< version of the default set of operators
  std::map<std::string, std::string> notes;  ///< `metadata_props`, by key
};

/// Reads an ONNX file; the format is onnx.proto of https://github.com/onnx/onnx. Only the fields above are read.
/// @throws InvalidArgument for a malformed file, a tensor outside the file, an unsupported type of elements, or a file
/// beyond the limits: 100,000 nodes, 10,000 constants, 16,000,000 elements in one constant, 64 dimensions.
Graph ReadGraph(std::string_view file);

}  // namespace gaitwright::onnx
