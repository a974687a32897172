// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/base/result.h"
#include "playback/onnx/compile_internal.h"
#include "tests/playback/onnx/written_network.h"

namespace gaitwright::onnx {
namespace {

std::string CompileMessage(const written::File& file) {
  const Result<Network> network = Network::Read(file.Text(), "n");
  return network ? "" : network.failure().message;
}

TEST(CompileTest, BroadcastsAsNumPyDoes) {
  EXPECT_EQ(BroadcastDims({2, 1}, {3}), (Dims{2, 3}));
  EXPECT_EQ(BroadcastDims({}, {4, 5}), (Dims{4, 5}));
  EXPECT_THROW(BroadcastDims({2}, {3}), InvalidArgument);
  const Value column{{2, 1}, 10, 2};
  EXPECT_EQ(BroadcastPlaces(column, {2, 3}), (std::vector<std::int64_t>{10, 10, 10, 11, 11, 11}));
}

TEST(CompileTest, EvaluatesConstantsWhenTheFileIsRead) {
  written::File file;
  file.inputs = 1;
  file.constants = {written::Floats("c", {1}, {2.0F})};
  file.nodes = {written::Node("Mul", {"c", "c"}, {"d"}), written::Node("Add", {"obs", "d"}, {"action"})};
  const Graph graph = ReadGraph(file.Text());
  const Compiler compiled(graph);
  EXPECT_EQ(compiled.kernels.size(), 1U);
  EXPECT_EQ(written::Evaluated(written::NetworkOf(file.Text()), Eigen::VectorXf::Ones(1))[0], 5.0F);
}

TEST(CompileTest, RefusesNodesWithoutInputsOrInTheWrongOrder) {
  written::File file;
  file.nodes = {written::Node("Relu", {"later"}, {"action"}), written::Node("Relu", {"obs"}, {"later"})};
  EXPECT_EQ(CompileMessage(file), "network 'n': node 'the_Relu' (Relu): no earlier node gives its input 'later'");
  file.nodes = {written::Node("Relu", {}, {"action"})};
  EXPECT_EQ(CompileMessage(file), "network 'n': node 'the_Relu' (Relu): input 1 is missing");
  file.nodes = {written::Node("Relu", {"obs"}, {"obs"})};
  EXPECT_EQ(CompileMessage(file), "network 'n': node 'the_Relu' (Relu): its output 'obs' already has a value");
}

TEST(CompileTest, BoundsMemoryAndWork) {
  written::File file;
  file.inputs = 4000;
  file.constants = {written::Wholes("shape", {4000, 4000})};
  file.nodes = {written::Node("Expand", {"obs", "shape"}, {"m"}), written::Node("Gemm", {"m", "m"}, {"action"})};
  EXPECT_NE(CompileMessage(file).find("needs more than"), std::string::npos);
}

}  // namespace
}  // namespace gaitwright::onnx
