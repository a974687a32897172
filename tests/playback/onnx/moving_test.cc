// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/playback/onnx/written_network.h"

namespace gaitwright {
namespace {

using written::File;
using written::Node;
using written::WholeOf;
using written::Wholes;
using written::WholesOf;

std::vector<float> MovedBy(const File& file) {
  Eigen::VectorXf input(file.inputs);
  for (int i = 0; i < file.inputs; ++i) input[i] = static_cast<float>(i);
  const Eigen::VectorXf output = written::Evaluated(written::NetworkOf(file.Text()), input);
  return {output.data(), output.data() + output.size()};
}

std::string RefusalOf(const File& file) {
  const Result<Network> network = Network::Read(file.Text(), "n");
  return network ? "" : network.failure().message;
}

/// A file with the input 0, 1, 2, ... and one node of it.
File With(int inputs, const std::string& node, const std::vector<std::string>& constants = {}) {
  File file;
  file.inputs = inputs;
  file.nodes = {node};
  file.constants = constants;
  return file;
}

using Numbers = std::vector<float>;

TEST(MovingTest, SlicesAsPythonDoes) {
  const auto slice = [](std::int64_t from, std::int64_t to, std::int64_t step) {
    return MovedBy(With(6, Node("Slice", {"obs", "s", "e", "a", "t"}, {"action"}),
                        {Wholes("s", {from}), Wholes("e", {to}), Wholes("a", {1}), Wholes("t", {step})}));
  };
  EXPECT_EQ(slice(1, 4, 1), (Numbers{1, 2, 3}));
  EXPECT_EQ(slice(-2, 1000000000000, 1), (Numbers{4, 5}));
  EXPECT_EQ(slice(0, 6, 2), (Numbers{0, 2, 4}));
  EXPECT_EQ(slice(4, 1, -1), (Numbers{4, 3, 2}));
  EXPECT_EQ(slice(-1, -1000, -2), (Numbers{5, 3, 1}));
  EXPECT_EQ(slice(3, 3, 1), Numbers{});
}

TEST(MovingTest, SlicesByAttributesOfOldFiles) {
  EXPECT_EQ(MovedBy(With(4, Node("Slice", {"obs"}, {"action"},
                                 {WholesOf("starts", {1}), WholesOf("ends", {3}), WholesOf("axes", {1})}))),
            (Numbers{1, 2}));
}

TEST(MovingTest, JoinsAndSplits) {
  File file = With(4, Node("Split", {"obs"}, {"a", "b"}, {WholeOf("axis", 1), WholesOf("split", {1, 3})}));
  file.nodes.push_back(Node("Concat", {"b", "a", "b"}, {"action"}, {WholeOf("axis", -1)}));
  EXPECT_EQ(MovedBy(file), (Numbers{1, 2, 3, 0, 1, 2, 3}));
}

TEST(MovingTest, ReshapesTransposesAndFlattens) {
  File file = With(6, Node("Reshape", {"obs", "shape"}, {"m"}), {Wholes("shape", {2, -1})});
  file.nodes.push_back(Node("Transpose", {"m"}, {"t"}, {WholesOf("perm", {1, 0})}));
  file.nodes.push_back(Node("Flatten", {"t"}, {"action"}, {WholeOf("axis", 0)}));
  EXPECT_EQ(MovedBy(file), (Numbers{0, 3, 1, 4, 2, 5}));
}

TEST(MovingTest, FollowsAShapeThatIsComputed) {
  File file =
      With(6, Node("Shape", {"obs"}, {"dims"}), {Wholes("zero", {0}), Wholes("rest", {-1}), Wholes("axes", {0})});
  file.nodes.push_back(Node("Gather", {"dims", "zero"}, {"batch"}));
  file.nodes.push_back(Node("Concat", {"batch", "rest"}, {"shape"}, {WholeOf("axis", 0)}));
  file.nodes.push_back(Node("Reshape", {"obs", "shape"}, {"flat"}));
  file.nodes.push_back(Node("Unsqueeze", {"flat", "axes"}, {"deep"}));
  file.nodes.push_back(Node("Squeeze", {"deep", "axes"}, {"action"}));
  EXPECT_EQ(MovedBy(file), (Numbers{0, 1, 2, 3, 4, 5}));
}

TEST(MovingTest, GathersAndExpands) {
  File file = With(3, Node("Gather", {"obs", "i"}, {"g"}, {WholeOf("axis", 1)}),
                   {Wholes("i", {2, 0, -1}), Wholes("shape", {2, 3})});
  file.nodes.push_back(Node("Expand", {"g", "shape"}, {"action"}));
  EXPECT_EQ(MovedBy(file), (Numbers{2, 0, 2, 2, 0, 2}));
}

TEST(MovingTest, KeepsConstants) {
  File file = With(2, Node("Constant", {}, {"c"}, {written::TensorOf("value", written::Floats("", {2}, {5, 7}))}));
  file.nodes.push_back(Node("Add", {"obs", "c"}, {"action"}));
  EXPECT_EQ(MovedBy(file), (Numbers{5, 8}));
}

TEST(MovingTest, RefusesWhatDoesNotFit) {
  EXPECT_NE(RefusalOf(With(6, Node("Reshape", {"obs", "s"}, {"action"}), {Wholes("s", {4, -1})})).find("cannot become"),
            std::string::npos);
  EXPECT_NE(RefusalOf(With(6, Node("Reshape", {"obs", "obs"}, {"action"}))).find("is not constant"), std::string::npos);
  EXPECT_NE(RefusalOf(With(2, Node("Gather", {"obs", "i"}, {"action"}, {WholeOf("axis", 1)}), {Wholes("i", {2})}))
                .find("index 2 is outside of size 2"),
            std::string::npos);
  EXPECT_NE(RefusalOf(With(2, Node("Concat", {"obs"}, {"action"}, {WholeOf("axis", 5)}))).find("axis 5"),
            std::string::npos);
  EXPECT_NE(RefusalOf(With(2, Node("Split", {"obs"}, {"action", "b"}, {WholeOf("axis", 1), WholesOf("split", {1, 9})})))
                .find("do not fit"),
            std::string::npos);
}

}  // namespace
}  // namespace gaitwright
