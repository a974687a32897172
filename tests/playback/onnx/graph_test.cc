// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/base/result.h"
#include "playback/onnx/graph_internal.h"
#include "tests/playback/onnx/written_network.h"

namespace gaitwright::onnx {
namespace {

std::string GraphMessage(const std::string& file) {
  try {
    ReadGraph(file);
    return "";
  } catch (const InvalidArgument& error) {
    return error.what();
  }
}

written::File Small() {
  written::File file;
  file.inputs = 2;
  file.nodes = {written::Node("Add", {"obs", "c"}, {"action"})};
  file.constants = {written::Floats("c", {2}, {1.5F, -2.0F})};
  return file;
}

TEST(GraphTest, ReadsNodesConstantsAndPorts) {
  const Graph graph = ReadGraph(Small().Text());
  ASSERT_EQ(graph.nodes.size(), 1U);
  EXPECT_EQ(graph.nodes[0].Text(), "node 'the_Add' (Add)");
  EXPECT_EQ(graph.nodes[0].inputs, (std::vector<std::string>{"obs", "c"}));
  ASSERT_EQ(graph.constants.size(), 1U);
  EXPECT_EQ(graph.constants[0].numbers, (std::vector<float>{1.5F, -2.0F}));
  ASSERT_EQ(graph.inputs.size(), 1U);
  EXPECT_EQ(graph.inputs[0].dims, (Dims{1, 2}));
  EXPECT_EQ(graph.opset, 17);
}

TEST(GraphTest, AnInputThatIsAConstantIsNoInput) {
  written::File file = Small();
  file.constants.push_back(written::Floats("obs", {1, 2}, {0.0F, 0.0F}));
  EXPECT_TRUE(ReadGraph(file.Text()).inputs.empty());
}

TEST(GraphTest, RefusesConstantsOfAnotherSizeOrType) {
  written::File file = Small();
  file.constants = {written::Floats("c", {3}, {1.0F})};
  EXPECT_EQ(GraphMessage(file.Text()), "constant 'c' has 1 elements; its size 3 needs 3");
  file.constants = {written::WholeField(1, 1) + written::WholeField(2, 8) + written::BytesField(8, "c")};
  EXPECT_NE(GraphMessage(file.Text()).find("has elements of type 8"), std::string::npos);
  file.constants = {written::WholeField(1, 0) + written::WholeField(2, 1) + written::BytesField(8, "c") +
                    written::WholeField(14, 1)};
  EXPECT_NE(GraphMessage(file.Text()).find("is in another file"), std::string::npos);
}

TEST(GraphTest, RefusesControlFlowByTheNode) {
  written::File file = Small();
  file.nodes = {
      written::Node("If", {"obs"}, {"action"}, {written::BytesField(1, "then") + written::BytesField(6, "")})};
  EXPECT_EQ(GraphMessage(file.Text()),
            "node 'the_If' (If): a node contains a graph of its own (control flow), which is not "
            "supported");
}

TEST(GraphTest, CountsElementsWithoutOverflow) {
  EXPECT_EQ(CountOf({2, 3}, 100), 6);
  EXPECT_EQ(CountOf({}, 100), 1);
  EXPECT_EQ(CountOf({0, 7}, 100), 0);
  EXPECT_THROW(CountOf({1000000, 1000000, 1000000, 1000000}, 1000000), InvalidArgument);
  EXPECT_THROW(CountOf({0, 1000000, 1000000}, 1000000), InvalidArgument);
  EXPECT_THROW(CountOf({-1}, 100), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright::onnx
