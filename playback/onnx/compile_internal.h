// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "playback/onnx/graph_internal.h"
#include "playback/onnx/kernels_internal.h"

namespace gaitwright::onnx {

/// A value of the graph: its size and place in the memory.
struct Value {
  Dims dims;
  std::int64_t place = 0, count = 0;
  bool constant = false;
  bool whole = false;  ///< whole numbers, kept as floats
};

/// Turns the nodes of a graph into kernels on one memory.
class Compiler {
 public:
  /// @throws InvalidArgument for graphs without exactly one input and one output of floats of known sizes, and naming
  /// the node for what is not supported.
  explicit Compiler(const Graph& graph);

  std::vector<float> memory;  ///< constants and zeros
  std::vector<std::shared_ptr<const Kernel>> kernels;
  Value input, output;
  std::int64_t parameters = 0;

  // For the operators:

  /// An input of a node; inputs at the end may be left out. @throws InvalidArgument if it is missing.
  const Value& In(const Node& node, std::size_t index) const;
  bool Has(const Node& node, std::size_t index) const;
  /// The numbers of an input that must be constant.
  std::vector<std::int64_t> WholesOf(const Node& node, std::size_t index) const;
  float NumberOf(const Node& node, std::size_t index) const;
  /// Makes an output of a node, which is constant if all inputs are.
  Value& Out(const Node& node, const Dims& dims, bool whole, std::size_t index = 0);
  /// Counts operations of one evaluation, which are bounded.
  void Spend(std::int64_t operations);
  /// Runs the kernel now if the output is constant, else in each evaluation.
  void Do(const Value& out, std::shared_ptr<const Kernel> kernel);

 private:
  std::int64_t Room(const Dims& dims, std::int64_t& count);
  void AddConstant(const Tensor& tensor);
  void AddInput(const Port& port);
  void AddNode(const Node& node);

  std::map<std::string, Value> values_;
  std::int64_t work_ = 0;
};

using Operator = void (*)(Compiler& c, const Node& node);

/// All operators by name.
const std::map<std::string, Operator>& Operators();

// Groups of operators.
void AddElementwiseOperators(std::map<std::string, Operator>& operators);
void AddProductOperators(std::map<std::string, Operator>& operators);
void AddMovingOperators(std::map<std::string, Operator>& operators);

/// Size of the result of broadcasting. @throws InvalidArgument if the sizes do not fit.
Dims BroadcastDims(const Dims& a, const Dims& b);
/// Places of the elements of a value that is broadcast to a size, in row-major order.
std::vector<std::int64_t> BroadcastPlaces(const Value& value, const Dims& dims);

/// Attributes of a node, with defaults. @throws InvalidArgument for those that are not known.
float FloatAttribute(const Node& node, const std::string& name, float otherwise);
std::int64_t WholeAttribute(const Node& node, const std::string& name, std::int64_t otherwise);
void AcceptAttributes(const Node& node, const std::vector<std::string>& names);

/// An axis, counted from the end if negative. @throws InvalidArgument unless it is less than `rank`.
std::size_t AxisOf(std::int64_t axis, std::size_t rank);

}  // namespace gaitwright::onnx
