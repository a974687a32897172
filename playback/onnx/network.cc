// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "playback/onnx/compile_internal.h"
#include "playback/onnx/network_internal.h"

namespace gaitwright {
namespace {

std::string CountedOperators(const onnx::Graph& graph) {
  std::map<std::string, int> counts;
  for (const onnx::Node& node : graph.nodes) ++counts[node.op];
  std::string text;
  for (const auto& [name, count] : counts) text += fmt::format("{}{} x {}", text.empty() ? "" : ", ", name, count);
  return text;
}

}  // namespace

Result<Network> Network::Read(const std::string& file, const std::string& source) {
  try {
    const onnx::Graph graph = onnx::ReadGraph(file);
    onnx::Compiler compiled(graph);
    Network network;
    network.image_ = std::move(compiled.memory);
    network.kernels_ = std::move(compiled.kernels);
    network.input_ = {compiled.input.place, compiled.input.count};
    network.output_ = {compiled.output.place, compiled.output.count};
    network.parameters_ = compiled.parameters;
    network.operators_ = CountedOperators(graph);
    network.notes_ = graph.notes;
    return network;
  } catch (const InvalidArgument& error) {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kUnreadable,
                   "ReadNetwork",
                   fmt::format("network '{}': {}", source, error.what()),
                   {"docs/policies.md lists the supported operators"}};
  }
}

void Network::Evaluate(const Eigen::VectorXf& input, NetworkScratch& scratch, Eigen::VectorXf& output) const {
  float* memory = scratch.memory.data();
  std::copy(input.data(), input.data() + input.size(), memory + input_.first);
  for (const auto& kernel : kernels_) kernel->Run(memory);
  std::copy(memory + output_.first, memory + output_.first + output_.second, output.data());
}

}  // namespace gaitwright
