// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/kinematics/allocations.h"
#include "tests/playback/onnx/written_network.h"

namespace gaitwright {
namespace {

using written::File;
using written::FloatOf;
using written::Floats;
using written::Node;
using written::WholeOf;

const Eigen::Vector3f kFactor(1.0F, -2.0F, 3.0F);

Eigen::VectorXf ProductOf(const File& file) { return written::Evaluated(written::NetworkOf(file.Text()), kFactor); }

TEST(ProductsTest, GemmHasItsFactorsAndTranspositions) {
  File file;
  file.inputs = 3;
  file.constants = {Floats("b", {3, 2}, {1, 2, 3, 4, 5, 6}), Floats("bt", {2, 3}, {1, 3, 5, 2, 4, 6}),
                    Floats("c", {2}, {10, 20})};
  file.nodes = {Node("Gemm", {"obs", "b", "c"}, {"action"}, {FloatOf("alpha", 2.0F), FloatOf("beta", 0.5F)})};
  const Eigen::Vector2f expected(2.0F * (1 - 6 + 15) + 5.0F, 2.0F * (2 - 8 + 18) + 10.0F);
  EXPECT_EQ(ProductOf(file), expected);
  file.nodes = {Node("Gemm", {"obs", "bt", "c"}, {"action"},
                     {FloatOf("alpha", 2.0F), FloatOf("beta", 0.5F), WholeOf("transB", 1)})};
  EXPECT_EQ(ProductOf(file), expected);
}

TEST(ProductsTest, ATransposedFirstFactorEqualsItsTranspose) {
  File file;
  file.inputs = 3;
  file.constants = {Floats("b", {1, 2}, {1, 10})};
  file.nodes = {Node("Gemm", {"obs", "b"}, {"action"}, {WholeOf("transA", 1)})};  // 3 x 1 times 1 x 2
  EXPECT_EQ(ProductOf(file), (Eigen::VectorXf(6) << 1, 10, -2, -20, 3, 30).finished());
}

TEST(ProductsTest, MatMulTakesVectorsAndMatrices) {
  File file;
  file.inputs = 3;
  file.constants = {Floats("b", {3, 2}, {1, 2, 3, 4, 5, 6}), Floats("v", {3}, {1, 1, 1})};
  file.nodes = {Node("MatMul", {"obs", "b"}, {"action"})};
  EXPECT_EQ(ProductOf(file), Eigen::Vector2f(10.0F, 12.0F));
  file.nodes = {Node("MatMul", {"obs", "v"}, {"action"})};
  EXPECT_EQ(ProductOf(file), Eigen::VectorXf::Constant(1, 2.0F));
}

TEST(ProductsTest, RefusesSizesThatDoNotFit) {
  File file;
  file.inputs = 3;
  file.constants = {Floats("b", {2, 2}, {1, 2, 3, 4})};
  file.nodes = {Node("MatMul", {"obs", "b"}, {"action"})};
  EXPECT_EQ(Network::Read(file.Text(), "n").failure().message,
            "network 'n': node 'the_MatMul' (MatMul): its factors are of sizes 1 x 3 and 2 x 2, which do not fit each "
            "other");
}

TEST(ProductsTest, AnEvaluationAllocatesNothing) {
  const int inputs = 480, hidden = 512, outputs = 29;
  const Network network = written::NetworkOf(
      written::DenseNetwork({{Eigen::MatrixXf::Constant(hidden, inputs, 1e-3F), Eigen::VectorXf::Ones(hidden)},
                             {Eigen::MatrixXf::Constant(outputs, hidden, 1e-3F), Eigen::VectorXf::Ones(outputs)}},
                            "Elu"));
  const Eigen::VectorXf input = Eigen::VectorXf::Ones(inputs);
  NetworkScratch scratch = network.MakeScratch();
  Eigen::VectorXf output(outputs);
  const long before = Allocations();
  network.Evaluate(input, scratch, output);
  EXPECT_EQ(Allocations(), before);
  EXPECT_NEAR(output[0], 1.0 + 512 * 1e-3 * 1.48, 1e-4);
}

}  // namespace
}  // namespace gaitwright
