// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/nearest_name.h"
#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "playback/onnx/compile_internal.h"

namespace gaitwright::onnx {
namespace {

constexpr std::int64_t kMostFloats = 16000000;
constexpr std::int64_t kMostWork = 1000000000;

std::string NamesOfPorts(const std::vector<Port>& ports) {
  std::vector<std::string> names;
  for (const Port& port : ports) names.push_back(port.name);
  return names.empty() ? "none" : QuotedList(names);
}

const Port& OnlyOne(const std::vector<Port>& ports, const char* what) {
  if (ports.size() != 1)
    throw InvalidArgument(
        fmt::format("the network has {} {}s ({}); exactly one is supported", ports.size(), what, NamesOfPorts(ports)));
  if (!ports.front().is_float)
    throw InvalidArgument(fmt::format("{} '{}' of the network is not of type float", what, ports.front().name));
  return ports.front();
}

}  // namespace

Compiler::Compiler(const Graph& graph) {
  const Port& in = OnlyOne(graph.inputs, "input");
  const Port& out = OnlyOne(graph.outputs, "output");
  for (const Tensor& tensor : graph.constants) AddConstant(tensor);
  parameters = static_cast<std::int64_t>(memory.size());
  AddInput(in);
  for (const Node& node : graph.nodes) AddNode(node);
  const auto made = values_.find(out.name);
  if (made == values_.end()) throw InvalidArgument(fmt::format("no node gives the network's output '{}'", out.name));
  output = made->second;
}

std::int64_t Compiler::Room(const Dims& dims, std::int64_t& count) {
  count = CountOf(dims, kMostFloats);
  const auto place = static_cast<std::int64_t>(memory.size());
  if (place + count > kMostFloats)
    throw InvalidArgument(fmt::format("the network needs more than {} floats of memory", kMostFloats));
  memory.resize(memory.size() + static_cast<std::size_t>(count), 0.0F);
  return place;
}

void Compiler::AddConstant(const Tensor& tensor) {
  Value value{tensor.dims, 0, 0, true, tensor.whole};
  value.place = Room(tensor.dims, value.count);
  std::copy(tensor.numbers.begin(), tensor.numbers.end(), memory.begin() + value.place);
  values_.insert_or_assign(tensor.name, std::move(value));
}

void Compiler::AddInput(const Port& port) {
  if (!port.dims)
    throw InvalidArgument(fmt::format("the size of the network's input '{}' is not in the file", port.name));
  Dims dims = *port.dims;
  if (!dims.empty() && dims.back() < 0)
    throw InvalidArgument(fmt::format(
        "the last size of the network's input '{}' is symbolic; export the network with its number of observations",
        port.name));
  for (std::int64_t& size : dims) size = size < 0 ? 1 : size;
  Value value{dims};
  value.place = Room(dims, value.count);
  if (value.count != (dims.empty() ? 1 : dims.back()))
    throw InvalidArgument(fmt::format("the network's input '{}' is of size {}; one observation is evaluated at a time",
                                      port.name, DimsText(dims)));
  values_.insert_or_assign(port.name, value);
  input = value;
}

void Compiler::AddNode(const Node& node) {
  const auto& operators = Operators();
  const auto found = operators.find(node.op);
  if (found == operators.end()) {
    std::vector<std::string> names;
    for (const auto& [name, function] : operators) names.push_back(name);
    throw InvalidArgument(
        fmt::format("{}: operator '{}' is not supported{}", node.Text(), node.op, NearestHint(node.op, names)));
  }
  try {
    found->second(*this, node);
  } catch (const InvalidArgument& error) {
    throw InvalidArgument(fmt::format("{}: {}", node.Text(), error.what()));
  }
}

bool Compiler::Has(const Node& node, std::size_t index) const {
  return index < node.inputs.size() && !node.inputs[index].empty();
}

const Value& Compiler::In(const Node& node, std::size_t index) const {
  if (!Has(node, index)) throw InvalidArgument(fmt::format("input {} is missing", index + 1));
  const auto found = values_.find(node.inputs[index]);
  if (found == values_.end())
    throw InvalidArgument(fmt::format("no earlier node gives its input '{}'", node.inputs[index]));
  return found->second;
}

std::vector<std::int64_t> Compiler::WholesOf(const Node& node, std::size_t index) const {
  constexpr float kFar = 1e15F;  // beyond any index; ends of slices may be the largest number
  constexpr std::int64_t kMostWholes = 1000000;
  const Value& value = In(node, index);
  if (!value.constant)
    throw InvalidArgument(fmt::format("its input '{}' is not constant, which is not supported", node.inputs[index]));
  if (value.count > kMostWholes) throw InvalidArgument(fmt::format("its input '{}' is too long", node.inputs[index]));
  std::vector<std::int64_t> wholes;
  for (std::int64_t i = 0; i < value.count; ++i) {
    const float number = memory[static_cast<std::size_t>(value.place + i)];
    if (!std::isfinite(number)) throw InvalidArgument(fmt::format("its input '{}' is not finite", node.inputs[index]));
    wholes.push_back(static_cast<std::int64_t>(std::clamp(number, -kFar, kFar)));
  }
  return wholes;
}

float Compiler::NumberOf(const Node& node, std::size_t index) const {
  const Value& value = In(node, index);
  if (!value.constant || value.count != 1)
    throw InvalidArgument(
        fmt::format("its input '{}' is not one constant, which is not supported", node.inputs[index]));
  return memory[static_cast<std::size_t>(value.place)];
}

Value& Compiler::Out(const Node& node, const Dims& dims, bool whole, std::size_t index) {
  if (index >= node.outputs.size()) throw InvalidArgument(fmt::format("output {} is missing", index + 1));
  Value value{dims, 0, 0, true, whole};
  for (std::size_t i = 0; i < node.inputs.size(); ++i)
    value.constant = value.constant && (!Has(node, i) || In(node, i).constant);
  if (values_.contains(node.outputs[index]))
    throw InvalidArgument(fmt::format("its output '{}' already has a value", node.outputs[index]));
  value.place = Room(dims, value.count);
  Spend(static_cast<std::int64_t>(dims.size() + 1) * value.count);
  return values_.insert_or_assign(node.outputs[index], std::move(value)).first->second;
}

void Compiler::Spend(std::int64_t operations) {
  work_ += std::min(operations, kMostWork + 1);
  if (work_ > kMostWork) throw InvalidArgument(fmt::format("an evaluation needs more than {} operations", kMostWork));
}

void Compiler::Do(const Value& out, std::shared_ptr<const Kernel> kernel) {
  if (out.constant) return kernel->Run(memory.data());
  kernels.push_back(std::move(kernel));
}

const std::map<std::string, Operator>& Operators() {
  static const std::map<std::string, Operator> operators = [] {
    std::map<std::string, Operator> all;
    AddElementwiseOperators(all);
    AddProductOperators(all);
    AddMovingOperators(all);
    return all;
  }();
  return operators;
}

Dims BroadcastDims(const Dims& a, const Dims& b) {
  Dims dims(std::max(a.size(), b.size()), 1);
  for (std::size_t i = 0; i < dims.size(); ++i) {
    const std::int64_t from_a = i < a.size() ? a[a.size() - 1 - i] : 1, from_b = i < b.size() ? b[b.size() - 1 - i] : 1;
    if (from_a != from_b && from_a != 1 && from_b != 1)
      throw InvalidArgument(fmt::format("sizes {} and {} do not fit each other", DimsText(a), DimsText(b)));
    dims[dims.size() - 1 - i] = from_a == 1 ? from_b : from_a;
  }
  return dims;
}

std::vector<std::int64_t> BroadcastPlaces(const Value& value, const Dims& dims) {
  if (BroadcastDims(value.dims, dims) != dims)
    throw InvalidArgument(fmt::format("size {} does not fit {}", DimsText(value.dims), DimsText(dims)));
  const std::size_t rank = dims.size();
  std::vector<std::int64_t> strides(rank, 0);
  std::int64_t stride = 1;
  for (std::size_t i = 0; i < value.dims.size(); ++i) {
    const std::int64_t size = value.dims[value.dims.size() - 1 - i];
    if (size != 1) strides[rank - 1 - i] = stride;
    stride *= size;
  }
  const std::int64_t count = CountOf(dims, kMostFloats);
  std::vector<std::int64_t> places(static_cast<std::size_t>(count), value.place);
  for (std::int64_t i = 0; i < count; ++i) {
    std::int64_t rest = i;
    for (std::size_t axis = rank; axis-- > 0;) {
      places[static_cast<std::size_t>(i)] += rest % dims[axis] * strides[axis];
      rest /= dims[axis];
    }
  }
  return places;
}

float FloatAttribute(const Node& node, const std::string& name, float otherwise) {
  const auto found = node.attributes.find(name);
  return found == node.attributes.end() ? otherwise : found->second.number;
}

std::int64_t WholeAttribute(const Node& node, const std::string& name, std::int64_t otherwise) {
  const auto found = node.attributes.find(name);
  return found == node.attributes.end() ? otherwise : found->second.whole;
}

void AcceptAttributes(const Node& node, const std::vector<std::string>& names) {
  for (const auto& [name, attribute] : node.attributes) {
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw InvalidArgument(fmt::format("attribute '{}' is not supported", name));
  }
}

std::size_t AxisOf(std::int64_t axis, std::size_t rank) {
  const auto most = static_cast<std::int64_t>(rank);
  if (axis < -most || axis >= most)
    throw InvalidArgument(fmt::format("axis {} does not exist in a value with {} dimensions", axis, rank));
  return static_cast<std::size_t>(axis < 0 ? axis + most : axis);
}

}  // namespace gaitwright::onnx
